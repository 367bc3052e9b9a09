#pragma once

#include "HandPath.h"
#include "PalpateSceneModule.h"
#include "Progress.h"
#include "Vector3.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// A synthetic CT (HU) of a block of bone in air around the world's origin: its top towards +z, a
/// canal along z through it, and a nerve along y that the CT does not show. All mm.
struct DrillPhantom
{
  static constexpr double HalfWidth = 12.0; ///< along x and y
  static constexpr double HalfHeight = 8.0; ///< along z
  static constexpr double CanalX = -7.0;    ///< x of its axis; y = 0
  static constexpr double CanalRadius = 2.0;
  static constexpr double NerveX = 4.0; ///< x of its axis
  static constexpr double NerveZ = 4.0;
  static constexpr double NerveRadius = 1.0;
  static constexpr double Iso = 250.0; ///< HU; the bone's surface

  vtkSmartPointer<vtkImageData> Ct;    ///< 16-bit
  vtkSmartPointer<vtkImageData> Nerve; ///< label 1

  /// mm to the bone, negative inside.
  static double BoneDistance(const Vector3& pointWorld);
  /// mm to the nerve, negative inside.
  static double NerveDistance(const Vector3& pointWorld);
};

/// `spacing` in mm; the columns of `direction` are the grid's axes in the world. Throws InputError
/// if it needs more than the free memory, and Cancelled.
PALPATESCENE_EXPORT DrillPhantom MakeDrillPhantom(const Vector3& spacing, const Matrix3& direction,
                                                  const ProgressFunction& progress);

/// Writes volume and mask with an ending such as "nrrd", and a scene, a hand path and a drill
/// script (block.scene.json, hand.csv, strokes.json) that drill a groove above the nerve and come
/// too close to it. Throws InputError.
PALPATESCENE_EXPORT void WriteDrillPhantom(const DrillPhantom& phantom,
                                           const std::filesystem::path& folder,
                                           const std::string& ending);
} // namespace palpate
