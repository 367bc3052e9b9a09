#pragma once

#include "ItkImageHeader.h"

#include <filesystem>
#include <memory>
#include <string>

namespace palpate
{
/// The formats that ITK reads or writes here.
enum class ItkFormat
{
  Nifti, ///< only written
  Nrrd,
  MetaImage
};

/// The only door to ITK's image readers: NRRD and MetaImage. It prints nothing; failures come back
/// as exceptions of ITK's (std::exception) with ITK's own words.
class ItkImageReader
{
public:
  /// Reads the header of an NRRD or MetaImage file. Throws where it is no such file or damaged.
  ItkImageReader(const std::filesystem::path& file, ItkFormat format);
  ItkImageReader(const ItkImageReader&) = delete;
  ItkImageReader& operator=(const ItkImageReader&) = delete;
  ~ItkImageReader();

  ItkImageHeader Header() const;
  /// Reads all voxels to `buffer`, which has room for them.
  void ReadInto(void* buffer);

private:
  struct Implementation;
  std::unique_ptr<Implementation> Itk;
};
} // namespace palpate
