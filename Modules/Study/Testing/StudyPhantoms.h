#pragma once

#include "ImageWriter.h"
#include "LabelImages.h"
#include "SceneContacts.h"
#include "StudyPipeline.h"
#include "TemporaryFolder.h"

#include <cmath>

namespace palpate::test
{
/// A volume and its segmentation: label 1 a sphere of 9 mm, label 2 a shape that is not star-shaped
/// from any centre (two spheres joined by a thin bow), label 3 three voxels.
class StudyPhantom
{
public:
  StudyPhantom()
  {
    LabelGrid grid;
    grid.Size = {{56, 40, 28}};
    grid.CenterOnOrigin();
    WriteImage(
        this->Folder / "volume.nii.gz",
        MakeLabelImage<short>(
            grid, [](double x, double y, double z) { return std::hypot(x, y, z) < 16.0; }, 700));
    const auto mask = MakeLabelImage(grid, IsSphere, 1);
    Paint(mask, IsHorseshoe, 2);
    *static_cast<unsigned char*>(mask->GetScalarPointer(1, 1, 1)) = 3;
    WriteImage(this->Folder / "mask.nii.gz", mask);
  }

  /// Both files, and label 1 alone.
  StudyState State() const
  {
    StudyState state;
    state.VolumeFile = this->Folder / "volume.nii.gz";
    state.SegmentationFile = this->Folder / "mask.nii.gz";
    state.Structures.push_back(
        Structure(1, TouchRepresentation::Automatic, state.SegmentationFile));
    state.Fit.Frequency = 8;
    state.Fit.Model = FitSettings::ModelKind::Radial; // so that label 2 has none
    return state;
  }

  /// Of the mask at `file`, with the window's choice for automatic.
  static SceneStructure Structure(int label, const std::string& representation,
                                  const std::filesystem::path& file = "mask.nii.gz")
  {
    SceneStructure structure;
    structure.Id = label;
    structure.Labels = {std::to_string(label)};
    structure.Degree = 4;
    structure.File = file;
    structure.Representation = representation == TouchRepresentation::Automatic
                                   ? TouchRepresentation::ModelOrField
                                   : representation;
    return structure;
  }

  TemporaryFolder Folder;

private:
  static bool IsSphere(double x, double y, double z) { return std::hypot(x + 15.0, y, z) < 9.0; }
  static bool IsHorseshoe(double x, double y, double z)
  {
    const double ring = std::hypot(x - 14.0, y) - 9.0;
    return std::hypot(ring, z) < 3.0 && (x < 18.0 || std::abs(y) > 6.0);
  }
  template <typename Inside>
  static void Paint(vtkImageData* image, const Inside& inside, unsigned char label)
  {
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      double point[3];
      image->GetPoint(i, point);
      auto* voxel = static_cast<unsigned char*>(image->GetScalarPointer()) + i;
      *voxel = inside(point[0], point[1], point[2]) ? label : *voxel;
    }
  }
};

/// The contacts of a state that exist now.
inline std::vector<SceneContact> ContactsIn(const StudyState& state, const StudyPipeline& pipeline)
{
  return ContactsOf(state, [&pipeline](SceneStep step, int id)
                    { return pipeline.NewestProduct(step, id); });
}

/// Delivers until no job is left.
inline void Settle(StudyJobs& jobs)
{
  while (jobs.WaitForResult())
  {
    jobs.Deliver();
  }
}
} // namespace palpate::test
