// Gives files, or all files of folders, to the function of a fuzzer, without libFuzzer: what once made it fail stays
// mended.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int argc, char** argv) {
  namespace fs = std::filesystem;
  int count = 0;
  const auto give = [&count](const fs::path& path) {
    std::cout << path.filename() << std::endl;  // the last one that is named made it fail
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    ++count;
  };
  for (int k = 1; k < argc; ++k) {
    const fs::path path(argv[k]);
    if (!fs::is_directory(path)) {
      give(path);
      continue;
    }
    for (const auto& entry : fs::directory_iterator(path)) give(entry.path());
  }
  std::cout << count << " inputs\n";
  return count > 0 ? 0 : 1;
}
