#include "ForbiddenStructure.h"

#include "DrillContextCases.h"
#include "DrillWatch.h"
#include "Progress.h"
#include "RandomOrientation.h"
#include "RandomShapes.h"

#include "vtkNew.h"
#include "vtkSphereSource.h"

namespace palpate::forbidden_structure_test
{
namespace
{
constexpr double Radius = 3.0; // mm
const Vector3 Center(1.0, -2.0, 4.0);
// Depth of a sphere's fine triangles inside of it.
constexpr double Coarse = 0.01;

ForbiddenStructure Sphere(const Vector3& middle = Center)
{
  vtkNew<vtkSphereSource> source;
  source->SetRadius(Radius);
  source->SetCenter(middle[0], middle[1], middle[2]);
  source->SetThetaResolution(80);
  source->SetPhiResolution(80);
  source->Update();
  return ForbiddenStructure(source->GetOutput());
}

TEST(ForbiddenStructureTest, PointDistanceIsSignedDistanceToTheSurface)
{
  test::Random random(81);
  const ForbiddenStructure sphere = Sphere();
  std::uniform_real_distribution<double> far(0.2, 15.0);
  for (int trial = 0; trial < 2000; ++trial)
  {
    const double from = far(random);
    EXPECT_NEAR(sphere.Distance(Center + from * test::RandomDirection(random)), from - Radius,
                Coarse);
  }
}

TEST(ForbiddenStructureTest, ToolDistanceIsThatOfItsNearestPoint)
{
  test::Random random(82);
  const ForbiddenStructure sphere = Sphere();
  const ToolShape tool = ToolShape::Capsule(1.0, 6.0, 2000);
  for (int trial = 0; trial < 20; ++trial)
  {
    const Matrix3 turn = test::RandomOrientation(random);
    const ToolPose pose{Center + 10.0 * turn.col(2), Eigen::Quaterniond(turn)};
    // With its end towards the sphere; its 2000 points are 0.2 mm apart.
    EXPECT_NEAR(sphere.Distance(tool, pose), 10.0 - 4.0 - Radius, 0.02);
    EXPECT_NEAR(sphere.Distance(ToolShape::Sphere(1.25), pose), 10.0 - 1.25 - Radius, Coarse);
  }
}

TEST(ForbiddenStructureTest, ProtectionEqualsTheDistanceWithinTheBand)
{
  std::mt19937_64 random(83);
  constexpr double Band = 0.9;
  const FieldGrid grid({42, 38, 30}, {-6.0, -9.0, -1.0}, {0.4, 0.35, 0.5},
                       test::RandomOrientation(random));
  const auto none = RemovedDistances::None(grid, Band);
  // Two overlapping structures at the grid's centre.
  const Vector3 middle = grid.PointWorld({20.0, 18.0, 15.0});
  const Vector3 nearby = middle + Vector3(1.5, 1.0, -0.5);
  const auto made = JoinProtections({ProtectionOf(Sphere(middle), *none, test::GoOn),
                                     ProtectionOf(Sphere(nearby), *none, test::GoOn)});
  EXPECT_EQ(made->Band(), Band);
  int near = 0;
  for (int k = 0; k < 30; ++k)
  {
    for (int j = 0; j < 38; ++j)
    {
      for (int i = 0; i < 42; ++i)
      {
        const Vector3 p = grid.PointWorld(Vector3(i, j, k));
        const double distance = std::min((p - middle).norm(), (p - nearby).norm()) - Radius;
        ASSERT_NEAR(made->At(i, j, k), std::clamp(distance, -Band, Band), Coarse);
        near += std::abs(distance) < Band ? 1 : 0;
      }
    }
  }
  EXPECT_GT(near, 1000);
}

TEST(ForbiddenStructureTest, ProtectsNothingFarFromTheGrid)
{
  const FieldGrid grid({20, 20, 20}, Vector3::Zero(), Vector3::Ones(), Matrix3::Identity());
  const auto none = RemovedDistances::None(grid, 2.0);
  const ForbiddenStructure far = Sphere(Vector3(200.0, 0.0, 0.0));
  EXPECT_TRUE(ProtectionOf(far, *none, test::GoOn)->Corners().empty());
}

TEST(ForbiddenStructureTest, ProtectionCanBeCancelled)
{
  const FieldGrid grid({20, 20, 20}, Center - Vector3::Constant(10.0), Vector3::Ones(),
                       Matrix3::Identity());
  EXPECT_THROW(ProtectionOf(Sphere(), *RemovedDistances::None(grid, 2.0),
                            [](double, const std::string&) { return false; }),
               Cancelled);
}

// A nerve in several components of a mask is one structure.
TEST(ForbiddenStructureTest, AllComponentsOfAMaskAreForbidden)
{
  const Vector3 large(-6.0, 0.0, 0.0);
  const Vector3 small(7.0, 1.0, -1.0);
  test::LabelGrid grid;
  grid.CenterOnOrigin();
  Segmentation segmentation;
  segmentation.Layers = {test::MakeLabelImage(grid,
                                              [&](double x, double y, double z)
                                              {
                                                const Vector3 point(x, y, z);
                                                return (point - large).norm() < 5.0 ||
                                                       (point - small).norm() < 3.0;
                                              })};
  Segment segment;
  segment.Value = 1;
  segmentation.Segments = {segment};
  const ForbiddenStructure made(MakeForbiddenSurface(segmentation, segment, test::GoOn));
  constexpr double PartOfVoxel = 0.5; // of 1 mm
  EXPECT_NEAR(made.Distance(large), -5.0, PartOfVoxel);
  EXPECT_NEAR(made.Distance(small), -3.0, PartOfVoxel);
}

TEST(ForbiddenStructureTest, MaskOnAnotherGridSurvivesFullDrilling)
{
  const test::BoneFiles files;
  const auto context = test::BenchOf(files.SceneWithNerve());
  ASSERT_EQ(context->Forbidden().size(), 1U);
  test::ContextCuts cuts(context);
  constexpr int Paths = 12;
  for (int a = 0; a < Paths; ++a)
  {
    for (int b = 0; b < Paths; ++b)
    {
      const Vector3 from(-9.0, 1.5 * a - 9.0, 1.5 * b - 9.0);
      cuts.Cut(from, from + Vector3(18.0, 0.0, 0.0));
    }
  }
  // Volume of the off-centre cylinder within the spherical bone, summed over its sections.
  double left = 0.0;
  constexpr int Steps = 400;
  constexpr double Step = 2.0 * test::BoneFiles::NerveRadius / Steps;
  for (int a = 0; a < Steps; ++a)
  {
    for (int b = 0; b < Steps; ++b)
    {
      const double x = (a + 0.5) * Step - test::BoneFiles::NerveRadius;
      const double y = (b + 0.5) * Step - test::BoneFiles::NerveRadius;
      const double nearby = std::hypot(x + 3.0, y);
      if (std::hypot(x, y) < test::BoneFiles::NerveRadius)
      {
        left += 2.0 * std::sqrt(std::pow(test::BoneFiles::BoneRadius, 2) - nearby * nearby) * Step *
                Step;
      }
    }
  }
  const double sphere = 4.0 / 3.0 * M_PI * std::pow(test::BoneFiles::BoneRadius, 3);
  // The nerve's smooth surface, from voxels of a third of its radius, differs from the cylinder's.
  EXPECT_NEAR(sphere - context->Editor().RemovedVolumes()[0], left, 0.1 * left);
}

// A tick at a position, mm, world.
TouchState At(const Vector3& place)
{
  TouchState state;
  state.HasSample = true;
  state.ProxyWorld = place;
  state.Sample.Orientation = {0.0, 0.0, 0.0, 1.0};
  return state;
}

// The burr's radius is 2 mm; the nerve's axis is 3 mm from the origin, its radius 1.5 mm.
TEST(DrillWatchTest, ReportsEachAlarmOnce)
{
  const test::BoneFiles files;
  DrillWatch watch(test::BenchOf(files.SceneWithNerve()));
  const auto nearby = [](double distance)
  { return At(Vector3(3.0 - 1.5 - 2.0 - distance, 0.0, 0.0)); };
  EXPECT_TRUE(watch.Look(0.0, nearby(4.0)).empty());
  EXPECT_TRUE(watch.Look(1.0, nearby(1.6)).empty());
  const std::vector<std::string> said = watch.Look(2.0, nearby(0.8));
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].find("nerve"), std::string::npos);
  EXPECT_TRUE(watch.Look(3.0, nearby(0.5)).empty()) << "the alarm continues";
  EXPECT_TRUE(watch.Look(4.5, nearby(3.0)).empty());
  EXPECT_EQ(watch.Look(6.0, nearby(0.9)).size(), 1U);
  const DrillApproach& approach = watch.Approaches().at(0);
  EXPECT_EQ(approach.Name, "nerve");
  EXPECT_TRUE(approach.IsAlarmed);
  // Its surface is made from voxels of 0.5 mm.
  EXPECT_NEAR(approach.Least, 0.5, 0.2);
  EXPECT_EQ(approach.LeastTime, 3.0);
  EXPECT_EQ(approach.AlarmSeconds, 2.5);
  EXPECT_EQ(approach.AlarmDistance, 1.25);
}

TEST(DrillWatchTest, IsSilentWithoutSampleOrDrill)
{
  const test::BoneFiles files;
  DrillWatch watch(test::BenchOf(files.SceneWithNerve()));
  EXPECT_TRUE(watch.Look(0.0, TouchState()).empty());
  DrillWatch none(nullptr);
  EXPECT_TRUE(none.Look(0.0, At(Vector3::Zero())).empty());
  EXPECT_TRUE(none.Approaches().empty());
}
} // namespace
} // namespace palpate::forbidden_structure_test
