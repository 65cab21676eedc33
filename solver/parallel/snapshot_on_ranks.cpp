#include "parallel/snapshot_on_ranks.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/seal.hpp"
#include "core/write_beside.hpp"
#include "parallel/agreed.hpp"
#include "parallel/file_order.hpp"
#include "parallel/shared_file.hpp"

namespace tektite {

Snapshot read_snapshot_on_ranks(const std::string& path) {
  if (ranks() == 1) return read_snapshot(path);
  agreed([&] {
    if (rank() == 0) check_file(path);
    return true;
  });
  const auto part = static_cast<std::size_t>(rank()), parts = static_cast<std::size_t>(ranks());
  std::size_t first = 0, all = 0;
  auto snapshot = agreed([&] {
    return read_rows(path, [&](std::size_t count) {
      first = count * part / parts, all = count;
      return hdf5::Rows(first, count * (part + 1) / parts - first, count);
    });
  });
  auto& particles = snapshot.particles;
  particles.allocate(Field::sequence);
  const auto sequence = particles.integers(Field::sequence);
  std::iota(sequence.begin(), sequence.end(), static_cast<std::int64_t>(first));
  particles.allocate(Field::owner);
  std::ranges::fill(particles.integers(Field::owner), std::int64_t{rank()});
  note_count_of_all(all);
  return snapshot;
}

void write_snapshot_on_ranks(const Snapshot& snapshot, const std::string& path) {
  auto [particles, bodies, rows] = in_file_order(snapshot.particles);
  const Snapshot part{std::move(particles), snapshot.state, snapshot.scene};
  const auto together = file_of_all_ranks();
  const auto write = [&, &bodies = bodies, &rows = rows](const std::string& beside) {
    hdf5::Writer file(beside, together.get());
    write_rows(file, part, bodies, rows);
  };
  if (rank() > 0) return write(path + part_ending);
  write_beside(path, [&](const std::string& beside) {
    write(beside);
    seal(beside);
  });
}

}  // namespace tektite
