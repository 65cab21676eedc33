#pragma once
// One number a particle, by name: what a picture colours and what an extreme is taken of. A field of the table in
// core/fields.def (a vector gives its length, the deviator its von Mises equivalent), a component of velocity or
// stress, or one that is derived here.

#include <optional>
#include <string>
#include <vector>

#include "core/snapshot.hpp"
#include "postprocess/whole.hpp"

namespace tektite {

/// Names that scalar_field() knows.
const std::vector<std::string>& scalar_field_names();

/// The fields that a known name needs.
FieldSet scalar_field_needs(const std::string& name);

/// SI unit of a known name; "1" where it has none.
std::string scalar_field_unit(const std::string& name);

/// Whether the value turns its sign in a mirror across `axis` (0 = x): a velocity across it, a shear stress with it.
bool turns_in_mirror(const std::string& name, int axis);

/// The values, one a computed particle; nullopt where the snapshot does not hold what this needs.
std::optional<std::vector<double>> scalar_field(const Snapshot& snapshot, const std::string& name);

/// The values of a snapshot's computed particles, those of field `name`, for all of the whole with images in `planes`.
std::vector<double> with_images(const std::vector<double>& values, const std::string& name, const Whole& whole,
                                const std::vector<SymmetryPlane>& planes);

/// √(3/2 s:s) of a deviatoric stress, one a computed particle; the snapshot must hold deviatoric_stress.
std::vector<double> von_mises_stress(const Particles& particles);

}  // namespace tektite
