#pragma once
// What the four programs share: the command line, the one place where an error meets the user, and the exit codes.

#include <boost/program_options.hpp>

#include <functional>
#include <string>

namespace tektite {

enum ExitCode { exit_done = 0, exit_failed = 1, exit_wrong_input = 2 };

/// Runs `body` and turns what it throws into one line on standard error and an exit code.
int run_program(const std::string& name, const std::function<int()>& body);

struct CommandLine {
  std::string usage;  ///< the line below "Usage:"
  std::string about;  ///< what the program does, in a sentence or two
  boost::program_options::options_description options{"Options"};
  boost::program_options::options_description hidden;  ///< what the positional arguments are bound to
  boost::program_options::positional_options_description positional;
};

/// Parses; adds --help and --version and answers them: true where the program has nothing more to do. Answered too, but
/// in no help, are --man-page and --list-options, of which man pages and completion are made (core/manual.hpp). Throws
/// InputError where the command line is wrong.
bool parse_command_line(CommandLine& line, int argc, const char* const* argv,
                        boost::program_options::variables_map& values);

}  // namespace tektite
