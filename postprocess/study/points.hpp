#pragma once
// The runs of a study as points: what each cost and how wrong it is.

#include <optional>
#include <string>
#include <vector>

#include "postprocess/study/judgement.hpp"

namespace tektite {

struct TermValue {
  double value = 0.0;        ///< in SI
  double uncertainty = 0.0;  ///< of the measure, in SI
  double error = 0.0;        ///< |value - truth| over the scale
};

struct StudyPoint {
  std::string failure;  ///< why there is no result; empty where there is one
  // Of a run with a result; zero otherwise.
  double cost = 0.0;  ///< s of processor time in the solver
  std::int64_t particles = 0, steps = 0;
  double error = 0.0;              ///< mean or largest of those of the terms
  double error_uncertainty = 0.0;  ///< what the measures' own uncertainties make of it
  std::vector<TermValue> terms;    ///< as the study has them
};

struct StudyPoints {
  std::vector<std::vector<StudyPoint>> lines;  ///< [line][member]
};

/// Reads DIR/runs/MEMBER/measurements.json of every member, and DIR/runs/MEMBER.failed where a run failed. A run that
/// is missing, or lacks a measure, is a failure with its reason.
StudyPoints read_points(const JudgedStudy& judged, const std::string& folder);

}  // namespace tektite
