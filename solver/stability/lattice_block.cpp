#include "stability/lattice_block.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include "core/kernel_type.hpp"

namespace tektite {
namespace {

/// Of the scale of a component: rounding adds 1e-16 over it to a difference, curvature its fourth power.
constexpr double change = 1e-3;

/// Everything that a step of some scheme reads of the step before; what is not allocated has no part in it.
constexpr auto state_fields = std::to_array(
    {Field::position, Field::velocity, Field::density, Field::specific_internal_energy, Field::pressure,
     Field::deviatoric_stress, Field::acceleration, Field::velocity_gradient, Field::viscous_power, Field::thickness});

double support_of(const std::string& kernel) {
  double support = 0.0;
  [&]<class... Kernels>(std::type_identity<std::variant<Kernels...>>) {
    ((Kernels::name == kernel ? void(support = Kernels::support) : void()), ...);
  }(std::type_identity<Kernel>{});
  return support;
}

int columns_of(const RunSettings& settings, double ratio) {
  if (settings.scheme.type != "adaptle") return 1;
  return 2 * static_cast<int>(std::ceil(2.0 * support_of(settings.scheme.kernel) * ratio));
}

int support_in_particles(const RunSettings& settings, const LatticeState& state) {
  // By the shorter of the deformed axes: what a sheared lattice reaches beyond that makes the block grow.
  double least = std::numeric_limits<double>::infinity();
  const std::size_t d = state.deformation.size() == 1 ? 1 : 2;
  for (std::size_t k = 0; k < d; ++k) {
    double square = 0.0;
    for (std::size_t a = 0; a < d; ++a) square += std::pow(state.deformation[a * d + k], 2);
    least = std::min(least, std::sqrt(square));
  }
  return static_cast<int>(std::ceil(support_of(settings.scheme.kernel) * state.ratio / least));
}

/// A length, speed and density make a unit of every field.
double scale_of(Field field, double length, double speed, double density) {
  switch (field) {
    case Field::position:
      return length;
    case Field::velocity:
      return speed;
    case Field::density:
      return density;
    case Field::specific_internal_energy:
      return speed * speed;
    case Field::pressure:
    case Field::deviatoric_stress:
      return density * speed * speed;
    case Field::acceleration:
      return speed * speed / length;
    case Field::velocity_gradient:
      return speed / length;
    case Field::viscous_power:
      return speed * speed * speed / length;
    default:
      return 1.0;
  }
}

double determinant_of(const std::vector<double>& f) { return f.size() == 1 ? f[0] : f[0] * f[3] - f[1] * f[2]; }

}  // namespace

std::vector<double> deformation_for(const Material& material, int dimensions, double stress) {
  const auto tension = [&](double density) {
    return std::visit([&](const auto& eos) { return -eos.pressure(density, 0.0); }, material.eos);
  };
  double low = 0.5 * material.density, high = 2.0 * material.density;  // tension falls as the density grows
  if (!(tension(low) >= stress && tension(high) <= stress))
    throw InputError({{},
                      "stress",
                      fmt::format("{:g} Pa", stress),
                      fmt::format("the equation of state of {} does not reach it", material.name),
                      fmt::format("{:g} to {:g} Pa", tension(high), tension(low))});
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (tension(middle) > stress ? low : high) = middle;
  }
  const double stretch = std::pow(material.density / high, 1.0 / dimensions);
  const auto d = static_cast<std::size_t>(dimensions);
  std::vector<double> f(d * d, 0.0);
  for (std::size_t k = 0; k < d; ++k) f[k * d + k] = stretch;
  return f;
}

LatticeBlock::LatticeBlock(const RunSettings& settings, const LatticeState& state, int half_width)
    : columns_(columns_of(settings, state.ratio)),
      half_width_(half_width),
      support_(support_in_particles(settings, state)),
      materials_{{state.material, settings.materials.at(state.material)}},
      particles_(make_particles(settings, state)),
      scheme_(make_scheme({particles_, profile_, materials_, settings.scheme, {}})) {
  scheme_->start();
  stable_step_ = scheme_->stable_step().dt;
  wave_speed_ = particles_.reals(Field::wave_speed).front();
  choose_components();

  // The particles may lie in another order now: their places tell which is which.
  const auto width = static_cast<std::size_t>(dimensions());
  cells_.resize(count());
  middle_.resize(static_cast<std::size_t>(columns_));
  for (std::size_t i = 0; i < count(); ++i) {
    cells_[i] = {0, 0};
    for (std::size_t k = 0; k < width; ++k)
      cells_[i][k] = static_cast<int>(std::lround(particles_.reals(Field::position)[i * width + k] / spacing));
    const auto [x, y] = cells_[i];
    if (y == 0 && x >= 0 && x < columns_) middle_[static_cast<std::size_t>(x)] = i;
  }
  const std::vector<std::int64_t> order(particles_.integers(Field::id).begin(), particles_.integers(Field::id).end());
  deform(state.deformation);
  if (!std::ranges::equal(order, particles_.integers(Field::id))) {
    std::vector<std::size_t> now(count()), before(count());
    for (std::size_t i = 0; i < count(); ++i) now[static_cast<std::size_t>(particles_.integers(Field::id)[i])] = i;
    auto cells = cells_;
    for (std::size_t i = 0; i < count(); ++i) cells[now[static_cast<std::size_t>(order[i])]] = cells_[i];
    for (auto& middle : middle_) middle = now[static_cast<std::size_t>(order[middle])];
    cells_ = cells;
  }
  base_ = particles_;
}

Particles LatticeBlock::make_particles(const RunSettings& settings, const LatticeState& state) const {
  const auto space = settings.scene.space;
  if (hoops_of(space) > 0 || dimensions_of(space) > 2)
    throw InputError({{},
                      "space",
                      std::string(name_of(space)),
                      "stability is analysed on a straight line or in a plane",
                      "line, plane-strain, plane-stress"});
  const int rows = dimensions_of(space) == 1 ? 0 : half_width_;
  const int across = 2 * half_width_ + columns_;
  const auto number = static_cast<std::size_t>(across) * static_cast<std::size_t>(2 * rows + 1);
  Particles particles(space, {{"block", state.material, spacing, {0, number}}});
  for (const auto field : {Field::id, Field::position, Field::velocity, Field::mass, Field::density,
                           Field::smoothing_length, Field::kernel_type, Field::velocity_gradient})
    particles.allocate(field);  // the last, which a scheme may do without, for the strains that it sees
  std::iota(particles.integers(Field::id).begin(), particles.integers(Field::id).end(), 0);
  const double density = materials_.at(state.material).density;
  const int dimensions = dimensions_of(space);
  std::size_t i = 0;
  for (int y = -rows; y <= rows; ++y)
    for (int x = -half_width_; x < half_width_ + columns_; ++x, ++i) {
      const auto width = static_cast<std::size_t>(dimensions);
      particles.reals(Field::position)[i * width] = x * spacing;
      if (dimensions > 1) particles.reals(Field::position)[i * width + 1] = y * spacing;
      particles.scalars(Field::mass)[i] = density * std::pow(spacing, dimensions);
      particles.scalars(Field::density)[i] = density;
      particles.scalars(Field::smoothing_length)[i] = state.ratio * spacing;
      const int column = ((x % columns_) + columns_) % columns_;
      const bool eulerian = columns_ > 1 && 2 * column >= columns_;
      particles.integers(Field::kernel_type)[i] =
          static_cast<std::int64_t>(eulerian ? KernelType::eulerian : KernelType::total_lagrangian);
    }
  return particles;
}

/// Brings the lattice to F; a step of no time makes everything else follow.
void LatticeBlock::deform(const std::vector<double>& f) {
  const auto width = static_cast<std::size_t>(dimensions());
  const auto places = particles_.reals(Field::position);
  for (std::size_t i = 0; i < count(); ++i) {
    std::array<double, 2> x{};
    for (std::size_t a = 0; a < width; ++a)
      for (std::size_t b = 0; b < width; ++b) x[a] += f[a * width + b] * places[i * width + b];
    std::copy_n(x.begin(), width, places.begin() + static_cast<std::ptrdiff_t>(i * width));
  }
  for (auto& density : particles_.reals(Field::density)) density /= determinant_of(f);
  scheme_->step(0.0);
  std::ranges::fill(particles_.reals(Field::velocity), 0.0);
}

void LatticeBlock::choose_components() {
  const double density = particles_.reals(Field::density).front();
  for (const auto field : state_fields) {
    if (!particles_.has(field)) continue;
    for (int c = 0; c < particles_.components(field); ++c)
      components_.push_back({field, c, scale_of(field, spacing, wave_speed_, density)});
  }
}

std::vector<double> LatticeBlock::state_after(std::size_t particle, const StateComponent& changed, double by,
                                              double dt) {
  particles_ = base_;
  const auto place = particle * static_cast<std::size_t>(particles_.components(changed.field)) +
                     static_cast<std::size_t>(changed.component);
  particles_.reals(changed.field)[place] += by * changed.scale;
  scheme_->step(dt);
  if (!std::ranges::equal(particles_.integers(Field::id), base_.integers(Field::id)))
    throw std::logic_error("stability: a step put the particles of a lattice in another order");
  std::vector<double> state(count() * components_.size());
  for (std::size_t c = 0; c < components_.size(); ++c) {
    const auto width = static_cast<std::size_t>(particles_.components(components_[c].field));
    const auto values = particles_.reals(components_[c].field);
    const auto component = static_cast<std::size_t>(components_[c].component);
    for (std::size_t i = 0; i < count(); ++i)
      state[i * components_.size() + c] = values[i * width + component] / components_[c].scale;
  }
  return state;
}

std::vector<double> LatticeBlock::response(int column, std::size_t component, double dt) {
  const auto particle = middle_[static_cast<std::size_t>(column)];
  const auto difference = [&](double by) {
    auto forth = state_after(particle, components_[component], by, dt);
    const auto back = state_after(particle, components_[component], -by, dt);
    for (std::size_t k = 0; k < forth.size(); ++k) forth[k] -= back[k];
    return forth;
  };
  auto response = difference(change);
  const auto wide = difference(2.0 * change);
  for (std::size_t k = 0; k < response.size(); ++k) response[k] = (8.0 * response[k] - wide[k]) / (12.0 * change);
  return response;
}

}  // namespace tektite
