#include "stability/swegle.hpp"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "stability/lattice_cases.hpp"

using namespace tektite;
using namespace tektite::test;

namespace {

constexpr Wave zigzag{std::numbers::pi, 0.0};

/// Growth times δ/c of the shortest wave on a line under a stress, which strains nothing: only the kernel's slope
/// changes, and every second neighbour moves: γ² = 8 σ m/ρ² (W''(r) + W''(3r) + ...).
double zigzag_growth(const LatticeState& state, double stress, double wave_speed) {
  const double density = 2785.0 / state.deformation[0], r = state.deformation[0], h = state.ratio;  // over δ
  double curvature = 0.0;
  for (int n = 1; n * r < CubicSpline::support * h; n += 2) curvature += kernel_curvature("cubic-spline", n * r, h);
  curvature *= CubicSpline::normalisation<1>() / (h * h * h);
  return std::sqrt(std::max(0.0, 8.0 * stress * 2785.0 / (density * density) * curvature)) / wave_speed;
}

}  // namespace

TEST_CASE("Tensile instability: the shortest wave on a line grows where W'' times stress is positive") {
  const auto settings = lattice_settings("line", no_viscosity);
  for (const double ratio : {0.8, 1.0, 1.2, 1.4})  // up to 1.5 the nearest neighbours alone move against a particle
    for (const double stress : {-4e9, -1e9, 1e9, 4e9}) {
      const auto state = stressed(settings, ratio, stress);
      const Amplification step(settings, state, short_step);
      const double rate = step.growth(zigzag).rate, predicted = zigzag_growth(state, stress, step.wave_speed());
      WARN(fmt::format("h/δ {}, {:+.0f} GPa: growth {:.4f} c/δ, predicted {:.4f}", ratio, 1e-9 * stress, rate,
                       predicted));
      CHECK((rate > growing) == swegle_unstable("cubic-spline", state.deformation[0], ratio, stress));
      CHECK(rate == Approx(predicted).margin(1e-5).epsilon(1e-3));  // the step's share: (γ Δt)²/24
    }
}

TEST_CASE("Tensile instability: wider kernels take back what the nearest neighbours do") {
  // W''(δ) < 0 there, and Swegle's sign asks for growth in compression: W''(3δ) of the cubic spline cancels it.
  const auto settings = lattice_settings("line", no_viscosity);
  for (const double ratio : {1.6, 1.8})
    for (const double stress : {-4e9, 4e9}) {
      const auto state = stressed(settings, ratio, stress);
      CHECK(swegle_unstable("cubic-spline", state.deformation[0], ratio, stress) == (stress < 0.0));
      CHECK(zigzag_growth(state, stress, 6448.0) < growing);
      CHECK(Amplification(settings, state, short_step).growth(zigzag).rate < growing);
    }
}

TEST_CASE("Tensile instability: kernels of the reference configuration have none") {
  const auto settings = lattice_settings("line", no_viscosity + "scheme = { type = 'total-lagrangian' }\n");
  for (const double ratio : {1.0, 1.4, 1.8})
    for (const double stress : {-4e9, 4e9}) {
      const Amplification step(settings, stressed(settings, ratio, stress), short_step);
      CHECK(fastest_growth(step, waves_of(1, 16)).growth.rate < growing);
    }
}

TEST_CASE("Zero-energy modes: of the shortest wave no scheme with kernel gradients sees the strain, of long ones all") {
  for (const std::string scheme : {"eulerian", "total-lagrangian", "godunov-split"}) {
    const auto viscosity = scheme == "godunov-split" ? std::string() : no_viscosity;
    const auto settings = lattice_settings("plane-strain", viscosity + "scheme = { type = '" + scheme + "' }\n");
    const Amplification step(settings, stressed(settings, 1.4, 0.0));
    CHECK(step.strain_share(zigzag) < 1e-10);
    CHECK(step.strain_share({std::numbers::pi, std::numbers::pi}) < 1e-10);
    CHECK(step.strain_share({0.1, 0.0}) == Approx(1.0).epsilon(0.05));  // uncorrected sums on a lattice
  }
}
