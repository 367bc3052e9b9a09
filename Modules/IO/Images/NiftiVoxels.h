#pragma once

#include "NiftiHeader.h"
#include "PalpateIOModule.h"

#include <filesystem>

namespace palpate
{
/// Reads the voxels of a NIfTI-1 file (.nii, .nii.gz) without the NIfTI library, which replaces
/// missing or damaged voxels by background and NaN by 0.
/// Source: nifti1.h, https://nifti.nimh.nih.gov/nifti-1.
class PALPATEIO_EXPORT NiftiVoxels
{
public:
  NiftiVoxels(const std::filesystem::path& file, const NiftiHeader& header);

  /// VTK_SHORT, ...: the file's type, but VTK_FLOAT for whole numbers with a slope or an
  /// intercept.
  int ScalarType() const;
  /// Reads all voxels, with slope and intercept applied, to `buffer`, which must be large enough.
  /// Throws InputError if the file is truncated or its compressed data are damaged. NaN and
  /// infinity are kept.
  void ReadInto(void* buffer) const;

private:
  bool IsScaled() const;

  std::filesystem::path File;
  NiftiHeader Header;
};
} // namespace palpate
