// tektite: the program that a person uses. It runs the stages; each is a program of its own.

#include <fmt/format.h>

#include <array>
#include <functional>
#include <string_view>

#include "core/error.hpp"
#include "core/manual.hpp"
#include "core/program.hpp"
#include "core/version.hpp"
#include "front/commands.hpp"

namespace tektite::front {
namespace {

constexpr std::string_view about = "High-velocity impact of solids with smoothed particle hydrodynamics.";

struct Command {
  std::string_view name;
  std::string_view arguments;
  std::string_view about;
  std::function<int(const Words&)> run;
};

int help(const Words& arguments);

const auto& commands() {
  static const auto stage = [](Stage which) {
    return [which](const Words& arguments) -> int { become_stage(which, arguments); };
  };
  static const std::array<Command, 10> table{{
      {"run", "SCENE.toml", "all stages, then ours beside published", run},
      {"check", "SCENE.toml", "validate, explain, estimate", check},
      {"resume", "DIR", "go on from the newest snapshot", resume},
      {"chart", "STUDY.toml", "run a study: accuracy against cost", chart},
      {"stability", "STUDY.toml", "where schemes fail: which waves grow", stability},
      {"report", "DIR...", "a page about one run, or several side by side", report},
      {"preprocess", "SCENE.toml -o FILE.h5", "fill the bodies with particles", stage(Stage::preprocess)},
      {"solve", "DIR", "compute the impact", stage(Stage::solve)},
      {"postprocess", "DIR", "measure and draw a run again", stage(Stage::postprocess)},
      {"help", "[COMMAND]", "this, or the help of a command", help},
  }};
  return table;
}

const Command& command_named(const std::string& name) {
  std::vector<std::string> known;
  for (const auto& command : commands()) {
    if (command.name == name) return command;
    known.emplace_back(command.name);
  }
  throw InputError({{}, {}, {}, fmt::format("unknown command \"{}\"", name), join(known)});
}

int help(const Words& arguments) {
  if (!arguments.empty()) return command_named(arguments.front()).run({"--help"});
  fmt::print("tektite {}: high-velocity impact of solids with smoothed particles\n\nUsage: tektite COMMAND ...\n\n",
             version);
  for (const auto& command : commands())
    fmt::print("  {:<12}{:<24}{}\n", command.name, command.arguments, command.about);
  fmt::print(
      "\n`tektite COMMAND --help` tells the options of each. Exit codes: 0 done, 1 the run failed, 2 the input is "
      "wrong.\n");
  return exit_done;
}

/// The commands as the man page of tektite.
std::string commands_in_roff() {
  Manual manual{"tektite", "tektite COMMAND ...", std::string(about), "COMMANDS", {}};
  for (const auto& command : commands())
    manual.entries.emplace_back(fmt::format("{} {}", command.name, command.arguments), command.about);
  return man_page(manual);
}

std::string words_for_the_shell() {
  std::string words;
  for (const auto& command : commands()) words += fmt::format("{} ", command.name);
  return words + "--help --version\n";
}

int start(const Words& words) {
  if (words.empty()) throw InputError({{}, {}, {}, "no command is given", "see tektite help"});
  const Words arguments(words.begin() + 1, words.end());
  if (words.front() == "--help" || words.front() == "-h") return help({});
  if (words.front() == "--version") {
    fmt::print("tektite {}\n", version);
    return exit_done;
  }
  if (words.front() == "--man-page" || words.front() == "--list-options") {
    fmt::print("{}", words.front() == "--man-page" ? commands_in_roff() : words_for_the_shell());
    return exit_done;
  }
  return command_named(words.front()).run(arguments);
}

}  // namespace

bool parse(CommandLine& line, const Words& arguments, boost::program_options::variables_map& values) {
  std::vector<const char*> words{"tektite"};
  for (const auto& argument : arguments) words.push_back(argument.c_str());
  return parse_command_line(line, static_cast<int>(words.size()), words.data(), values);
}

}  // namespace tektite::front

int main(int argc, char** argv) {
  return tektite::run_program("tektite", [&] { return tektite::front::start({argv + 1, argv + argc}); });
}
