#pragma once
// One run at a time in a folder: DIR/run.lock, locked by flock(2). The system gives the lock back when the last program
// that holds it ends, however it ends. Where a file system knows no locks, runs go on without.

#include <filesystem>

namespace tektite {

class RunLock {
 public:
  /// Makes the folder where it is missing and locks it; waits some seconds for a run that is just ending. Throws
  /// InputError where another run is at work there, RunError where the folder cannot be written to.
  explicit RunLock(const std::filesystem::path& folder);
  /// The lock that the program which started this one holds and has handed down as an open file. Throws InputError
  /// where it is not the lock of this folder.
  RunLock(const std::filesystem::path& folder, int handed_down);
  /// Who made the lock takes its file away, and a folder that was made for it and has stayed empty.
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

  /// The open file, which programs inherit.
  int file() const { return file_; }

 private:
  bool is_in_place() const;
  std::filesystem::path folder_;
  std::filesystem::path path_;
  int file_ = -1;
  bool new_folder_ = false;
  bool mine_ = true;
};

}  // namespace tektite
