#pragma once

#include "NiftiOrientation.h"
#include "PalpateIOModule.h"
#include "Vector3.h"
#include "vtkType.h"

#include <array>
#include <cstddef>
#include <filesystem>

namespace palpate
{
/// The fields of a NIfTI-1 header that locate its voxels in the file and in the patient.
struct NiftiHeader
{
  std::array<int, 3> Size{};         ///< voxels along each axis
  Vector3 Spacing = Vector3::Ones(); ///< mm
  NiftiOrientation Orientation;
  int VoxelType = VTK_UNSIGNED_CHAR;
  std::size_t VoxelOffset = 0; ///< bytes from the start of the (decompressed) file
  double Slope = 1.0;          ///< value = slope * stored + intercept
  double Intercept = 0.0;
  bool IsSwapped = false; ///< the file's byte order is not this machine's
};

/// Reads and checks the header of a NIfTI-1 file, plain or compressed. Throws InputError for a
/// header that is cut off or damaged, NIfTI-2, colour, complex or unknown voxels, 2-D and 4-D
/// images, spacings that are not positive, and an uncompressed file that is shorter than its header
/// says.
/// Source: nifti1.h, https://nifti.nimh.nih.gov/nifti-1.
PALPATEIO_EXPORT NiftiHeader ReadNiftiHeader(const std::filesystem::path& file);
} // namespace palpate
