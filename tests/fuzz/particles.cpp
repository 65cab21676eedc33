// Any bytes as a particle file: refused by an InputError, or particles that can be written again.
#include "core/snapshot.hpp"
#include "fuzz/file_of.hpp"

using namespace tektite;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const test::FileOf file(data, size, ".h5");
  try {
    write_snapshot(read_snapshot(file.path()), file.path());
  } catch (const InputError&) {
  }
  return 0;
}
