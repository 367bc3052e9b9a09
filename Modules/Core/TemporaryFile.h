#pragma once

#include "Status.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// A new file in the folder of the file that it will replace. Its name is random, was free, and is
/// not a link, so no other process uses it. It replaces the target atomically, and is removed with
/// the object unless it was published or kept. A symbolic link as target is replaced
/// itself: the file behind it is never written.
class TemporaryFile
{
public:
  TemporaryFile() = default;
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  /// Creates the empty file, named `prefix`, a number, `suffix`. Error messages are clauses without
  /// the file's name that say why `target` cannot be written: no folder, no permission, not a file.
  Status Create(const std::filesystem::path& target, const std::string& prefix,
                const std::string& suffix);
  /// Open for writing; -1 while there is no file.
  int Descriptor() const noexcept { return this->File; }
  const std::filesystem::path& Path() const noexcept { return this->Temporary; }
  const std::filesystem::path& Target() const noexcept { return this->Final; }

  /// Renames the file to the target, with the permissions of the file it replaces, if any. On
  /// return, file and name are on the disk. Error messages are clauses; on failure the file stays
  /// as it is.
  Status Publish();
  /// Leaves the file under its temporary name.
  void Keep() noexcept;

private:
  void Close() noexcept;

  std::filesystem::path Final;
  std::filesystem::path Temporary; ///< empty: nothing to remove
  int File = -1;
};
} // namespace palpate
