#include "output/snapshot_writer.hpp"

#include <algorithm>

#include "parallel/for_each.hpp"
#include "parallel/ranks.hpp"
#include "parallel/snapshot_on_ranks.hpp"

namespace tektite {
namespace {

/// The first of `to` become those of `from`.
template <class T>
void copy(std::span<const T> from, std::span<T> to) {
  constexpr std::size_t part = 1 << 16;
  for_each((from.size() + part - 1) / part, [=](std::size_t k) {
    const auto piece = from.subspan(k * part, std::min(part, from.size() - k * part));
    std::ranges::copy(piece, to.begin() + static_cast<std::ptrdiff_t>(k * part));
  });
}

void copy_kept_fields(const Particles& from, Particles& to) {
  if (to.count() == 0) to = Particles(from.space(), from.bodies());
  for (const auto& row : field_table) {
    if (!saved(row.keep) || !from.has(row.field)) continue;
    to.allocate(row.field);
    const auto numbers = from.count() * static_cast<std::size_t>(from.components(row.field));
    if (row.rank == Rank::integer)
      copy(from.integers(row.field).first(numbers), to.integers(row.field));
    else
      copy(from.reals(row.field).first(numbers), to.reals(row.field));
  }
}

}  // namespace

void SnapshotWriter::start(const Snapshot& state, const std::string& path, const History* history) {
  if (ranks() > 1) {
    if (history) history->bring_to_disk();
    write_snapshot_on_ranks(state, path);
    begun_ = true;
    return;
  }
  copy_kept_fields(state.particles, copy_.particles);
  copy_.state = state.state;
  copy_.scene = state.scene;
  begun_ = true;
  writing_.start([this, path, history] {
    if (history) history->bring_to_disk();
    write_snapshot(copy_, path);
  });
}

}  // namespace tektite
