#pragma once
// What the runs of a study are judged by, and how far off each of them is.
//
//   combine = "mean"                    # or "max", of the errors below
//   target = 0.01                       # the error whose cost is asked for
//   [[error]]
//   measure = "error_l1_velocity"       # an error norm: the value is the error; over `scale`, where it has a unit
//   [[error]]
//   measure = "inner_radius"            # a measure: its difference from the exact or published value, over that value
//   exact = "50 mm"                     # left out: the value of reference.toml beside the scene ...
//   variant = "split2"                  # ... for this variant (left out: the run's own) ...
//   source = "experiment"               # ... whose source has these words, where there are several

#include <string>
#include <vector>

#include "core/study.hpp"
#include "postprocess/measure/measure.hpp"

namespace tektite {

/// One measure and what it should be.
struct Term {
  std::string measure;
  std::string unit;
  double truth = 0.0;  ///< zero for an error norm
  double scale = 1.0;  ///< what the difference is divided by
  std::string source;  ///< of the truth, in words
  bool is_norm = false;
};

struct Judgement {
  bool largest = false;  ///< the largest error counts instead of the mean
  double target = 0.01;
};

/// Reads `combine` and `target`.
Judgement read_judgement(Section& root);

/// Reads the tables of `error` for one run of the study, with the published values beside its scene. Throws InputError;
/// a measure that the scene does not have is answered with those that it has.
std::vector<Term> read_terms(Section& root, const Member& member);

/// A study with what it is judged by, for every member of every line.
struct JudgedStudy {
  Study study;
  Judgement judgement;
  std::vector<std::vector<std::vector<Term>>> terms;  ///< [line][member][term]
};

/// Reads a study whole. Throws InputError.
JudgedStudy read_judged_study(const std::string& path);

}  // namespace tektite
