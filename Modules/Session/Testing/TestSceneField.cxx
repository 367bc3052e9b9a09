#include "SceneField.h"

#include "FilterRun.h"
#include "LabelImages.h"
#include "RayCaster.h"

#include <cstdio>
#include <gtest/gtest.h>

namespace palpate
{
namespace
{
bool GoOn(double, const std::string&)
{
  return true;
}

// A ball of 100 in an image of 0, and a segmentation on a coarser grid: label 1 where x < 0, label
// 2 where x > 20, where there is no ball.
class SceneFieldWithin : public testing::Test
{
protected:
  void SetUp() override
  {
    test::LabelGrid fine;
    fine.Size = {{48, 40, 40}};
    fine.CenterOnOrigin();
    this->Image = test::MakeLabelImage<short>(
        fine, [](double x, double y, double z) { return std::hypot(x, y, z) < 12.0; }, 100);
    test::LabelGrid coarse;
    coarse.Size = {{30, 26, 24}};
    coarse.Spacing = {{2.0, 2.0, 2.0}};
    coarse.CenterOnOrigin();
    this->Labels.Layers = {test::MakeLabelImage(
        coarse, [](double x, double, double) { return x < 0.0; }, 1)};
    this->Half.Label = 1;
    this->Half.Value = 1;
  }

  vtkSmartPointer<vtkImageData> Image;
  Segmentation Labels;
  Segment Half;
};

TEST_F(SceneFieldWithin, OnlyWhatLiesInTheStructureIsThere)
{
  const RayCaster caster(MakeIsoFieldWithin(this->Image, 50.0, this->Labels, {this->Half},
                                            FieldInterpolation::Trilinear, 0.0, GoOn));
  const FieldHit left = caster.CastWorld({{-40.0, 0.0, 0.0}, Vector3::UnitX()}, 0.0, 100.0);
  ASSERT_EQ(left.Kind, HitKind::Surface);
  // The voxels' centres lie at half millimetres.
  EXPECT_NEAR(left.Position[0], -12.0, 0.5);
  // From the other side the ball ends where the label does: half way between the coarse voxels that
  // differ, to half a fine voxel, since labels are matched by the nearest.
  const FieldHit right = caster.CastWorld({{40.0, 0.0, 0.0}, -Vector3::UnitX()}, 0.0, 100.0);
  ASSERT_EQ(right.Kind, HitKind::Surface);
  EXPECT_NEAR(right.Position[0], 0.0, 0.5 + 1e-6);
}

TEST_F(SceneFieldWithin, AStructureBesideTheImageIsRefused)
{
  this->Half.Value = 2;
  EXPECT_THROW(MakeIsoFieldWithin(this->Image, 50.0, this->Labels, {this->Half},
                                  FieldInterpolation::Trilinear, 0.0, GoOn),
               FilterError);
}

TEST_F(SceneFieldWithin, MemoryIsToldBesideThatOfAllNodes)
{
  const auto field = MakeIsoField(this->Image, {50.0}, FieldInterpolation::Trilinear, GoOn);
  const double dense = 4.0 * 48 * 40 * 40;
  const double percent = 100.0 * static_cast<double>(field->Memory().Bytes) / dense;
  const std::string text = MemoryText(*field);
  double told = 0.0;
  ASSERT_EQ(std::sscanf(text.c_str(), "%*f MB, %lf %% of", &told), 1) << text;
  EXPECT_NEAR(told, percent, 0.06) << "one digit";
}

TEST_F(SceneFieldWithin, CanBeCancelled)
{
  EXPECT_THROW(MakeIsoFieldWithin(this->Image, 50.0, this->Labels, {this->Half},
                                  FieldInterpolation::Trilinear, 0.0,
                                  [](double part, const std::string&) { return part < 0.9; }),
               Cancelled);
}
} // namespace
} // namespace palpate
