#include "advice/msph_impacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "advice/thickness.hpp"
#include "core/counted.hpp"

namespace tektite {
namespace {

/// By how much of the energy impacts of aluminium at 2 km/s were off, the worst of the spaces line, plane-strain and
/// axisymmetric (docs/stability.md).
struct Measured {
  double at;  ///< particles through the thinner body, or the ratio of the spacings
  double strong, adjoint;
};
constexpr std::array<Measured, 5> by_thickness{
    {{1.0, 1.52, 0.07}, {2.0, 0.39, 0.03}, {3.0, 0.28, 0.03}, {4.0, 0.21, 0.02}, {6.0, 0.10, 0.02}}};
constexpr std::array<Measured, 3> by_ratio{{{1.0, 0.05, 0.01}, {2.0, 0.08, 0.01}, {4.0, 0.15, 0.02}}};

/// What came of impacts with one to six particles through the thinner body, spacings of 1 to 1, 2 and 4, at 2 to 5
/// km/s, in the plane and about the axis: some ended because the matrix B of splinters is nearly singular.
constexpr const char* ended_strong =
    "; 2 of 90 of so few particles ended in an error, and none with scheme.courant = 0.1";
constexpr const char* ended_adjoint = ", and 5 of 90 ended in an error, 2 with scheme.courant = 0.1";

/// Of the last row that is not beyond `at`, or of the first one.
template <std::size_t N>
const Measured& row_of(const std::array<Measured, N>& table, double at) {
  const auto* next = std::ranges::find_if(table, [at](const Measured& row) { return row.at > at; });
  return next == table.begin() ? *next : *(next - 1);
}

}  // namespace

std::vector<std::string> msph_impacts(const Particles& particles, const RunSettings& settings,
                                      const std::vector<Meeting>& meetings) {
  const auto& scheme = settings.scheme;
  std::vector<std::string> lines;
  if (scheme.type != "msph" && scheme.type != "ssph") return lines;
  for (const auto& meeting : meetings) {
    const auto [finer, coarser] = std::minmax(meeting.first->spacing, meeting.second->spacing);
    const double through = std::min(particles_through(particles, *meeting.first, settings.scene.symmetry),
                                    particles_through(particles, *meeting.second, settings.scene.symmetry));
    const double ratio = coarser / finer;
    const auto &thin = row_of(by_thickness, through), &unlike = row_of(by_ratio, ratio);
    const double strong = std::max(thin.strong, unlike.strong), adjoint = std::max(thin.adjoint, unlike.adjoint);
    const auto place =
        fmt::format("{} and {}, {} through the thinner one and spacings of 1 to {:.3g}", meeting.first->name,
                    meeting.second->name, counted(static_cast<std::size_t>(std::llround(through)), "particle"), ratio);
    const bool few = through <= by_thickness.back().at;
    if (!scheme.adjoint_forces)
      lines.push_back(fmt::format(
          "{}: strong forces keep neither momentum nor energy where stresses jump; such impacts were off by "
          "up to {:.0f} % of the energy, and by {:.0f} % with scheme.forces = 'adjoint', which keep the "
          "momentum to round-off{}",
          place, 100.0 * strong, 100.0 * adjoint, few ? ended_strong : ""));
    else if (few)
      lines.push_back(
          fmt::format("{}: such impacts were off by up to {:.0f} % of the energy{}; a finer spacing of the "
                      "thinner one lowers it",
                      place, 100.0 * adjoint, ended_adjoint));
  }
  return lines;
}

}  // namespace tektite
