#pragma once

#include <cstdint>
#include <string>

#include "core/hdf5.hpp"

namespace tektite::test {

/// A particle file made by hand with all that is read before its particles: one bar of `count` of them on a line.
inline hdf5::Writer unfinished_file(const std::string& path, std::int64_t format, std::int64_t count) {
  hdf5::Writer file(path);
  file.attribute("/", "format", std::string("tektite particles"));
  file.attribute("/", "format_version", format);
  file.attribute("/", "space", std::string("line"));
  file.text("/scene", "name = \"x\"");
  file.group("/state");
  file.attribute("/state", "time", 0.0);
  file.group("/bodies");
  file.group("/bodies/0000");
  file.attribute("/bodies/0000", "name", std::string("bar"));
  file.attribute("/bodies/0000", "material", std::string("steel"));
  file.attribute("/bodies/0000", "spacing", 1e-3);
  file.attribute("/bodies/0000", "first", std::int64_t{0});
  file.attribute("/bodies/0000", "count", count);
  file.group("/particles");
  return file;
}

}  // namespace tektite::test
