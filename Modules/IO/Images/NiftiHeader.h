#pragma once

#include "LabelTable.h"
#include "NiftiOrientation.h"
#include "PalpateIOModule.h"
#include "StoredVoxels.h"
#include "Vector3.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// What a NIfTI or Analyze header says about its voxels in the file and in the patient.
struct NiftiHeader
{
  std::array<int, 3> Size{};         ///< voxels along each axis
  Vector3 Spacing = Vector3::Ones(); ///< mm
  NiftiOrientation Orientation;
  VoxelLayout Voxels;
  bool IsAnalyze = false;         ///< whose orientation is absent
  std::vector<std::string> Notes; ///< on where the voxels start, as sentences
  LabelTable Labels; ///< of an extension of the header (CaretLabels); empty if there is none
};

/// Reads and checks the header of a NIfTI-1 or NIfTI-2 file, plain or compressed, or of a pair of
/// files (`isPair`: NAME.hdr, with NAME.img or NAME.img.gz next to it), which may also be Analyze
/// 7.5. Throws InputError for a header that is cut off, damaged or of the other kind, for colour,
/// complex or unknown voxels, two or five dimensions, spacings that are not positive, voxels that
/// start within an extension of the header, and a missing data file.
PALPATEIO_EXPORT NiftiHeader ReadNiftiHeader(const std::filesystem::path& file, bool isPair);
} // namespace palpate
