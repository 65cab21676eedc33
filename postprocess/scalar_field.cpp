#include "postprocess/scalar_field.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/tensor.hpp"

namespace tektite {
namespace {

bool can_be_shown(const FieldInfo& row) { return row.keep == Keep::result && row.rank != Rank::tensor; }

std::vector<double> lengths(const Particles& particles, Field field) {
  const auto width = static_cast<std::size_t>(particles.components(field));
  const auto components = particles.reals(field);
  std::vector<double> values(particles.count());
  for (std::size_t i = 0; i < values.size(); ++i) {
    double square = 0.0;
    for (std::size_t k = 0; k < width; ++k) square += components[i * width + k] * components[i * width + k];
    values[i] = std::sqrt(square);
  }
  return values;
}

template <int D>
std::vector<double> von_mises_in(const Particles& particles) {
  const auto* stress = particles.symmetrics<D>(Field::deviatoric_stress);
  std::vector<double> values(particles.count());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = von_mises(stress[i]);
  return values;
}

struct Component {
  const char* name;
  Field needed;
  int row, column;  ///< of a vector the row alone
};
constexpr std::array components{
    Component{"velocity_x", Field::velocity, 0, 0},         Component{"velocity_y", Field::velocity, 1, 1},
    Component{"velocity_z", Field::velocity, 2, 2},         Component{"stress_xx", Field::deviatoric_stress, 0, 0},
    Component{"stress_yy", Field::deviatoric_stress, 1, 1}, Component{"stress_zz", Field::deviatoric_stress, 2, 2},
    Component{"stress_xy", Field::deviatoric_stress, 0, 1},
};

const Component* component_named(const std::string& name) {
  const auto found = std::ranges::find(components, name, &Component::name);
  return found == components.end() ? nullptr : &*found;
}

/// A component of the velocity or of the stress s - p 1; nullopt where the space does not have it.
template <int D>
std::optional<std::vector<double>> component_in(const Particles& particles, const Component& which) {
  std::vector<double> values(particles.count());
  const bool within = which.row < D && which.column < D;
  if (which.needed == Field::velocity) {
    if (!within) return std::nullopt;
    const auto* v = particles.vectors<D>(Field::velocity);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = v[i][which.row];
    return values;
  }
  const bool across = D == 2 && which.row == 2 && which.column == 2;
  if ((!within && !across) || !particles.has(Field::pressure)) return std::nullopt;
  const auto* s = particles.symmetrics<D>(Field::deviatoric_stress);
  const auto p = particles.reals(Field::pressure);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = (across ? s[i].c[2] : s[i](which.row % D, which.column % D)) - (which.row == which.column ? p[i] : 0.0);
  return values;
}

std::optional<std::vector<double>> component_of(const Particles& particles, const Component& which) {
  if (!particles.has(which.needed)) return std::nullopt;
  switch (particles.dimensions()) {
    case 1:
      return component_in<1>(particles, which);
    case 2:
      return component_in<2>(particles, which);
    default:
      return component_in<3>(particles, which);
  }
}

std::vector<double> body_indices(const Particles& particles) {
  std::vector<double> values(particles.count());
  for (std::size_t k = 0; k < particles.bodies().size(); ++k)
    for (auto i = particles.bodies()[k].range.begin; i < particles.bodies()[k].range.end; ++i)
      values[i] = static_cast<double>(k);
  return values;
}

std::vector<double> as_reals(std::span<const std::int64_t> integers) {
  return std::vector<double>(integers.begin(), integers.end());
}

}  // namespace

const std::vector<std::string>& scalar_field_names() {
  static const auto names = [] {
    std::vector<std::string> all{"speed", "von_mises_stress", "body"};
    for (const auto& row : field_table)
      if (can_be_shown(row)) all.emplace_back(row.name);
    for (const auto& component : components) all.emplace_back(component.name);
    return all;
  }();
  return names;
}

FieldSet scalar_field_needs(const std::string& name) {
  if (name == "body") return {};
  if (name == "speed") return {Field::velocity};
  if (name == "von_mises_stress") return {Field::deviatoric_stress};
  const auto* component = component_named(name);
  if (!component) return {field_named(name).value()};
  return component->needed == Field::velocity ? FieldSet{Field::velocity}
                                              : FieldSet{component->needed, Field::pressure};
}

std::string scalar_field_unit(const std::string& name) {
  if (name == "speed") return std::string(info(Field::velocity).unit);
  if (name == "von_mises_stress") return std::string(info(Field::deviatoric_stress).unit);
  if (const auto* component = component_named(name)) return std::string(info(component->needed).unit);
  const auto field = field_named(name);
  return field ? std::string(info(*field).unit) : "1";
}

bool turns_in_mirror(const std::string& name, int axis) {
  const auto* component = component_named(name);
  if (!component) return false;
  if (component->needed == Field::velocity) return component->row == axis;
  return (component->row == axis) != (component->column == axis);
}

std::vector<double> with_images(const std::vector<double>& values, const std::string& name, const Whole& whole,
                                const std::vector<SymmetryPlane>& planes) {
  unsigned turning = 0;  // the planes that turn the sign, as bits of an image
  for (std::size_t k = 0; k < planes.size(); ++k)
    if (turns_in_mirror(name, planes[k].axis)) turning |= 1u << k;
  std::vector<double> all(whole.count());
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool turned = std::popcount(whole.image[i] & turning) % 2 == 1;
    all[i] = turned ? -values[whole.source[i]] : values[whole.source[i]];
  }
  return all;
}

std::vector<double> von_mises_stress(const Particles& particles) {
  switch (particles.dimensions()) {
    case 1:
      return von_mises_in<1>(particles);
    case 2:
      return von_mises_in<2>(particles);
    default:
      return von_mises_in<3>(particles);
  }
}

std::optional<std::vector<double>> scalar_field(const Snapshot& snapshot, const std::string& name) {
  const auto& particles = snapshot.particles;
  if (name == "body") return body_indices(particles);
  if (const auto* component = component_named(name)) return component_of(particles, *component);
  const auto needed = name == "speed"              ? Field::velocity
                      : name == "von_mises_stress" ? Field::deviatoric_stress
                                                   : field_named(name).value();
  if (!particles.has(needed)) return std::nullopt;
  switch (info(needed).rank) {
    case Rank::integer:
      return as_reals(particles.integers(needed).first(particles.count()));
    case Rank::vector:
      return lengths(particles, needed);
    case Rank::symmetric:
      return von_mises_stress(particles);
    default: {
      const auto values = particles.reals(needed).first(particles.count());
      return std::vector<double>(values.begin(), values.end());
    }
  }
}

}  // namespace tektite
