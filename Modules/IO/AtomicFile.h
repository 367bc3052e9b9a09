#pragma once

#include "PalpateIOModule.h"

#include <filesystem>

namespace palpate
{
/// A file that appears under its name complete, or not at all: it is written under a temporary
/// name in the same folder and renamed by Commit(). Destroyed without Commit(), nothing is left and
/// a file that had the name before is untouched. A symbolic link is followed, and an existing
/// file's permissions are kept.
class PALPATEIO_EXPORT AtomicFile
{
public:
  /// Creates the empty temporary file. Throws InputError where `path` cannot be written: no such
  /// folder, no permission, a folder or a device of that name.
  explicit AtomicFile(const std::filesystem::path& path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  /// Where to write until Commit(). It ends as the final name does, since many writers choose
  /// their format by the ending.
  const std::filesystem::path& TemporaryPath() const { return this->Temporary; }
  /// Gives the file its name. Throws InputError where that fails.
  void Commit();

private:
  std::filesystem::path Requested; ///< as the user wrote it, for messages
  std::filesystem::path Target;
  std::filesystem::path Temporary;
  bool Committed = false;
};
} // namespace palpate
