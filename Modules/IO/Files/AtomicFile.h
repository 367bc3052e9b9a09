#pragma once

#include "PalpateIOModule.h"
#include "TemporaryFile.h"

#include <filesystem>

namespace palpate
{
/// A file that appears under its name complete, or not at all: it is written under a temporary
/// name in the same folder and renamed by Commit(). Destroyed without Commit(), nothing is left and
/// a file that had the name before is untouched. A symbolic link is followed, and an existing
/// file's permissions are kept. A file that Commit() has named outlives a loss of power: file and
/// folder are synchronised with the disk, which takes some milliseconds for each.
class PALPATEIO_EXPORT AtomicFile
{
public:
  /// Creates the empty temporary file. Throws InputError where `path` cannot be written: no such
  /// folder, no permission, a folder or a device of that name.
  explicit AtomicFile(const std::filesystem::path& path);

  /// Where to write until Commit(). It ends as the final name does, since many writers choose
  /// their format by the ending.
  const std::filesystem::path& TemporaryPath() const { return this->File.Path(); }
  /// Gives the file its name. Throws InputError where that fails.
  void Commit();

private:
  std::filesystem::path Requested; ///< as the user wrote it, for messages
  TemporaryFile File;
};
} // namespace palpate
