#pragma once

#include "PalpateIOModule.h"
#include "vtkType.h"

#include <array>
#include <cstdint>
#include <filesystem>

namespace palpate
{
/// Volumes whose voxels are stored one after the other, in a plain or gzip-compressed file.
struct VoxelLayout
{
  std::filesystem::path File; ///< of the voxels
  int Type = VTK_UNSIGNED_CHAR;
  std::uint64_t Offset = 0; ///< of the first voxel, in bytes of the (decompressed) file
  std::int64_t Voxels = 0;  ///< of one volume
  std::int64_t Volumes = 1;
  bool IsSwapped = false; ///< the file's byte order is not this machine's
  double Slope = 1.0;     ///< value = slope * stored + intercept
  double Intercept = 0.0;
};

/// Voxels of a volume of these sizes. Throws InputError, naming `file`, for more than 1e15, below
/// which counts of voxels and bytes are exact in every type that they are computed in.
PALPATEIO_EXPORT std::int64_t CountVoxels(const std::filesystem::path& file,
                                          const std::array<int, 3>& size);

/// Reads such voxels without the formats' libraries, which replace missing or damaged voxels by
/// background and NaN by 0.
class PALPATEIO_EXPORT StoredVoxels
{
public:
  explicit StoredVoxels(VoxelLayout layout);

  /// Throws InputError if the file cannot hold the voxels: a plain one by its length, a compressed
  /// one by the largest possible compression.
  void CheckLength() const;
  const VoxelLayout& Layout() const { return this->Stored; }
  /// VTK_SHORT, ...: the file's type, but VTK_FLOAT for whole numbers with a slope or an
  /// intercept.
  int ScalarType() const;
  /// Reads all voxels of a volume (from 0), with slope and intercept applied, to `buffer`, which
  /// must be large enough. Throws InputError if the file is truncated or its compressed data are
  /// damaged. NaN and infinity are kept.
  void ReadInto(void* buffer, std::int64_t volume = 0) const;

private:
  bool IsScaled() const;

  VoxelLayout Stored;
};
} // namespace palpate
