#include "core/run_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <thread>

#include "core/error.hpp"
#include "core/system_words.hpp"

namespace tektite {
namespace {

namespace fs = std::filesystem;

/// A run that was told to end writes a last snapshot.
constexpr auto patience = std::chrono::seconds(3);
constexpr auto pause = std::chrono::milliseconds(20);

RunError not_lockable(const fs::path& path, int reason) {
  return RunError(
      fmt::format("{}: the folder cannot be locked for this run: {}", path.string(), words_for_error(reason)));
}

/// False where another program has it. Errors of file systems that know no locks count as locked.
bool lock(int file) { return ::flock(file, LOCK_EX | LOCK_NB) == 0 || (errno != EWOULDBLOCK && errno != EINTR); }

}  // namespace

RunLock::RunLock(const fs::path& folder) : folder_(folder), path_(folder / "run.lock") {
  std::error_code fault;
  new_folder_ = fs::create_directories(folder, fault);
  if (fault) throw RunError(folder.string() + ": this folder cannot be made: " + fault.message());
  for (const auto end = std::chrono::steady_clock::now() + patience; std::chrono::steady_clock::now() < end;) {
    file_ = ::open(path_.c_str(), O_RDWR | O_CREAT, 0666);
    if (file_ < 0) throw not_lockable(path_, errno);
    // A run that ends takes its file away: a lock on that file keeps nobody out.
    if (lock(file_) && is_in_place()) return;
    ::close(file_);
    std::this_thread::sleep_for(pause);
  }
  throw InputError({{folder.string(), 0}, {}, {}, "another run is at work in this folder", "another folder, or wait"});
}

RunLock::RunLock(const fs::path& folder, int handed_down)
    : folder_(folder), path_(folder / "run.lock"), file_(handed_down), mine_(false) {
  if (!is_in_place() || !lock(file_))
    throw InputError(
        {{folder.string(), 0}, "--lock", std::to_string(handed_down), "is not the lock of this folder", {}});
}

RunLock::~RunLock() {
  if (!mine_) return;
  std::error_code ignored;
  fs::remove(path_, ignored);
  if (new_folder_) fs::remove(folder_, ignored);
  ::close(file_);
}

bool RunLock::is_in_place() const {
  struct stat open {
  }, named{};
  return ::fstat(file_, &open) == 0 && ::stat(path_.c_str(), &named) == 0 && open.st_dev == named.st_dev &&
         open.st_ino == named.st_ino;
}

}  // namespace tektite
