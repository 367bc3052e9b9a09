#pragma once

#include "ImageGrid.h"
#include "OrthogonalResampling.h"
#include "PalpateIOModule.h"

#include <Eigen/Geometry>
#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// An image that a map of the patient's space (LPS, mm) moves, resampled on another grid: its
/// voxel at x has the value of the image at the inverse of x. Outside of the image it is the
/// image's smallest value, or 0 for labels. Throws InputError if the result does not fit into
/// memory; `file` is for messages.
PALPATEIO_EXPORT vtkSmartPointer<vtkImageData>
ResampleMoved(const std::filesystem::path& file, vtkImageData* image, const Eigen::Affine3d& map,
              const ImageGrid& onto, ResamplingKind kind);

/// The same voxels at the place to which a rigid map moves them. Throws InputError for a map that
/// changes lengths or mirrors.
PALPATEIO_EXPORT vtkSmartPointer<vtkImageData>
MoveRigidly(const std::filesystem::path& file, vtkImageData* image, const Eigen::Affine3d& map);

/// The image at the place to which an affine map that does not mirror moves it. The voxels stay as
/// they are where the axes stay perpendicular, as under rigid maps and similarities; otherwise they
/// are resampled on axes that are (see ResampleSheared), with a note. Throws InputError for a grid
/// that no image has (see CheckGrid), and as ResampleSheared does.
PALPATEIO_EXPORT vtkSmartPointer<vtkImageData>
MoveAxes(const std::filesystem::path& file, vtkImageData* image, const Eigen::Affine3d& map,
         ResamplingKind kind, std::vector<std::string>& notes);
} // namespace palpate
