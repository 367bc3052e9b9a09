#include "DrillExport.h"

#include "DrillContextCases.h"
#include "MeshConversion.h"
#include "Progress.h"
#include "SceneIsoSurface.h"
#include "SurfaceFile.h"
#include "SurfaceTopology.h"
#include "VolumeFile.h"

#include "vtkMatrix3x3.h"

namespace palpate::drill_export_test
{
namespace
{
constexpr double ToolRadius = 2.0; // mm
const Vector3 Place(2.5, -2.0, 1.5);
const double SphereVolume = 4.0 / 3.0 * M_PI * std::pow(ToolRadius, 3);

class DrillExport : public testing::Test
{
protected:
  // A scene with a drilled sphere.
  static std::shared_ptr<DrillContext> Drilled(const SceneSettings& settings)
  {
    auto context = test::BenchOf(settings);
    test::ContextCuts(context).Cut(Place, Place);
    return context;
  }
  static void ExpectSameGrid(vtkImageData* a, vtkImageData* b, double tolerance)
  {
    for (int n = 0; n < 3; ++n)
    {
      EXPECT_EQ(a->GetDimensions()[n], b->GetDimensions()[n]);
      EXPECT_NEAR(a->GetSpacing()[n], b->GetSpacing()[n], tolerance);
      EXPECT_NEAR(a->GetOrigin()[n], b->GetOrigin()[n], tolerance);
    }
    for (int n = 0; n < 9; ++n)
    {
      EXPECT_NEAR(a->GetDirectionMatrix()->GetData()[n], b->GetDirectionMatrix()->GetData()[n],
                  tolerance);
    }
  }

  test::BoneFiles Files;
};

TEST_F(DrillExport, ImageKeepsGridTypeAndUncutVoxels)
{
  const auto context = Drilled(this->Files.Scene());
  const auto image = DrilledImage(*context, 0, test::GoOn);
  ASSERT_EQ(image->GetScalarType(), VTK_SHORT);
  ExpectSameGrid(image, this->Files.Ct, 1e-12);
  const auto* before = static_cast<const short*>(this->Files.Ct->GetScalarPointer());
  const auto* after = static_cast<const short*>(image->GetScalarPointer());
  int gone = 0;
  for (vtkIdType voxel = 0; voxel < image->GetNumberOfPoints(); ++voxel)
  {
    const double distance = (Vector3(image->GetPoint(voxel)) - Place).norm() - ToolRadius;
    // Partial volume reaches as far as a cell's diagonal, 0.7 mm.
    ASSERT_TRUE(distance < 0.75 || after[voxel] == before[voxel]) << voxel;
    ASSERT_LE(after[voxel], before[voxel]);
    ASSERT_TRUE(distance > -0.1 || after[voxel] < test::BoneFiles::Iso) << voxel;
    gone += after[voxel] < before[voxel] ? 1 : 0;
  }
  EXPECT_GT(gone, 300);
}

TEST_F(DrillExport, SurfaceEnclosesTheRemainingVolume)
{
  const auto whole = test::BenchOf(this->Files.Scene());
  const double before =
      MeasureEnclosed(ToIndexedMesh(DrilledSurface(*whole, 0, test::GoOn))).Volume;
  const auto context = Drilled(this->Files.Scene());
  const auto surface = DrilledSurface(*context, 0, test::GoOn);
  EXPECT_NEAR(before - MeasureEnclosed(ToIndexedMesh(surface)).Volume, SphereVolume,
              0.01 * SphereVolume);
  for (const char* name : {"left.stl", "left.vtp"})
  {
    WriteSurface(this->Files.Folder / name, surface);
    EXPECT_NEAR(MeasureEnclosed(ToIndexedMesh(ReadSurface(this->Files.Folder / name))).Volume,
                MeasureEnclosed(ToIndexedMesh(surface)).Volume, 1e-3); // single precision
  }
}

// With integers up to 1000 a surface deviates by a thousandth of a voxel.
TEST_F(DrillExport, ReadBackImageHasTheSameSurface)
{
  const auto context = Drilled(this->Files.Scene());
  const auto image = DrilledImage(*context, 0, test::GoOn);
  const double left =
      MeasureEnclosed(ToIndexedMesh(DrilledSurface(*context, 0, test::GoOn))).Volume;
  for (const char* name : {"left.nii.gz", "left.nrrd"})
  {
    WriteImage(this->Files.Folder / name, image);
    const Volume back = ReadVolume(this->Files.Folder / name);
    ExpectSameGrid(back.Image, image, 1e-5); // NIfTI has single precision
    const auto surface = MakeIsoSurface(back.Image, test::BoneFiles::Iso, test::GoOn);
    EXPECT_NEAR(MeasureEnclosed(ToIndexedMesh(surface)).Volume, left, 1e-3 * left);
  }
}

TEST_F(DrillExport, RemovesLabelsOfRemovedCentresOnly)
{
  const auto context = Drilled(this->Files.SceneOfLabels());
  const auto image = DrilledImage(*context, 0, test::GoOn);
  ASSERT_EQ(image->GetScalarType(), this->Files.Labels->GetScalarType());
  ExpectSameGrid(image, this->Files.Labels, 1e-12);
  const auto* before = static_cast<const unsigned char*>(this->Files.Labels->GetScalarPointer());
  const auto* after = static_cast<const unsigned char*>(image->GetScalarPointer());
  int gone = 0;
  for (vtkIdType voxel = 0; voxel < image->GetNumberOfPoints(); ++voxel)
  {
    const double distance = (Vector3(image->GetPoint(voxel)) - Place).norm() - ToolRadius;
    if (before[voxel] != test::BoneFiles::BoneLabel || distance > 0.25)
    {
      ASSERT_EQ(after[voxel], before[voxel]) << voxel;
    }
    else if (distance < -0.25)
    {
      ASSERT_EQ(after[voxel], 0);
      ++gone;
    }
  }
  EXPECT_GT(gone, 100);
}

TEST_F(DrillExport, IsCancelled)
{
  const auto never = [](double, const std::string&) { return false; };
  for (const SceneSettings& settings : {this->Files.Scene(), this->Files.SceneOfLabels()})
  {
    const auto context = Drilled(settings);
    EXPECT_THROW(DrilledImage(*context, 0, never), Cancelled);
    EXPECT_THROW(DrilledSurface(*context, 0, never), Cancelled);
  }
}
} // namespace
} // namespace palpate::drill_export_test
