#pragma once

#include "OrganModel.h"
#include "PalpateSceneModule.h"
#include "Segmentation.h"
#include "Volume.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <Eigen/Geometry>
#include <filesystem>

namespace palpate
{
/// A file with a transform that moves what is read from other files (see ReadTransform).
struct SceneMove
{
  std::filesystem::path File;  ///< empty: nothing is moved
  std::filesystem::path Fixed; ///< the image that it leads to; FLIRT's matrices need it

  bool IsSet() const noexcept { return !this->File.empty(); }
};

PALPATESCENE_EXPORT bool operator==(const SceneMove& a, const SceneMove& b);
inline bool operator!=(const SceneMove& a, const SceneMove& b)
{
  return !(a == b);
}

/// The map (LPS, mm) of a move that is set; `moving` is the file that is moved. Throws InputError
/// as ReadTransform does, and for maps that mirror, or stretch or shrink a hundredfold.
PALPATESCENE_EXPORT Eigen::Affine3d ReadMove(const SceneMove& move,
                                             const std::filesystem::path& moving);

///@{
/// What is given, moved in the patient (LPS, mm). Images keep their voxels where their axes stay
/// perpendicular (see MoveAxes), which else adds a note. A radial model becomes one of three
/// coordinates. Throw InputError.
PALPATESCENE_EXPORT Volume Moved(const Eigen::Affine3d& map, Volume volume);
PALPATESCENE_EXPORT Segmentation Moved(const Eigen::Affine3d& map, Segmentation segmentation);
PALPATESCENE_EXPORT vtkSmartPointer<vtkPolyData> Moved(const Eigen::Affine3d& map,
                                                       vtkPolyData* surface);
PALPATESCENE_EXPORT OrganModel Moved(const Eigen::Affine3d& map, const OrganModel& model);
///@}

/// Leaves out segments that have no voxel.
PALPATESCENE_EXPORT void RemoveEmptySegments(Segmentation& segmentation);
} // namespace palpate
