#pragma once

#include "ImageWriter.h"
#include "LabelImages.h"
#include "StudyPhantoms.h"
#include "TemporaryFolder.h"

#include <cmath>

namespace palpate::test
{
/// A segmentation with twelve labels, so that only the first is visible and touchable unasked:
/// label 1 is a ball of bone round the origin, label 12 a nerve in its centre, the others are
/// voxels in a corner.
struct ForbiddenPhantom
{
  static constexpr double BoneRadius = 11.0; // mm
  static constexpr double NerveRadius = 4.0; // mm
  static constexpr int Bone = 1;
  static constexpr int Nerve = 12;

  ForbiddenPhantom()
  {
    LabelGrid grid;
    grid.Size = {{30, 30, 30}};
    grid.CenterOnOrigin();
    const auto labels = MakeLabelImage(
        grid, [](double x, double y, double z) { return std::hypot(x, y, z) < BoneRadius; }, Bone);
    for (vtkIdType voxel = 0; voxel < labels->GetNumberOfPoints(); ++voxel)
    {
      if (Vector3(labels->GetPoint(voxel)).norm() < NerveRadius)
      {
        static_cast<unsigned char*>(labels->GetScalarPointer())[voxel] = Nerve;
      }
    }
    for (int label = 2; label < Nerve; ++label)
    {
      for (int i = 0; i < 3; ++i)
      {
        *static_cast<unsigned char*>(labels->GetScalarPointer(i, 2 * label, 0)) =
            static_cast<unsigned char>(label);
      }
    }
    WriteImage(this->File, labels);
  }

  /// Soft bone, drilled by a sphere of 3 mm.
  static StudyState Drilled(StudyState state)
  {
    state.Structures.at(0).Drill.Wear = 2.0;
    state.Tool.Radius = 3.0;
    // The hand begins outside: in the centre it would be within the hollow of the nerve.
    state.Placement.Scale = 1.0;
    state.Placement.CenterWorld = Vector3(BoneRadius + 5.0, 0.0, 0.0);
    state.Fit.Frequency = 8;
    return state;
  }
  static StudyState Forbidden(StudyState state, int label = Nerve)
  {
    for (SceneStructure& structure : state.Structures)
    {
      structure.IsForbidden = structure.IsForbidden || structure.Id == label;
    }
    return state;
  }

  TemporaryFolder Folder;
  std::filesystem::path File = Folder / "labels.nii.gz";
};
} // namespace palpate::test
