#include "core/write_beside.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>

#include "core/error.hpp"
#include "core/system_words.hpp"

namespace tektite {

void bring_to_disk(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool done = file >= 0 && ::fsync(file) == 0;
  const int reason = errno;
  if (file >= 0) ::close(file);
  if (!done) throw RunError(path + ": cannot be brought to the disk: " + words_for_error(reason));
}

void write_beside(const std::string& path, const std::function<void(const std::string&)>& write) {
  namespace fs = std::filesystem;
  std::error_code fault;
  const auto folder = fs::path(path).parent_path();
  if (!folder.empty()) fs::create_directories(folder, fault);
  if (fault) throw RunError(folder.string() + ": this folder cannot be made: " + fault.message());
  const auto beside = path + part_ending;
  try {
    write(beside);
    bring_to_disk(beside);
    fs::rename(beside, path, fault);
    if (fault) throw RunError(path + ": cannot be renamed into place: " + fault.message());
    bring_to_disk(folder.empty() ? "." : folder.string());
  } catch (...) {
    fs::remove(beside, fault);
    throw;
  }
}

void write_text_beside(const std::string& path, const std::string& text) {
  write_beside(path, [&](const std::string& beside) {
    std::ofstream file(beside, std::ios::binary);
    file << text;
    file.close();
    if (!file) throw RunError(path + ": cannot be written (is the folder writable and the disk not full?)");
  });
}

}  // namespace tektite
