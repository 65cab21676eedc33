#include "preprocess/particle_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <span>

#include "core/hdf5.hpp"
#include "core/rows_of_file.hpp"
#include "core/seal.hpp"
#include "core/system_words.hpp"
#include "core/write_beside.hpp"
#include "parallel/agreed.hpp"
#include "parallel/checksum_by_all.hpp"
#include "preprocess/dealing.hpp"

namespace tektite::preprocess {
namespace {

/// The fields of a file in the order of the table.
std::vector<const FieldInfo*> fields_of(const Particles& particles) {
  std::vector<const FieldInfo*> fields;
  for (const auto& row : field_table)
    if (saved(row.keep) && particles.has(row.field)) fields.push_back(&row);
  return fields;
}

/// A file's particles, of which nothing is written yet.
class NoRows : public RowsOfFile {
 public:
  explicit NoRows(const Result& result) : result_(result) {}
  const std::vector<Body>& bodies() const override { return result_.whole; }
  hdf5::Rows rows() const override { return {0, 0, result_.count()}; }
  std::span<const double> reals(Field) override { return {}; }
  std::span<const std::int64_t> integers(Field) override { return {}; }

 private:
  const Result& result_;
};

/// Writes the file without the numbers of its particles. Gives its length and the byte at which those of each field
/// begin.
Words lay_out(const Result& result, const std::string& path) {
  {
    hdf5::Writer file(path);
    NoRows rows(result);
    write_rows(file, result.snapshot, rows);
  }
  const hdf5::Reader file(path);
  Words offsets{std::filesystem::file_size(path)};
  for (const auto* field : fields_of(result.snapshot.particles))
    offsets.push_back(file.offset(fmt::format("/particles/{}", field->name)));
  return offsets;
}

/// A file that is there, of which this process writes parts.
class PartsOfFile {
 public:
  explicit PartsOfFile(const std::string& path) : path_(path), file_(::open(path.c_str(), O_WRONLY | O_CLOEXEC)) {
    check(file_ >= 0);
  }
  ~PartsOfFile() { ::close(file_); }
  PartsOfFile(const PartsOfFile&) = delete;
  PartsOfFile& operator=(const PartsOfFile&) = delete;

  void write(std::span<const std::byte> bytes, std::size_t at) const {
    while (!bytes.empty()) {
      const auto written = ::pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(at));
      if (written < 0 && errno == EINTR) continue;
      check(written >= 0);
      bytes = bytes.subspan(static_cast<std::size_t>(written));
      at += static_cast<std::size_t>(written);
    }
  }
  void bring_to_disk() const { check(::fsync(file_) == 0); }

 private:
  void check(bool fine) const {
    if (!fine) throw RunError(fmt::format("{}: cannot be written: {}", path_, words_for_error(errno)));
  }
  std::string path_;
  int file_;
};

/// The rows that this rank has of each body and field.
void write_own_rows(const Result& result, std::span<const Word> offsets, const std::string& path) {
  const auto& particles = result.snapshot.particles;
  const PartsOfFile file(path);
  auto offset = offsets.begin();
  for (const auto* field : fields_of(particles)) {
    const auto bytes = field->rank == Rank::integer ? std::as_bytes(particles.integers(field->field))
                                                    : std::as_bytes(particles.reals(field->field));
    const auto width = bytes_of(field->field, particles.space());
    for (std::size_t k = 0; k < result.whole.size(); ++k) {
      const auto& own = particles.bodies()[k].range;
      file.write(bytes.subspan(own.begin * width, own.size() * width), *offset + result.first[k] * width);
    }
    ++offset;
  }
  file.bring_to_disk();
}

/// What all ranks do, the first one while it writes beside; gives the checksum of the file.
std::uint32_t write_together(const Result& result, const std::string& path) {
  const auto layout = from_first_rank(agreed([&] { return rank() == 0 ? lay_out(result, path) : Words{}; }));
  agreed([&] {
    write_own_rows(result, std::span(layout).subspan(1), path);
    return true;
  });
  return checksum_by_all(path, layout.front());
}

}  // namespace

void write_particle_file(const Result& result, const std::string& path) {
  if (ranks() == 1) return write_snapshot(result.snapshot, path);
  if (rank() == 0)
    write_beside(path, [&](const std::string& beside) { seal(beside, write_together(result, beside)); });
  else
    write_together(result, path + part_ending);
}

}  // namespace tektite::preprocess
