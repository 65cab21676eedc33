// Any file is a particle file or an InputError.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <fstream>
#include <string>

#include "core/error.hpp"
#include "core/snapshot.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string path = "/dev/shm/tektite-fuzz-" + std::to_string(::getpid()) + ".h5";
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  try {
    tektite::read_snapshot(path);
  } catch (const tektite::InputError&) {
  }
  ::unlink(path.c_str());
  return 0;
}
