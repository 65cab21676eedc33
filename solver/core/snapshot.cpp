#include "core/snapshot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/apart.hpp"
#include "core/hdf5.hpp"
#include "core/rows_of_file.hpp"
#include "core/seal.hpp"
#include "core/version.hpp"
#include "core/write_beside.hpp"

namespace tektite {
namespace {

constexpr const char* format_name = "tektite particles";
constexpr std::int64_t most_particles = std::int64_t{1} << 40;

InputError broken(const hdf5::Reader& file, const std::string& part, const std::string& reason) {
  return InputError({{file.path(), 0}, part, {}, reason, "a particle file of tektite, whole"});
}

std::vector<Body> read_bodies(const hdf5::Reader& file) {
  std::vector<Body> bodies;
  std::int64_t expected_first = 0;
  for (const auto& member : file.members("/bodies")) {
    const auto object = "/bodies/" + member;
    Body body;
    body.name = file.text_attribute(object, "name");
    body.material = file.text_attribute(object, "material");
    body.spacing = file.real_attribute(object, "spacing");
    const auto first = file.integer_attribute(object, "first");
    const auto count = file.integer_attribute(object, "count");
    if (first != expected_first || count < 1 || count > most_particles)
      throw broken(file, object, "its range of particles is wrong");
    if (!(body.spacing > 0.0) || !std::isfinite(body.spacing)) throw broken(file, object, "its spacing is wrong");
    expected_first = first + count;
    body.range = {static_cast<std::size_t>(first), static_cast<std::size_t>(first + count)};
    bodies.push_back(body);
  }
  if (bodies.empty()) throw broken(file, "/bodies", "holds no body");
  return bodies;
}

Space read_space(const hdf5::Reader& file) {
  const auto name = file.text_attribute("/", "space");
  for (const auto& entry : space_names)
    if (entry.name == name) return entry.space;
  throw broken(file, "/@space", fmt::format("unknown space \"{}\"", name));
}

/// Of a particle file that this program knows.
std::int64_t read_format(const hdf5::Reader& file) {
  if (file.text_attribute("/", "format") != format_name) throw broken(file, "/@format", "this is no particle file");
  const auto format = file.integer_attribute("/", "format_version");
  if (format < 1 || format > particle_format_version)
    throw broken(
        file, "/@format_version",
        fmt::format("format {} is not known to this program, which reads up to {}", format, particle_format_version));
  return format;
}

void check_numbers(const hdf5::Reader& file, const FieldInfo& field, std::span<const double> values) {
  for (const double value : values)
    if (!std::isfinite(value))
      throw broken(file, fmt::format("/particles/{}", field.name), "holds a number that is not finite");
  if (field.field != Field::mass && field.field != Field::density && field.field != Field::smoothing_length) return;
  for (const double value : values)
    if (value <= 0.0)
      throw broken(file, fmt::format("/particles/{}", field.name), "holds a number that is not positive");
}

}  // namespace

void write_rows(hdf5::Writer& file, const Snapshot& snapshot, RowsOfFile& rows) {
  file.attribute("/", "format", std::string(format_name));
  file.attribute("/", "format_version", std::int64_t{particle_format_version});
  file.attribute("/", "tektite_version", std::string(version));
  const auto& particles = snapshot.particles;
  file.attribute("/", "space", std::string(name_of(particles.space())));
  file.text("/scene", snapshot.scene);
  file.group("/state");
  for (const auto& [name, value] : snapshot.state) file.attribute("/state", name, value);
  file.group("/bodies");
  const auto& bodies = rows.bodies();
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const auto object = fmt::format("/bodies/{:04}", k);
    file.group(object);
    file.attribute(object, "name", bodies[k].name);
    file.attribute(object, "material", bodies[k].material);
    file.attribute(object, "spacing", bodies[k].spacing);
    file.attribute(object, "first", static_cast<std::int64_t>(bodies[k].range.begin));
    file.attribute(object, "count", static_cast<std::int64_t>(bodies[k].range.size()));
  }
  file.group("/particles");
  for (const auto& row : field_table) {
    if (!saved(row.keep) || !particles.has(row.field)) continue;
    const auto object = fmt::format("/particles/{}", row.name);
    const auto columns = static_cast<std::size_t>(particles.components(row.field));
    if (row.rank == Rank::integer)
      file.integers(object, rows.integers(row.field), columns, rows.rows());
    else
      file.reals(object, rows.reals(row.field), columns, rows.rows());
    file.attribute(object, "unit", std::string(row.unit));
    file.attribute(object, "symbol", std::string(row.symbol));
  }
  file.close();
}

namespace {

/// Of a process that has all.
class AllRows : public RowsOfFile {
 public:
  explicit AllRows(const Particles& particles) : particles_(particles) {}
  const std::vector<Body>& bodies() const override { return particles_.bodies(); }
  hdf5::Rows rows() const override { return particles_.count(); }
  std::span<const double> reals(Field field) override {
    return particles_.reals(field).first(particles_.count() * static_cast<std::size_t>(particles_.components(field)));
  }
  std::span<const std::int64_t> integers(Field field) override {
    return particles_.integers(field).first(particles_.count());
  }

 private:
  const Particles& particles_;
};

}  // namespace

void write_snapshot(const Snapshot& snapshot, const std::string& path) {
  write_beside(path, [&](const std::string& beside) {
    hdf5::Writer file(beside);
    AllRows rows(snapshot.particles);
    write_rows(file, snapshot, rows);
    seal(beside);
  });
}

namespace {

hdf5::Rows all_rows(std::size_t all) { return all; }

/// What bodies have of some rows.
std::vector<Body> bodies_in(std::vector<Body> bodies, const hdf5::Rows& rows) {
  const auto within = [&](std::size_t row) {
    return std::clamp(row, rows.first, rows.first + rows.count) - rows.first;
  };
  for (auto& body : bodies) body.range = {within(body.range.begin), within(body.range.end)};
  return bodies;
}

}  // namespace

const FieldSet& saved_fields() {
  static const FieldSet fields = [] {
    FieldSet all;
    for (const auto& row : field_table)
      if (saved(row.keep)) all.insert(row.field);
    return all;
  }();
  return fields;
}

FieldSet fields_in(const std::string& path) {
  const hdf5::Reader file(path);
  FieldSet fields;
  for (const auto field : saved_fields())
    if (file.has(fmt::format("/particles/{}", info(field).name))) fields.insert(field);
  return fields;
}

Snapshot read_rows(const std::string& path, const ShareOfRows& share, const FieldSet& wanted) {
  const hdf5::Reader file(path);
  read_format(file);
  Snapshot snapshot;
  snapshot.scene = file.text("/scene");
  for (const auto& name : file.attributes("/state")) snapshot.state[name] = file.real_attribute("/state", name);
  if (!snapshot.state.contains("time") || !std::isfinite(snapshot.state["time"]))
    throw broken(file, "/state/@time", "is missing or not finite");
  auto& particles = snapshot.particles;
  const auto bodies = read_bodies(file);
  const auto rows = share(bodies.back().range.end);
  particles = Particles(read_space(file), bodies_in(bodies, rows));
  for (const auto& member : file.members("/particles")) {
    const auto field = field_named(member);
    const auto object = "/particles/" + member;
    if (!field || !saved(info(*field).keep)) throw broken(file, object, "no such field");
    if (!wanted.contains(*field)) continue;
    const auto columns = static_cast<std::size_t>(particles.components(*field));
    if (info(*field).rank == Rank::integer) {
      particles.adopt(*field, file.integers(object, rows, columns));
    } else {
      auto values = file.reals(object, rows, columns);
      check_numbers(file, info(*field), values);
      particles.adopt(*field, std::move(values));
    }
  }
  for (const auto field :
       {Field::id, Field::position, Field::velocity, Field::mass, Field::density, Field::smoothing_length})
    if (const auto object = fmt::format("/particles/{}", info(field).name); !file.has(object))
      throw broken(file, object, "is missing");
  return snapshot;
}

Snapshot read_fields(const std::string& path, const FieldSet& wanted) { return read_rows(path, all_rows, wanted); }

void check_file(const std::string& path) {
  if (!std::filesystem::exists(path)) throw InputError({{path, 0}, {}, {}, "there is no such file", {}});
  if (!std::filesystem::is_regular_file(path)) throw InputError({{path, 0}, {}, {}, "this is no file", {}});
  if (check_seal(path)) return;
  // A file without a seal may be anything, and the HDF5 library does not survive everything.
  if (!can_be_read(path, [&] { read_rows(path, all_rows); }))
    throw InputError(
        {{path, 0}, {}, {}, "the file is damaged: the HDF5 library fails on it", "a particle file of tektite, whole"});
  constexpr std::int64_t last_without_seal = 1;
  if (const hdf5::Reader file(path); read_format(file) > last_without_seal)
    throw broken(file, {}, "the file is damaged: its end is missing, which has the checksum of the rest");
}

Snapshot read_snapshot(const std::string& path) {
  check_file(path);
  return read_rows(path, all_rows);
}

}  // namespace tektite
