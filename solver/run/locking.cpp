#include "run/locking.hpp"

#include <fmt/format.h>

namespace tektite {

std::optional<std::string> locking(const std::string& body, const Material& material) {
  const double shear = shear_modulus_of(material), bulk = bulk_modulus_of(material);
  if (shear == 0.0) return std::nullopt;
  const double ratio = (3.0 * bulk - 2.0 * shear) / (6.0 * bulk + 2.0 * shear);
  if (ratio <= locking_ratio) return std::nullopt;
  return fmt::format(
      "Poisson's ratio of {} is {:.4f}, of a bulk modulus of {:.3g} GPa and a shear modulus of {:.3g} GPa: where it "
      "bends it is too stiff, by some per cent in total-Lagrangian kernels and more in Eulerian ones, whatever else is "
      "right",
      body, ratio, 1e-9 * bulk, 1e-9 * shear);
}

}  // namespace tektite
