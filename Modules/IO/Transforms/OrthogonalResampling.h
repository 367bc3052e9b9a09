#pragma once

#include "ImageGrid.h"
#include "PalpateIOModule.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <Eigen/Geometry>
#include <array>
#include <filesystem>

namespace palpate
{
enum class ResamplingKind
{
  Nearest, ///< of labels: no new values
  Linear
};

/// For the notes of what was read.
inline constexpr const char* ResamplingNote =
    "The axes were sheared; the voxels were resampled onto perpendicular ones.";

/// From indices of a grid whose steps and first voxel are the columns of `steps` (mm) to continuous
/// indices of `from`.
Eigen::Affine3d IndexMap(const ImageGrid& from, const Eigen::Affine3d& steps);

/// The values of `image` at the continuous indices to which `indices` maps those of a grid of this
/// size. Outside it is the image's smallest value, or 0 for labels. Throws InputError if they do
/// not fit into memory; `file` is for messages.
vtkSmartPointer<vtkDataArray> ResampledVoxels(const std::filesystem::path& file,
                                              vtkImageData* image, const std::array<int, 3>& size,
                                              const Eigen::Affine3d& indices, ResamplingKind kind);

/// An image with sheared axes (see IsSheared) on perpendicular ones: its first axis, its second one
/// made perpendicular to that, and their normal, so that slices that only slide against each other,
/// as under a tilted gantry, stay whole. The box holds every voxel; voxels have the same volume.
/// Outside of the old volume is the image's smallest value, or 0 for labels. Throws InputError if
/// the result does not fit into memory; `file` is for messages.
PALPATEIO_EXPORT vtkSmartPointer<vtkImageData>
ResampleSheared(const std::filesystem::path& file, vtkImageData* sheared, ResamplingKind kind);
} // namespace palpate
