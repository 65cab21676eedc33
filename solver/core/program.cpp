#include "core/program.hpp"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <iostream>
#include <new>

#include "core/error.hpp"
#include "core/manual.hpp"
#include "core/version.hpp"

namespace tektite {

int run_program(const std::string& name, const std::function<int()>& body) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that grows too large is told like a disk that is full
  std::signal(SIGCHLD, SIG_DFL);  // who starts this program may ignore children, which then cannot be waited for
  try {
    const int code = body();
    std::cout.flush();
    if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
      throw RunError("standard output cannot be written (is the disk full?)");
    return code;
  } catch (const InputError& fault) {
    std::cerr << name << ": error: " << fault.what() << '\n';
    return exit_wrong_input;
  } catch (const std::bad_alloc&) {
    std::cerr << name << ": error: this needs more memory than there is; `tektite check` tells how much\n";
  } catch (const std::exception& fault) {
    std::cerr << name << ": error: " << fault.what() << '\n';
  }
  return exit_failed;
}

bool parse_command_line(CommandLine& line, int argc, const char* const* argv,
                        boost::program_options::variables_map& values) {
  namespace po = boost::program_options;
  line.options.add_options()("help,h", "show this help")("version", "show the version");
  // For the build, which makes the man pages and the shell's completion of them.
  line.hidden.add_options()("man-page", "")("list-options", "");
  po::options_description all;
  all.add(line.options).add(line.hidden);
  try {
    po::store(po::command_line_parser(argc, argv).options(all).positional(line.positional).run(), values);
    if (values.contains("help")) {
      std::cout << "Usage: " << line.usage << "\n\n" << line.about << "\n\n" << line.options;
      return true;
    }
    if (values.contains("version")) {
      std::cout << "tektite " << version << '\n';
      return true;
    }
    if (values.contains("man-page")) {
      std::cout << man_page(manual_of(line));
      return true;
    }
    if (values.contains("list-options")) {
      std::cout << option_words(line) << '\n';
      return true;
    }
    po::notify(values);
  } catch (const po::required_option& fault) {
    const auto name = fault.get_option_name();
    const bool positional = line.hidden.find_nothrow(name.substr(name.find_first_not_of('-')), false) != nullptr;
    throw InputError(fmt::format("{} is missing; see --help", positional ? name.substr(2) : name));
  } catch (const po::error& fault) {
    throw InputError(fmt::format("{}; see --help", fault.what()));
  }
  return false;
}

}  // namespace tektite
