#pragma once
// What a piece of code says when it refuses its input.

#include <catch2/catch.hpp>
#include <string>

#include "core/error.hpp"

namespace tektite::test {

/// The message of the InputError that `code` throws; fails the test where it throws none.
template <class Code>
std::string fault_of(Code&& code) {
  try {
    code();
  } catch (const InputError& fault) {
    return fault.what();
  }
  FAIL("no InputError was thrown");
  return {};
}

}  // namespace tektite::test
