#pragma once
// What a run will take, measured in its first steps.

#include <vector>

#include "advice/impact.hpp"
#include "run/simulation.hpp"

namespace tektite {

struct Forecast {
  double steps = 0.0;               ///< a whole number, which may be larger than can be counted
  double first_dt = 0.0;            ///< s
  double seconds = 0.0;             ///< of each thread's processor
  double memory_bytes = 0.0;        ///< of the whole program, at its largest
  double bytes_per_particle = 0.0;  ///< of it fields, lists and records
  double disk_bytes = 0.0;          ///< of the run's folder, without pictures
  double snapshot_bytes = 0.0;      ///< of one
};

/// Takes steps until they have used this much processor time, five at least, and carries them on to the end. Steps are
/// as long as the first one until bodies meet, then shorter by step_shortening(). Known to within 25 % where the
/// particles do in the end what they do in these steps: conversion and new contacts cost more.
Forecast forecast_of(Simulation& simulation, const std::vector<Meeting>& meetings, double calibration_seconds);

}  // namespace tektite
