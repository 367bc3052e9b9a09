#pragma once

#include "PalpateIOModule.h"

#include <array>
#include <cstdint>
#include <filesystem>

namespace palpate
{
/// The fields of a NIfTI-1, NIfTI-2 or Analyze 7.5 header that are used, as the file states them,
/// in this machine's byte order. Analyze has no slope, unit, qform and sform: they keep these
/// values.
struct NiftiFields
{
  enum class Version
  {
    Analyze,
    Nifti1,
    Nifti2
  };
  Version Kind = Version::Nifti1;
  bool IsPair = false;    ///< the voxels are in a file of their own
  bool IsSwapped = false; ///< the file's byte order is not this machine's
  std::array<std::int64_t, 8> Dimensions{};
  std::array<double, 4> PixelDimensions{};
  int Type = 0;
  double VoxelOffset = 0.0;
  double Slope = 0.0;
  double Intercept = 0.0;
  int Units = 0;
  int QFormCode = 0;
  int SFormCode = 0;
  std::array<double, 6> QForm{};  ///< quaternion b, c, d; offset
  std::array<double, 12> SForm{}; ///< rows

  /// Bytes of the header, in front of which no voxel of a single file can start.
  std::size_t HeaderBytes() const { return this->Kind == Version::Nifti2 ? 540 : 348; }
};

/// Reads the fields of a file, plain or compressed. Throws InputError for a header that is cut off
/// or of another format.
/// Source: nifti1.h and nifti2.h, https://nifti.nimh.nih.gov; Analyze: Mayo Clinic, dbh.h.
PALPATEIO_EXPORT NiftiFields ReadNiftiFields(const std::filesystem::path& file);
} // namespace palpate
