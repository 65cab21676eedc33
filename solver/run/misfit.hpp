#pragma once
// Densities that do not fit the places of the particles: a density by continuity is free to run away from them, and
// particles that have lost all neighbours keep the one that they had.

#include "core/particles.hpp"

namespace tektite {

/// How far the sum of W over the room that particles have may be from one. A lattice has it within 2 % from h/δ = 1
/// on, disorder adds some per cent.
inline constexpr double density_misfit = 0.1;

/// Of the particles of a body that have an Eulerian kernel and have not failed, as parts of all of its particles.
struct Misfit {
  /// Whose Σ V_j W_ij, V the room by mass and density, differs from one by more than density_misfit. Judged are those
  /// that are nearer to their neighbours than the smoothing length and surrounded by them: a surface is no misfit.
  double part = 0.0;
  double mean_sum = 1.0;   ///< Σ V_j W_ij of these: below one where densities are higher than places say
  double untouched = 0.0;  ///< that have pressure and no neighbour, which nothing expands further
};

Misfit misfit(const Particles& particles, const Body& body);

}  // namespace tektite
