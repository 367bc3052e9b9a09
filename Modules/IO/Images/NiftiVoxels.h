#pragma once

#include "NiftiHeader.h"
#include "PalpateIOModule.h"

#include <filesystem>

namespace palpate
{
/// The voxels of a NIfTI-1 file (.nii, .nii.gz). They are read here and not by the NIfTI library,
/// which takes what is missing or damaged for background and turns NaN into 0.
/// Source: nifti1.h, https://nifti.nimh.nih.gov/nifti-1.
class PALPATEIO_EXPORT NiftiVoxels
{
public:
  NiftiVoxels(const std::filesystem::path& file, const NiftiHeader& header);

  /// VTK_SHORT, ...: the file's type, but VTK_FLOAT for whole numbers with a slope or an
  /// intercept; 0 for a type that is not supported.
  int ScalarType() const;
  /// Reads all voxels, slope and intercept applied, to `buffer`, which has room for them. Throws
  /// InputError for a file that is truncated or whose compressed data are damaged. NaN and infinity
  /// pass.
  void ReadInto(void* buffer) const;

private:
  bool IsScaled() const;

  std::filesystem::path File;
  NiftiHeader Header;
};
} // namespace palpate
