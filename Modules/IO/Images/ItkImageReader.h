#pragma once

#include "ItkImageHeader.h"

#include <filesystem>
#include <memory>
#include <string>

namespace palpate
{
/// The formats that are read or written with ITK.
enum class ItkFormat
{
  Nifti, ///< only written
  Nrrd,
  MetaImage
};

/// The only interface to ITK's image readers: NRRD and MetaImage. Prints nothing; failures are
/// ITK's exceptions (std::exception) with ITK's messages.
class ItkImageReader
{
public:
  /// Reads the header of an NRRD or MetaImage file. Throws if the file is neither or damaged.
  ItkImageReader(const std::filesystem::path& file, ItkFormat format);
  ItkImageReader(const ItkImageReader&) = delete;
  ItkImageReader& operator=(const ItkImageReader&) = delete;
  ~ItkImageReader();

  ItkImageHeader Header() const;
  /// Reads all voxels to `buffer`, which must be large enough.
  void ReadInto(void* buffer);

private:
  struct Implementation;
  std::unique_ptr<Implementation> Itk;
};
} // namespace palpate
