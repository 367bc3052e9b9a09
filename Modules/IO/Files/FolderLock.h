#pragma once

#include "PalpateIOModule.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// Serializes processes that write into one folder, by an advisory lock on a hidden file in it. The
/// kernel releases the lock when the process ends, in any way; the last holder removes the file,
/// and a file left by a killed process locks nobody out. If the file system has no locks, or no
/// file can be created in the folder, every process gets the lock.
class PALPATEIO_EXPORT FolderLock
{
public:
  /// Does not lock yet. `name` is the file's, the same for all processes to be serialized.
  FolderLock(const std::filesystem::path& folder, const std::string& name);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

  /// Waits for the exclusive lock.
  void WaitAlone();
  /// Takes the exclusive lock if it is free; returns whether it did.
  bool TryAlone();
  /// Waits for a shared lock, until nobody holds it exclusively.
  void Share();

private:
  bool Take(int operation);
  void Release() noexcept;

  std::filesystem::path Path;
  int File = -1;
};
} // namespace palpate
