#pragma once
// A program's command line as a man page, and as words that a shell completes: both from the declarations that parse
// it.

#include <string>
#include <utility>
#include <vector>

#include "core/program.hpp"

namespace tektite {

struct Manual {
  std::string name;   ///< of the page, such as tektite-run
  std::string usage;  ///< a line or several
  std::string about;
  std::string heading;                                       ///< of what follows
  std::vector<std::pair<std::string, std::string>> entries;  ///< an option or a command, and what it means
};

/// The page of a command line. Its name is the words with which the usage begins: "tektite run SCENE.toml" is
/// tektite-run.
Manual manual_of(const CommandLine& line);

/// The page in roff, for section 1.
std::string man_page(const Manual& manual);

/// "--output --threads ..."
std::string option_words(const CommandLine& line);

}  // namespace tektite
