#include "core/error.hpp"

#include <fmt/format.h>

namespace tektite {
namespace {

std::string message(const InputFault& fault) {
  std::string text;
  if (!fault.place.file.empty()) {
    text += fault.place.file;
    if (fault.place.line > 0) text += fmt::format(":{}", fault.place.line);
    text += ": ";
  }
  if (!fault.key.empty()) {
    text += fault.key;
    if (!fault.value.empty()) text += " = " + fault.value;
    text += ": ";
  }
  text += fault.reason;
  if (!fault.allowed.empty()) text += " (allowed: " + fault.allowed + ")";
  return text;
}

}  // namespace

InputError::InputError(const InputFault& fault) : std::runtime_error(message(fault)) {}

}  // namespace tektite
