#pragma once
// What a study has found, as a table for people and for programs and as sentences.

#include <string>
#include <vector>

#include "postprocess/accuracy/cost.hpp"
#include "postprocess/study/points.hpp"

namespace tektite {

/// A run of a study with a result.
struct RunOfStudy {
  std::size_t line = 0, member = 0;
};
std::vector<RunOfStudy> runs_with_result(const StudyPoints& points);

/// Those of them that no other beats in both cost and error, by rising cost.
std::vector<RunOfStudy> front_of(const StudyPoints& points);

/// A row a run: the line, its resolution, cost, error, whether it is on the front, every measure, and what failed.
std::string study_csv(const JudgedStudy& judged, const StudyPoints& points);

/// Markdown: the runs with the rates between them, Richardson's estimates with the grid convergence index, and in words
/// which line is cheapest for the error that is asked for.
std::string study_page(const JudgedStudy& judged, const StudyPoints& points);

/// The last part of that alone.
std::string answer(const JudgedStudy& judged, const StudyPoints& points);

}  // namespace tektite
