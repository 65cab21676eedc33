#pragma once

#include <optional>
#include <string>

namespace tektite {

/// A name with spaces in place of underscores.
std::string readable(std::string name);

/// A time in s in the unit that suits it, counted from the first contact where there is one.
std::string time_in_words(double time, const std::optional<double>& contact);

}  // namespace tektite
