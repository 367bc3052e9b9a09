#pragma once

#include "PalpateIOModule.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// Keeps processes that write into one folder apart, by an advisory lock on a hidden file in it.
/// The kernel releases it when the process ends, however it ends; whoever is last removes the file,
/// and one that a killed process left locks nobody out. Where the file system has no locks, or the
/// folder takes no file, everybody is as if alone.
class PALPATEIO_EXPORT FolderLock
{
public:
  /// Takes nothing yet. `name` is the file's, the same for all who are to be kept apart.
  FolderLock(const std::filesystem::path& folder, const std::string& name);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

  /// Waits until nobody else has it.
  void WaitAlone();
  /// Whether nobody else has it: then it is this object's alone.
  bool TryAlone();
  /// Has it together with others who share it, once nobody has it alone.
  void Share();

private:
  bool Take(int operation);
  void Release() noexcept;

  std::filesystem::path Path;
  int File = -1;
};
} // namespace palpate
