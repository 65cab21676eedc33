#pragma once
// What `tektite check` says, on standard output.

#include "advice/advise.hpp"
#include "advice/forecast.hpp"

namespace tektite {

void print_scene(const Simulation& simulation);
void print(const Forecast& forecast, const Simulation& simulation);
void print(const Advice& advice);

}  // namespace tektite
