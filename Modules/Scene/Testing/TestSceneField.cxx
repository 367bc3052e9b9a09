#include "SceneField.h"

#include "FieldOfImage.h"
#include "FilterRun.h"
#include "LabelField.h"
#include "LabelImages.h"
#include "RandomShapes.h"
#include "RayCaster.h"

#include <gtest/gtest.h>

namespace palpate::scene_field_test
{
namespace
{
bool GoOn(double, const std::string&)
{
  return true;
}

// A sphere of value 100 in an image of 0, and a segmentation on a coarser grid: label 1 where x <
// 0, label 2 where x > 20, outside of the sphere.
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

TEST_F(SceneFieldWithin, ContainsOnlyTheStructure)
{
  const RayCaster caster(MakeIsoFieldWithin(this->Image, 50.0, this->Labels, {this->Half},
                                            FieldInterpolation::Trilinear, 0.0, GoOn));
  const FieldHit left = caster.CastWorld({{-40.0, 0.0, 0.0}, Vector3::UnitX()}, 0.0, 100.0);
  ASSERT_EQ(left.Kind, HitKind::Surface);
  // Voxel centres lie at half millimetres.
  EXPECT_NEAR(left.Position[0], -12.0, 0.5);
  // On the other side the sphere ends at the label's border: half-way between the differing coarse
  // voxels, to half a fine voxel, since labels are matched to the nearest.
  const FieldHit right = caster.CastWorld({{40.0, 0.0, 0.0}, -Vector3::UnitX()}, 0.0, 100.0);
  ASSERT_EQ(right.Kind, HitKind::Surface);
  EXPECT_NEAR(right.Position[0], 0.0, 0.5 + 1e-6);
}

TEST_F(SceneFieldWithin, RejectsStructureOutsideTheImage)
{
  this->Half.Value = 2;
  EXPECT_THROW(MakeIsoFieldWithin(this->Image, 50.0, this->Labels, {this->Half},
                                  FieldInterpolation::Trilinear, 0.0, GoOn),
               FilterError);
}

// A sphere of 6 mm, off the lattice, in a volume around the same place with this many nodes along
// each axis.
Segmentation SphereIn(int nodes)
{
  test::LabelGrid grid;
  grid.Size = {{nodes, nodes, nodes}};
  grid.CenterOnOrigin();
  Segmentation sphere;
  sphere.Layers = {test::MakeLabelImage(grid, [](double x, double y, double z)
                                        { return std::hypot(x - 1.3, y + 0.4, z) < 6.0; })};
  sphere.Segments.resize(1);
  sphere.Segments[0].Label = sphere.Segments[0].Value = 1;
  return sphere;
}

std::shared_ptr<const ScalarField> FieldOfSphere(int nodes, FieldInterpolation interpolation)
{
  const Segmentation sphere = SphereIn(nodes);
  return MakeSegmentField(sphere, sphere.Segments, interpolation, 1.0, GoOn);
}

TEST(SceneFieldOfSegments, MemoryDoesNotDependOnImageSize)
{
  for (const auto interpolation :
       {FieldInterpolation::Trilinear, FieldInterpolation::TricubicBSpline})
  {
    const auto field = FieldOfSphere(64, interpolation);
    const auto larger = FieldOfSphere(128, interpolation);
    EXPECT_EQ(field->Bytes(), larger->Bytes());
    EXPECT_EQ(field->Grid().Size(), larger->Grid().Size());
    // Close around the sphere, the volume's border is the field's.
    EXPECT_EQ(FieldOfSphere(16, interpolation)->Grid().Size(), (std::array<int, 3>{16, 16, 16}));
  }
}

// Compared with a field of the whole volume.
TEST(SceneFieldOfSegments, SurfaceEqualsThatOfTheWholeVolume)
{
  const Segmentation sphere = SphereIn(64);
  LabelField distance;
  FieldSamples labels;
  const FieldGrid grid = GridOfImage(sphere.Layers[0]);
  ASSERT_TRUE(SamplesOfImage(sphere.Layers[0], labels).IsOk());
  ASSERT_TRUE(LabelField::Make(labels, grid, 1, 1.0, distance).IsOk());
  for (const auto interpolation :
       {FieldInterpolation::Trilinear, FieldInterpolation::TricubicBSpline})
  {
    FieldBuilder builder(grid);
    builder.SetInterpolation(interpolation);
    builder.AddMaterial({builder.AddChannel(distance.Samples()), 0.0});
    std::shared_ptr<const ScalarField> whole;
    ASSERT_TRUE(builder.Build(whole).IsOk());
    const RayCaster oracle(whole);
    const RayCaster caster(FieldOfSphere(64, interpolation));
    // Positions are computed from another origin, and B-spline coefficients are floats of 4 mm.
    const double tolerance = interpolation == FieldInterpolation::Trilinear ? 1e-9 : 1e-5;
    test::Random random(4411);
    for (int sample = 0; sample < 500; ++sample)
    {
      const Vector3 from = 25.0 * test::RandomDirection(random);
      const FieldRay ray{from, (4.0 * test::RandomDirection(random) - from).normalized()};
      const FieldHit expected = oracle.CastWorld(ray, 0.0, 60.0);
      const FieldHit hit = caster.CastWorld(ray, 0.0, 60.0);
      ASSERT_EQ(hit.Kind, expected.Kind);
      ASSERT_NEAR(hit.T, expected.T, tolerance);
    }
  }
}

TEST_F(SceneFieldWithin, CanBeCancelled)
{
  EXPECT_THROW(MakeIsoFieldWithin(this->Image, 50.0, this->Labels, {this->Half},
                                  FieldInterpolation::Trilinear, 0.0,
                                  [](double part, const std::string&) { return part < 0.9; }),
               Cancelled);
}
} // namespace
} // namespace palpate::scene_field_test
