#pragma once

#include "Status.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// A new file in the folder of the file that it is going to replace. Nobody else has it: its name
/// was free, is random and is no link. It becomes the target at once or not at all, and is removed
/// with the object unless it was published or kept. A link as target is followed.
class TemporaryFile
{
public:
  TemporaryFile() = default;
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  /// Creates the empty file, named `prefix`, a number, `suffix`. Failures say why `target` cannot
  /// be written, as a clause without its name: no such folder, no permission, no regular file.
  Status Create(const std::filesystem::path& target, const std::string& prefix,
                const std::string& suffix);
  /// Open for writing; -1 while there is no file.
  int Descriptor() const noexcept { return this->File; }
  const std::filesystem::path& Path() const noexcept { return this->Temporary; }
  const std::filesystem::path& Target() const noexcept { return this->Final; }

  /// Gives the file the target's name, and its permissions where there is one. When this returns,
  /// file and name have reached the disk. Failures are clauses, and leave the file as it is.
  Status Publish();
  /// Leaves the file under its temporary name.
  void Keep() noexcept;

private:
  void Close() noexcept;

  std::filesystem::path Final;
  std::filesystem::path Temporary; ///< empty: nothing is to be removed
  int File = -1;
};
} // namespace palpate
