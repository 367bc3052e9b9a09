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
/// A block of bone round the world's origin, in air, as a CT of it in HU: its top towards +z, a
/// canal along z right through it, and a nerve along y that the CT does not show. All mm.
struct DrillPhantom
{
  static constexpr double HalfWidth = 12.0; ///< along x and y
  static constexpr double HalfHeight = 8.0; ///< along z
  static constexpr double CanalX = -7.0;    ///< of its axis; y = 0
  static constexpr double CanalRadius = 2.0;
  static constexpr double NerveX = 4.0; ///< of its axis
  static constexpr double NerveZ = 4.0;
  static constexpr double NerveRadius = 1.0;
  static constexpr double Iso = 250.0; ///< HU; the bone's surface

  vtkSmartPointer<vtkImageData> Ct;    ///< 16-bit
  vtkSmartPointer<vtkImageData> Nerve; ///< its voxels are 1

  /// mm of what is bone, negative in it.
  static double BoneDistance(const Vector3& pointWorld);
  /// mm to the nerve, negative inside.
  static double NerveDistance(const Vector3& pointWorld);
};

/// `spacing` in mm; `direction` has the grid's axes as columns, in the world. Throws InputError
/// where that takes more than the free memory, and Cancelled.
PALPATESCENE_EXPORT DrillPhantom MakeDrillPhantom(const Vector3& spacing, const Matrix3& direction,
                                                  const ProgressFunction& progress);

/// Writes volume and mask with an ending such as "nrrd", and what drills a groove above the nerve
/// that comes too near to it: a scene, the hand's way and the pedal's script (block.scene.json,
/// hand.csv, strokes.json). Throws InputError.
PALPATESCENE_EXPORT void WriteDrillPhantom(const DrillPhantom& phantom,
                                           const std::filesystem::path& folder,
                                           const std::string& ending);
} // namespace palpate
