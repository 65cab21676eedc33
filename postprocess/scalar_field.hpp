#pragma once
// One number a particle, by name: what a picture colours and what an extreme is taken of. A field of the table in
// core/fields.def (a vector gives its length, the deviator its von Mises equivalent), a component of velocity or
// stress, or one that is derived here.

#include <optional>
#include <string>
#include <vector>

#include "core/snapshot.hpp"

namespace tektite {

/// Names that scalar_field() knows.
const std::vector<std::string>& scalar_field_names();

/// SI unit of a known name; "1" where it has none.
std::string scalar_field_unit(const std::string& name);

/// The values, one a computed particle; nullopt where the snapshot does not hold what this needs.
std::optional<std::vector<double>> scalar_field(const Snapshot& snapshot, const std::string& name);

/// √(3/2 s:s) of a deviatoric stress, one a computed particle; the snapshot must hold deviatoric_stress.
std::vector<double> von_mises_stress(const Particles& particles);

}  // namespace tektite
