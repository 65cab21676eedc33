#pragma once
// The bytes that a fuzzer tries, as a file.

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace tektite::test {

/// A file of this process with this ending, written anew; taken away in the end.
class FileOf {
 public:
  FileOf(const std::uint8_t* data, std::size_t size, const std::string& ending)
      : path_((std::filesystem::temp_directory_path() / ("tektite-fuzz-" + std::to_string(::getpid()) + ending))
                  .string()) {
    std::ofstream(path_, std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  }
  ~FileOf() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  FileOf(const FileOf&) = delete;
  FileOf& operator=(const FileOf&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace tektite::test
