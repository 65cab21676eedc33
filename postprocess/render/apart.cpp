#include "postprocess/render/apart.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

#include "core/wait_for.hpp"
#include "postprocess/render/display.hpp"

namespace tektite {
namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;
using Draw = std::function<void(const Tell&)>;

void draw_here(const Draw& draw, std::FILE* report) {
  const Tell tell = [&](const std::string& line) {
    std::fputs((line + '\n').c_str(), report);
    std::fflush(report);
  };
  try {
    const PrivateDisplay display;
    draw(tell);
  } catch (const std::exception& fault) {
    tell(fmt::format("warning: no pictures: {}; numbers and ParaView files are written", fault.what()));
  }
}

/// The text of a temporary file, line by line.
std::vector<std::string> lines_of(std::FILE* file) {
  std::rewind(file);
  std::string text;
  for (int c = std::fgetc(file); c != EOF; c = std::fgetc(file)) text.push_back(static_cast<char>(c));
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// What a child that draws has told, and what it complained of where it ended early.
struct Told {
  std::vector<std::string> lines;
  std::optional<std::string> complaint;
};

Told draw_in_child(const Draw& draw) {
  const File report(std::tmpfile(), std::fclose);
  const File complaints(std::tmpfile(), std::fclose);
  if (!report || !complaints) return {{"warning: no pictures: no temporary file can be made"}, std::nullopt};
  std::cout.flush();
  const auto child = fork();
  if (child < 0) return {{"warning: no pictures: no process can be started"}, std::nullopt};
  if (child == 0) {
    dup2(fileno(complaints.get()), STDERR_FILENO);
    draw_here(draw, report.get());
    _exit(0);
  }
  const int status = wait_for(child, "pictures");
  Told told{lines_of(report.get()), std::nullopt};
  if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return told;
  const auto said = lines_of(complaints.get());
  told.complaint = said.empty() ? std::string() : ": " + said.front();
  return told;
}

}  // namespace

std::vector<std::string> draw_apart(const Draw& draw) {
  auto told = draw_in_child(draw);
  if (told.complaint)
    told.lines.push_back("warning: the drawing ended early" + *told.complaint +
                         "; numbers and ParaView files are written");
  return told.lines;
}

}  // namespace tektite
