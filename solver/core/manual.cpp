#include "core/manual.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>

#include "core/version.hpp"

namespace tektite {
namespace {

namespace po = boost::program_options;

/// Text as roff shows it: no escapes, and no requests at the start of a line.
std::string plain(const std::string& text) {
  std::string roff;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const bool line_begins = k == 0 || text[k - 1] == '\n';
    if (line_begins && (text[k] == '.' || text[k] == '\'')) roff += "\\&";
    if (text[k] == '-') roff += '\\';
    roff += text[k];
    if (text[k] == '\\') roff += 'e';
  }
  return roff;
}

/// "-o, --output DIR"
std::string term(const po::option_description& option) {
  const auto brief = option.canonical_display_name(po::command_line_style::allow_dash_for_short);
  std::string term = brief.starts_with('-') ? brief + ", " : "";
  term += "--" + option.long_name();
  if (option.semantic()->max_tokens() > 0) term += ' ' + option.semantic()->name();
  return term;
}

/// Up to the first mark that ends a sentence or a part of one; a dot within a word, as in particles.h5, does not.
std::string first_part(const std::string& text) {
  std::size_t end = 0;
  const auto ends = [&] {
    if (text[end] == '\n') return true;
    const bool word_ends = end + 1 == text.size() || std::isspace(static_cast<unsigned char>(text[end + 1]));
    return word_ends && std::string_view(".;:").find(text[end]) != std::string_view::npos;
  };
  while (end < text.size() && !ends()) ++end;
  return text.substr(0, end);
}

std::string name_in(const std::string& usage) {
  std::istringstream words(usage);
  std::string name, word;
  const auto names = [](char c) { return std::islower(static_cast<unsigned char>(c)) || c == '-'; };
  while (words >> word && std::ranges::all_of(word, names)) name += name.empty() ? word : '-' + word;
  return name;
}

}  // namespace

Manual manual_of(const CommandLine& line) {
  Manual manual{name_in(line.usage), line.usage, line.about, "OPTIONS", {}};
  for (const auto& option : line.options.options()) manual.entries.emplace_back(term(*option), option->description());
  return manual;
}

std::string man_page(const Manual& manual) {
  auto page = fmt::format(".TH \"{}\" 1 \"\" \"tektite {}\" \"User Commands\"\n", manual.name, version);
  page += fmt::format(".SH NAME\n{} \\- {}\n", plain(manual.name), plain(first_part(manual.about)));
  page += fmt::format(".SH SYNOPSIS\n.nf\n{}\n.fi\n", plain(manual.usage));
  page += fmt::format(".SH DESCRIPTION\n{}\n.SH {}\n", plain(manual.about), manual.heading);
  for (const auto& [term, text] : manual.entries)
    page += fmt::format(".TP\n\\fB{}\\fR\n{}\n", plain(term), plain(text));
  page += ".SH \"EXIT STATUS\"\n0: done; 1: the run failed; 2: the input is wrong.\n";
  if (manual.name != "tektite") page += ".SH \"SEE ALSO\"\n.BR tektite (1)\n";
  return page;
}

std::string option_words(const CommandLine& line) {
  std::vector<std::string> words;
  for (const auto& option : line.options.options()) words.push_back("--" + option->long_name());
  return fmt::format("{}", fmt::join(words, " "));
}

}  // namespace tektite
