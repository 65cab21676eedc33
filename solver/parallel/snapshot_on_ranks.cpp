#include "parallel/snapshot_on_ranks.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <numeric>

#include "core/seal.hpp"
#include "core/write_beside.hpp"
#include "parallel/agreed.hpp"
#include "parallel/checksum_by_all.hpp"
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

namespace {

/// Bytes of a file with all particles, generously.
std::size_t size_of_file(const Snapshot& snapshot) {
  constexpr std::size_t number = sizeof(double), of_object = 4096;
  const auto& particles = snapshot.particles;
  std::size_t bytes =
      snapshot.scene.size() + of_object * (field_count + particles.bodies().size() + snapshot.state.size());
  for (const auto& row : field_table)
    if (saved(row.keep) && particles.has(row.field))
      bytes += count_of_all(particles) * number * static_cast<std::size_t>(particles.components(row.field));
  return bytes;
}

/// The first rank takes so many bytes on the disk for a file, of which no more is left than is needed; false where
/// there are less. Systems of files that cannot do that are taken at their word.
bool take_room(const std::string& path, std::size_t bytes) {
  if (rank() > 0) return true;
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
  const bool taken = file >= 0 && (::fallocate(file, 0, 0, static_cast<off_t>(bytes)) == 0 || errno == EOPNOTSUPP);
  if (file >= 0) ::close(file);
  return taken;
}

}  // namespace

void write_snapshot_on_ranks(const Snapshot& snapshot, const std::string& path) {
  FileOrder rows(snapshot.particles);
  const auto bytes = size_of_file(snapshot);
  const auto together = file_of_all_ranks();
  // Where a disk becomes full in their midst, processes that write an HDF5 file together wait for each other for ever:
  // the room is taken before, and again when the file is there, which gives it back.
  const auto check_room = [&](const std::string& beside) {
    if (!together->everywhere(take_room(beside, bytes)))
      throw RunError(path + ": there is no room for it (is the disk full, or the folder not writable?)");
  };
  const auto write = [&](const std::string& beside) {
    check_room(beside);
    hdf5::Writer file(beside, together.get());
    check_room(beside);
    write_rows(file, snapshot, rows);
  };
  const auto write_and_sum = [&](const std::string& beside) {
    write(beside);
    const auto length = from_first_rank({rank() == 0 ? std::filesystem::file_size(beside) : 0}).front();
    return checksum_by_all(beside, length);
  };
  if (rank() > 0) {
    write_and_sum(path + part_ending);
    return;
  }
  write_beside(path, [&](const std::string& beside) { seal(beside, write_and_sum(beside)); });
}

}  // namespace tektite
