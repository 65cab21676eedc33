#include "postprocess/scalar_field.hpp"

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
    return all;
  }();
  return names;
}

std::string scalar_field_unit(const std::string& name) {
  if (name == "speed") return std::string(info(Field::velocity).unit);
  if (name == "von_mises_stress") return std::string(info(Field::deviatoric_stress).unit);
  const auto field = field_named(name);
  return field ? std::string(info(*field).unit) : "1";
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
