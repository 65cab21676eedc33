// A model cut by its symmetry planes is the whole model, to round-off, whether particles lie on a plane (there they
// have half their mass) or on either side of it.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "support/impact.hpp"

using namespace tektite;

namespace {

constexpr int steps = 100;
constexpr double rounding =
    1e-11;  // 1e-16 in the first step, below 1e-12 after a hundred; ten times that for other processors

enum class Arrangement { on_the_plane, beside_it };

/// A normal impact that is symmetric about y = 0 and z = 0; `kept` says which part is made.
template <class Kept>
Particles symmetric_impact(Space space, Arrangement arrangement, const Kept& kept) {
  const double d = test::impact_spacing;
  const auto dimensions = static_cast<std::size_t>(dimensions_of(space));
  const int odd = arrangement == Arrangement::on_the_plane ? 1 : 0;
  const int reach = space == Space::solid ? 7 : 20;  // rows of the target on either side
  const auto centred = [&](int rows) { return -0.5 * (rows - 1) * d; };
  const int narrow = 6 + odd, wide = 2 * reach + odd;
  test::Lattice projectile{
      "projectile",       "metal", d, {-5.5 * d, centred(narrow), centred(narrow)}, {6, narrow, narrow},
      {2000.0, 0.0, 0.0}, kept};
  test::Lattice target{"target",        "plate",         d,   {0.5 * d, centred(wide), centred(wide)},
                       {4, wide, wide}, {0.0, 0.0, 0.0}, kept};
  for (auto* lattice : {&projectile, &target}) {
    lattice->first.resize(dimensions);
    lattice->count.resize(dimensions);
    lattice->velocity.resize(dimensions);
  }
  return test::particles_on(space, {projectile, target}, 2785.0);
}

/// The part with x[k] ≥ 0 along each of these axes.
auto above(const std::vector<int>& axes) {
  return [axes](const double* x) {
    return std::ranges::all_of(axes, [&](int k) { return x[k] > -1e-9 * test::impact_spacing; });
  };
}

template <Space space>
void check_cut(Arrangement arrangement, const std::vector<int>& axes, const std::string& scheme = {}) {
  constexpr int D = dimensions_of(space);
  INFO(scheme << name_of(space) << ", " << axes.size() << " planes, particles "
              << (arrangement == Arrangement::on_the_plane ? "on" : "beside") << " them");
  auto part = symmetric_impact(space, arrangement, above(axes));
  std::string scene = scheme + test::impact_scene;
  for (const int k : axes) {
    scene = fmt::format("symmetry.{0} = {{ axis = '{0}' }}\n", "xyz"[k]) + scene;
    for (std::size_t i = 0; i < part.count(); ++i) {
      auto& x = part.vectors<D>(Field::position)[i][k];
      if (std::abs(x) > 1e-9 * test::impact_spacing) continue;
      x = 0.0;
      part.scalars(Field::mass)[i] *= 0.5;
    }
  }
  const auto everywhere = [](const double*) { return true; };
  auto whole = symmetric_impact(space, arrangement, everywhere);
  const auto start = test::by_id(whole, Field::position);
  auto whole_run = test::simulation_of(scheme + test::impact_scene, std::move(whole));
  auto part_run = test::simulation_of(scene, std::move(part));
  test::take_steps(whole_run, steps);
  test::take_steps(part_run, steps);

  // The particles of the part are those of the whole that it keeps, in the same order.
  const auto largest_difference = [&](Field field, double scale) {
    const auto a = test::by_id(whole_run.particles(), field), b = test::by_id(part_run.particles(), field);
    const auto width = static_cast<std::size_t>(whole_run.particles().components(field));
    double largest = 0.0;
    std::size_t next = 0;
    for (std::size_t i = 0; i < a.size() / width; ++i) {
      if (!above(axes)(start.data() + i * D)) continue;
      for (std::size_t k = 0; k < width; ++k, ++next) {
        const double d = std::abs(a[i * width + k] - b.at(next));
        largest = d > largest || std::isnan(d) ? d : largest;
      }
    }
    REQUIRE(next == b.size());
    return largest / scale;
  };
  CHECK(part_run.time() == Approx(whole_run.time()).epsilon(rounding));
  CHECK(largest_difference(Field::position, test::impact_spacing) < rounding);
  CHECK(largest_difference(Field::velocity, 2000.0) < rounding);
  CHECK(largest_difference(Field::density, 2785.0) < rounding);
  CHECK(largest_difference(Field::pressure, 1e10) < rounding);
  CHECK(largest_difference(Field::deviatoric_stress, 3e8) < rounding);
  CHECK(largest_difference(Field::plastic_strain, 1.0) < rounding);
  const double share = std::pow(2.0, static_cast<double>(axes.size()));
  CHECK(share * part_run.ledger().kinetic == Approx(whole_run.ledger().kinetic).epsilon(rounding));
}

}  // namespace

TEST_CASE("Symmetry planes: half a plane model is the whole one", "[symmetry]") {
  for (const auto arrangement : {Arrangement::on_the_plane, Arrangement::beside_it}) {
    check_cut<Space::plane_strain>(arrangement, {1});
    check_cut<Space::plane_stress>(arrangement, {1});
  }
}

TEST_CASE("Symmetry planes: half and a quarter of a solid model are the whole one", "[symmetry]") {
  for (const auto arrangement : {Arrangement::on_the_plane, Arrangement::beside_it}) {
    check_cut<Space::solid>(arrangement, {1});
    check_cut<Space::solid>(arrangement, {1, 2});
  }
}

TEST_CASE("Symmetry planes: they hold for the Godunov schemes", "[symmetry]") {
  for (const auto arrangement : {Arrangement::on_the_plane, Arrangement::beside_it})
    for (const std::string scheme : {"type = 'godunov-pm'", "type = 'godunov-split'",
                                     "type = 'godunov-split', riemann.model = 'two-shock', splitting = 'strang'"}) {
      check_cut<Space::plane_strain>(arrangement, {1}, "scheme = { " + scheme + " }\n");
      check_cut<Space::solid>(arrangement, {1, 2}, "scheme = { " + scheme + " }\n");
    }
}

TEST_CASE("Symmetry planes: they hold for either form of msph, and for ssph", "[symmetry]") {
  for (const auto arrangement : {Arrangement::on_the_plane, Arrangement::beside_it})
    for (const std::string type : {"type = 'msph'", "type = 'msph', forces = 'adjoint'", "type = 'ssph'"}) {
      const auto scheme = "scheme = { " + type + " }\nsmoothing.kernel = 'truncated-gaussian'\n";
      check_cut<Space::plane_strain>(arrangement, {1}, scheme);
      check_cut<Space::solid>(arrangement, {1, 2}, scheme);
    }
}

TEST_CASE("Symmetry planes: they hold with kernels that are corrected", "[symmetry]") {
  for (const auto arrangement : {Arrangement::on_the_plane, Arrangement::beside_it})
    for (const std::string scheme :
         {"scheme = { correction = 'mixed', correction_limit = 10.0",
          "contact.model = 'kernel-penalty'\nscheme = { type = 'total-lagrangian'",
          "contact.model = 'kernel-penalty'\nscheme = { type = 'adaptle', correction = 'mixed', conversion = 'strain', "
          "conversion_strain = 0.1",
          "scheme = { type = 'godunov-split', limiter.model = 'van-leer', correction = 'mixed', correction_limit = "
          "10.0"}) {
      check_cut<Space::plane_strain>(arrangement, {1}, scheme + " }\n");
      check_cut<Space::solid>(arrangement, {1, 2}, scheme + " }\n");
    }
}

TEST_CASE("Symmetry planes: a bar that runs into a plane is half of two equal bars that collide", "[symmetry]") {
  const double d = test::impact_spacing;
  const auto run = [&](const std::vector<test::Lattice>& bars, const std::string& plane) {
    auto simulation = test::simulation_of(plane + test::impact_scene, test::particles_on(Space::line, bars, 2785.0));
    test::take_steps(simulation, steps);
    return test::by_id(simulation.particles(), Field::velocity);
  };
  const test::Lattice right{"right", "plate", d, {0.5 * d}, {60}, {-1000.0}};
  const test::Lattice left{"left", "plate", d, {-59.5 * d}, {60}, {1000.0}};
  const auto half = run({right}, "symmetry.wall = { axis = 'x' }\n"), both = run({right, left}, "");
  double largest = 0.0;
  for (std::size_t i = 0; i < half.size(); ++i) largest = std::max(largest, std::abs(half[i] - both[i]));
  CHECK(largest < 1000.0 * rounding);
  CHECK(std::abs(half.front()) < 100.0);  // it has been stopped
}
