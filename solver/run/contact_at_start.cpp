#include "run/contact_at_start.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tektite {

std::optional<Warning> contact_at_start(const Simulation& simulation) {
  constexpr double notable = 1e-3;
  if (simulation.steps() > 0) return std::nullopt;
  const auto ledger = simulation.ledger();
  if (ledger.contact <= notable * ledger.kinetic) return std::nullopt;
  constexpr double support = 2.0;  // of every kernel that bodies in contact may have
  const double reach = support * std::ranges::max(simulation.particles().reals(Field::smoothing_length));
  return Warning{"contact-at-start",
                 fmt::format("bodies start so near each other that the contact between them holds {:.3g} J, which will "
                             "drive them apart; a gap of {:.3g} m between their surfaces, 2 h, leaves nothing there",
                             ledger.contact, reach)};
}

}  // namespace tektite
