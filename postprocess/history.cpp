#include "postprocess/history.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

#include "core/document.hpp"
#include "core/error.hpp"

namespace tektite {
namespace {

constexpr std::string_view column_of_words = "dt_reason";

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> cells;
  std::size_t begin = 0;
  while (true) {
    const auto comma = line.find(',', begin);
    cells.push_back(line.substr(begin, comma - begin));
    if (comma == std::string::npos) return cells;
    begin = comma + 1;
  }
}

double number(const std::string& cell, const Place& place, const std::string& column) {
  double value = 0.0;
  const auto* end = cell.data() + cell.size();
  const auto result = std::from_chars(cell.data(), end, value);
  if (result.ec != std::errc() || result.ptr != end || !std::isfinite(value))
    throw InputError({place, column, cell, "not a finite number", {}});
  return value;
}

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError({{path, 0}, {}, {}, "the history cannot be opened", {}});
  std::ostringstream content;
  content << file.rdbuf();
  return std::move(content).str();
}

}  // namespace

History History::read(const std::string& path) {
  auto content = content_of(path);
  content.resize(content.rfind('\n') + 1);  // npos + 1 = 0: without any line end there is no whole line
  std::istringstream lines(std::move(content));

  History history;
  history.path_ = path;
  std::string line;
  if (!std::getline(lines, line)) throw InputError({{path, 1}, {}, {}, "the history is empty", "a line of names"});
  const auto header = split(line);
  for (const auto& name : header) {
    if (name.empty() || history.has(name))
      throw InputError({{path, 1}, name, {}, "a name is empty or stands twice", {}});
    if (name == column_of_words) continue;
    history.names_.push_back(name);
    history.columns_[name];
  }
  for (int at = 2; std::getline(lines, line); ++at) {
    const auto cells = split(line);
    if (cells.size() != header.size())
      throw InputError({{path, at}, {}, {}, fmt::format("{} values under {} names", cells.size(), header.size()), {}});
    for (std::size_t k = 0; k < cells.size(); ++k)
      if (header[k] != column_of_words) history.columns_[header[k]].push_back(number(cells[k], {path, at}, header[k]));
    ++history.rows_;
  }
  if (!history.has("time")) throw InputError({{path, 1}, "time", {}, "this column is missing", {}});
  return history;
}

const std::vector<double>& History::column(const std::string& name) const {
  const auto found = columns_.find(name);
  if (found == columns_.end()) throw RunError(fmt::format("{} has no column {}; it has {}", path_, name, join(names_)));
  return found->second;
}

}  // namespace tektite
