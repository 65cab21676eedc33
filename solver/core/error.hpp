#pragma once
// The two ways in which a program of tektite ends early. Both are thrown where the fault is found and told to the user
// once, by run_program().

#include <stdexcept>
#include <string>

namespace tektite {

/// Where an input stands: a file and a line (0 where a line means nothing, as in an HDF5 file).
struct Place {
  std::string file;
  int line = 0;
};

/// What is wrong with an input, in the parts of which every message consists. Empty parts are left out.
struct InputFault {
  Place place;
  std::string key;      ///< dotted path of the key, such as material.steel.density
  std::string value;    ///< the value as it was given
  std::string reason;   ///< what is wrong
  std::string allowed;  ///< what would be right
};

/// The input is wrong: exit code 2.
class InputError : public std::runtime_error {
 public:
  explicit InputError(InputFault fault);
  explicit InputError(const std::string& reason) : InputError(InputFault{{}, {}, {}, reason, {}}) {}
  const InputFault& fault() const { return fault_; }

 private:
  InputFault fault_;
};

/// The run failed although its input could be read: exit code 1.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace tektite
