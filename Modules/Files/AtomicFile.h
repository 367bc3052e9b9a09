#pragma once

#include "TemporaryFile.h"

#include <filesystem>

namespace palpate
{
/// A file that appears under its name complete, or not at all: it is written under a temporary name
/// in the same folder and renamed by Commit(). Without Commit(), the destructor removes it and an
/// existing file is unchanged. A symbolic link is replaced itself and never followed; an existing
/// file's permissions are kept. A committed file survives a power failure: file and folder are
/// synchronised with the disk, which takes some milliseconds each.
class AtomicFile
{
public:
  /// Creates the empty temporary file. Throws InputError if `path` cannot be written: no such
  /// folder, no permission, a folder or a device of that name.
  explicit AtomicFile(const std::filesystem::path& path);

  /// Where to write until Commit(). It has the ending of the final name, since many writers choose
  /// their format by it.
  const std::filesystem::path& TemporaryPath() const { return this->File.Path(); }
  /// Gives the file its name. Throws InputError if that fails.
  void Commit();

private:
  std::filesystem::path Requested; ///< as given by the user, for messages
  TemporaryFile File;
};
} // namespace palpate
