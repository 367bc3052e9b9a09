#pragma once

#include "PalpateIOModule.h"

#include <filesystem>

namespace palpate
{
/// A name under which the NIfTI library reads a file's own voxels. Given a.nii.gz it takes the
/// header from there, but the voxels from a.nii where such a file lies beside it. Then a symbolic
/// link in a temporary folder, which lives as long as the alias, takes the file's place; otherwise
/// the name is the file's own.
class PALPATEIO_EXPORT NiftiAlias
{
public:
  /// Throws std::filesystem::filesystem_error or std::runtime_error where no link can be made.
  explicit NiftiAlias(const std::filesystem::path& file);
  NiftiAlias(const NiftiAlias&) = delete;
  NiftiAlias& operator=(const NiftiAlias&) = delete;
  ~NiftiAlias();

  const std::filesystem::path& Path() const { return this->Name; }

private:
  std::filesystem::path Name;
  std::filesystem::path Folder; ///< empty where no link was needed
};
} // namespace palpate
