#pragma once

#include <map>
#include <stdexcept>
#include <string>

namespace tektite {

/// The state of a snapshot lacks a number that belongs to the run. Who knows the file makes an InputError of it.
class MissingNumber : public std::runtime_error {
 public:
  explicit MissingNumber(const std::string& name) : std::runtime_error("/state/@" + name) {}
};

/// What a snapshot keeps in its state under this name. Throws MissingNumber.
inline double saved_number(const std::map<std::string, double>& state, const std::string& name) {
  const auto found = state.find(name);
  if (found == state.end()) throw MissingNumber(name);
  return found->second;
}

}  // namespace tektite
