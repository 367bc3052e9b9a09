#include "SceneRegion.h"

#include "InputError.h"
#include "LabelImages.h"
#include "Progress.h"
#include "RayCaster.h"
#include "SceneField.h"
#include "SceneIsoSurface.h"

#include "vtkPolyData.h"

#include <gtest/gtest.h>

namespace palpate::scene_region_test
{
namespace
{
bool GoOn(double, const std::string&)
{
  return true;
}

// Balls of 100 and 200 around the origin with radii of 14 and 7 mm in an image of 0, and a
// segmentation whose label 4, "left", is x > 0.
class SceneRegionTest : public testing::Test
{
protected:
  void SetUp() override
  {
    test::LabelGrid grid;
    grid.Size = {{40, 40, 40}};
    grid.CenterOnOrigin();
    this->Image.Image = test::MakeLabelImage<short>(
        grid, [](double x, double y, double z) { return std::hypot(x, y, z) < 14.0; }, 100);
    const auto core = test::MakeLabelImage<short>(
        grid, [](double x, double y, double z) { return std::hypot(x, y, z) < 7.0; }, 100);
    auto* voxels = static_cast<short*>(this->Image.Image->GetScalarPointer());
    const auto* added = static_cast<const short*>(core->GetScalarPointer());
    for (vtkIdType v = 0; v < core->GetNumberOfPoints(); ++v)
    {
      voxels[v] = static_cast<short>(voxels[v] + added[v]);
    }
    this->Labels.Source = "skull.nii.gz";
    this->Labels.Layers = {test::MakeLabelImage(
        grid, [](double x, double, double) { return x > 0.0; }, 4)};
    this->Labels.Segments.resize(1);
    this->Labels.Segments[0].Label = this->Labels.Segments[0].Value = 4;
    this->Labels.Segments[0].Name = "left";
    this->Bone.File = "ct.nrrd";
    this->Bone.Iso = 50.0;
  }
  Volume Make(const Segmentation* mask = nullptr) const
  {
    return MakeRegion(this->Bone, this->Image, mask, GoOn);
  }
  std::string Refusal(const Segmentation* mask = nullptr) const
  {
    try
    {
      this->Make(mask);
    }
    catch (const InputError& error)
    {
      return error.what();
    }
    return {};
  }
  // The x of the first surface of the region from the left or the right.
  static double SurfaceFrom(double x, const Volume& region)
  {
    const RayCaster caster(MakeIsoField(region.Image, {0.0}, FieldInterpolation::Trilinear, GoOn));
    const Vector3 towards = x < 0.0 ? Vector3::UnitX() : Vector3(-Vector3::UnitX());
    const FieldHit hit = caster.CastWorld({{x, 0.5, 0.5}, towards}, 0.0, 100.0);
    EXPECT_EQ(hit.Kind, HitKind::Surface);
    return hit.Position[0];
  }

  Volume Image;
  Segmentation Labels;
  SceneStructure Bone;
};

TEST_F(SceneRegionTest, WithoutUpperLimitItIsTheIsoSurface)
{
  this->Bone.WithinFile = "skull.nii.gz";
  this->Bone.WithinLabel = "4";
  const Volume region = this->Make(&this->Labels);
  const Volume plain = this->Image;
  const RayCaster whole(MakeIsoField(plain.Image, {50.0}, FieldInterpolation::Trilinear, GoOn));
  const FieldHit hit = whole.CastWorld({{40.0, 0.5, 0.5}, -Vector3::UnitX()}, 0.0, 100.0);
  EXPECT_NEAR(SurfaceFrom(40.0, region), hit.Position[0], 1e-6);
}

TEST_F(SceneRegionTest, UpperLimitLeavesOutBrighterVoxels)
{
  this->Bone.IsoUpper = 150.0;
  const Volume region = this->Make();
  const auto* margins = static_cast<const float*>(region.Image->GetScalarPointer());
  const auto* values = static_cast<const short*>(this->Image.Image->GetScalarPointer());
  for (vtkIdType v = 0; v < region.Image->GetNumberOfPoints(); ++v)
  {
    ASSERT_EQ(margins[v] >= 0.0F, values[v] == 100) << values[v];
  }
  const auto surface = MakeIsoSurface(region.Image, 0.0, GoOn);
  double inner = 1e9;
  for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
  {
    inner = std::min(inner, Vector3(surface->GetPoint(p)).norm());
  }
  EXPECT_NEAR(inner, 7.0, 1.0) << "the core is hollow";
}

TEST_F(SceneRegionTest, NoShellAroundWhatIsBrighter)
{
  this->Bone.Iso = 120.0; // between both balls
  this->Bone.IsoUpper = 180.0;
  EXPECT_NE(this->Refusal().find("no voxel with a value from 120 to 180"), std::string::npos)
      << this->Refusal();
}

TEST_F(SceneRegionTest, EndsHalfWayBetweenVoxelsAtTheBorderOfALabel)
{
  this->Bone.WithinFile = "skull.nii.gz";
  this->Bone.WithinLabel = "left";
  const Volume region = this->Make(&this->Labels);
  EXPECT_NEAR(SurfaceFrom(-40.0, region), 0.0, 1e-4) << "voxel centres lie at half millimetres";
  EXPECT_NEAR(SurfaceFrom(40.0, region), 14.0, 0.6);
}

TEST_F(SceneRegionTest, RefusalsNameWhatIsMissing)
{
  this->Bone.WithinFile = "skull.nii.gz";
  this->Bone.WithinLabel = "right";
  EXPECT_NE(this->Refusal(&this->Labels).find("skull.nii.gz"), std::string::npos)
      << this->Refusal(&this->Labels);
  this->Bone.WithinLabel = "4";
  this->Bone.Iso = 500.0;
  const std::string none = this->Refusal(&this->Labels);
  EXPECT_NE(none.find("ct.nrrd"), std::string::npos) << none;
  EXPECT_NE(none.find("label 4 of skull.nii.gz"), std::string::npos) << none;
  EXPECT_NE(none.find("0 to 200"), std::string::npos) << none;
  this->Bone.WithinFile.clear();
  this->Bone.Iso = -5.0;
  this->Bone.IsoUpper = 999.0;
  EXPECT_NE(this->Refusal().find("only voxels"), std::string::npos) << this->Refusal();
}

TEST_F(SceneRegionTest, IsALabelMapForDrilledResults)
{
  this->Bone.IsoUpper = 150.0;
  const Volume region = this->Make();
  const auto labels = LabelsOfRegion(region.Image);
  EXPECT_EQ(labels->GetScalarType(), VTK_UNSIGNED_CHAR);
  EXPECT_EQ(labels->GetScalarComponentAsDouble(30, 20, 20, 0), 1.0); // 10.5 mm from the centre
  EXPECT_EQ(labels->GetScalarComponentAsDouble(20, 20, 20, 0), 0.0);
}

TEST_F(SceneRegionTest, CanBeCancelled)
{
  this->Bone.IsoUpper = 150.0;
  EXPECT_THROW(MakeRegion(this->Bone, this->Image, nullptr,
                          [](double, const std::string&) { return false; }),
               Cancelled);
}
} // namespace
} // namespace palpate::scene_region_test
