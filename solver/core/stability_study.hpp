#pragma once
// A study of stability as the stages share it: which schemes are analysed on a lattice of which material, and where.
//
//   name = "tension"
//   scene = "../hvi_2d/scene.toml"        # relative to the study; gives material, scheme and kernel
//   stress = { least = "-4 GPa", largest = "4 GPa", count = 9 }
//   ratio = { least = 0.8, largest = 2.0, count = 7 }
//   [line.eulerian]
//   set = ['scheme = { type = "eulerian" }']

#include <string>
#include <vector>

#include "core/document.hpp"

namespace tektite {

struct StabilityLine {
  std::string name;
  std::string title;
  std::string scene;                  ///< path of the scene file
  std::string variant;                ///< empty where there is none
  std::vector<std::string> settings;  ///< KEY=VALUE
  std::string material;               ///< of the scene; empty: its only one
};

struct StabilityStudy {
  std::string name;
  std::string title;
  std::vector<double> stresses;  ///< mean stress, tension positive, Pa; rising
  std::vector<double> ratios;    ///< h/δ of the lattice without stress; rising
  int waves = 0;                 ///< wave numbers from zero to the shortest wave, along each axis
  double shown_stress = 0.0;     ///< Pa: where growth is shown over wave number and direction
  double shown_ratio = 0.0;      ///< h/δ there, and of the largest stable time steps
  std::vector<StabilityLine> lines;
};

/// Throws InputError.
StabilityStudy read_stability_study(Section& root);

}  // namespace tektite
