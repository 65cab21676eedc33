#pragma once
// The one schema of particle files: the initial state that preprocess writes and the snapshots that solver writes.
//
//   /                @format "tektite particles", @format_version, @tektite_version, @space
//   /scene           the effective scene as TOML
//   /state           @time and every other number of the run's state
//   /bodies/NNNN     @name @material @spacing @first @count
//   /particles/FIELD (count) or (count, components), with @unit and @symbol
//
// and behind all that the seal of seal.hpp, without which a file is not whole. Files of the format 1, those of others
// too, need none.

#include <functional>
#include <map>
#include <set>
#include <string>

#include "core/document.hpp"
#include "core/particles.hpp"

namespace tektite::hdf5 {
class Writer;
struct Rows;
}  // namespace tektite::hdf5

namespace tektite {

class RowsOfFile;

struct Snapshot {
  Particles particles;
  std::map<std::string, double> state;  ///< numbers by name; "time" in s is always there
  std::string scene;                    ///< the effective scene as TOML

  double time() const { return state.at("time"); }
};

inline constexpr int particle_format_version = 2;

/// Writes beside and renames, so that `path` is either whole or as it was. Throws RunError.
void write_snapshot(const Snapshot& snapshot, const std::string& path);

/// Writes a snapshot's file, of its particles these rows. Throws RunError.
void write_rows(hdf5::Writer& file, const Snapshot& snapshot, RowsOfFile& rows);

/// Throws InputError where the file is missing, foreign, newer than this program, or broken.
Snapshot read_snapshot(const std::string& path);

/// Throws InputError where the file is missing, or so damaged that it must not be opened.
void check_file(const std::string& path);

/// The first of the rows of a file and how many there are, out of the number of all.
using ShareOfRows = std::function<hdf5::Rows(std::size_t)>;

using FieldSet = std::set<Field>;

/// The fields of a file that check_file() lets pass. Throws InputError.
FieldSet fields_in(const std::string& path);

/// Every field that a particle file may have.
const FieldSet& saved_fields();

/// Of a file that check_file() lets pass: all but the particles, and of these some rows, bodies' ranges being theirs,
/// of the fields that are wanted and there. Throws InputError.
Snapshot read_rows(const std::string& path, const ShareOfRows& share, const FieldSet& wanted = saved_fields());

/// The same of all rows. Without any field it is what the file tells beside the particles.
Snapshot read_fields(const std::string& path, const FieldSet& wanted);

}  // namespace tektite
