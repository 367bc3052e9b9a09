#include "DrilledCases.h"
#include "RayCaster.h"

#include <cmath>

namespace palpate::drilled_accuracy_test
{
namespace
{
using test::CutPath;
using test::Drill;
using test::ScannedBone;
using test::VersionOf;

// A sphere of bone with blurred edges, in voxels of a size (mm) in an oblique grid.
ScannedBone BoneOf(double spacing, double radius, std::mt19937_64& random)
{
  const int side = 2 * static_cast<int>(std::ceil((radius + 1.0) / spacing)) + 2;
  const FieldGrid grid({side, side, side}, {5.0, -3.0, 2.0}, Vector3::Constant(spacing),
                       test::RandomOrientation(random));
  return {grid, radius, 0.8};
}

double SphereVolume(double radius)
{
  return 4.0 / 3.0 * M_PI * std::pow(radius, 3);
}

Vector3 RandomOffset(double length, std::mt19937_64& random)
{
  std::uniform_real_distribution<double> part(-0.5, 0.5);
  return length * Vector3(part(random), part(random), part(random));
}

TEST(DrilledAccuracy, SphereRemovesItsVolumeWithinOnePercentFromThreeVoxels)
{
  std::mt19937_64 random(51);
  for (const double spacing : {0.3, 0.5, 1.0})
  {
    for (const double voxels : {3.0, 4.5, 6.0})
    {
      const double radius = voxels * spacing;
      const ScannedBone bone = BoneOf(spacing, radius + 4.0 * spacing + 2.0, random);
      const auto field = bone.Make();
      for (int trial = 0; trial < 4; ++trial)
      {
        const auto drilled = Drill(*field);
        const Vector3 place = bone.Center + RandomOffset(spacing, random);
        CutPath(*drilled, CutTool::Sphere(radius), place, place);
        EXPECT_NEAR(drilled->RemovedVolume() / SphereVolume(radius), 1.0, 0.01) << spacing;
      }
    }
  }
}

TEST(DrilledAccuracy, StrokeOfTicksRemovesACapsuleWithinOnePercent)
{
  std::mt19937_64 random(52);
  for (const double spacing : {0.3, 0.5, 1.0})
  {
    const double radius = 3.0 * spacing;
    const ScannedBone bone = BoneOf(spacing, 12.0 * spacing, random);
    const auto drilled = Drill(*bone.Make());
    const Vector3 path = 6.0 * spacing * Vector3(0.6, -0.64, 0.48);
    const Vector3 from = bone.Center - 0.5 * path + RandomOffset(spacing, random);
    constexpr int Ticks = 60;
    for (int tick = 0; tick < Ticks; ++tick)
    {
      CutPath(*drilled, CutTool::Sphere(radius), from + tick * path / Ticks,
              from + (tick + 1) * path / Ticks);
    }
    const double capsule = SphereVolume(radius) + M_PI * radius * radius * path.norm();
    EXPECT_NEAR(drilled->RemovedVolume() / capsule, 1.0, 0.01) << spacing;
  }
}

// At the blurred edge: the intersection of the bone's sphere and the tool's. The bone's radius is
// the one whose volume is that of removing everything: interpolated, its edge lies slightly farther
// out than it was. The rim of the hole is sharp and loses what a straight line between nodes cuts
// off, of second order too.
TEST(DrilledAccuracy, CountsOnlyVolumeInsideTheMaterial)
{
  std::mt19937_64 random(53);
  constexpr double Tool = 2.5;
  for (const double spacing : {0.5, 0.25})
  {
    const ScannedBone bone = BoneOf(spacing, 10.0, random);
    const auto drilled = Drill(*bone.Make());
    CutPath(*drilled, CutTool::Sphere(12.0), bone.Center, bone.Center);
    const double surface = std::cbrt(drilled->RemovedVolume() / SphereVolume(1.0));
    EXPECT_NEAR(surface, 10.0 + 0.8 * std::atanh(0.6), 0.1);
    for (const double between : {9.0, 10.0, 11.0})
    {
      drilled->Undo();
      const Vector3 place = bone.Center + between * Vector3(0.48, 0.6, 0.64);
      CutPath(*drilled, CutTool::Sphere(Tool), place, place);
      const double lens = M_PI * std::pow(surface + Tool - between, 2) *
                          (between * between + 2.0 * between * (surface + Tool) -
                           3.0 * std::pow(surface - Tool, 2)) /
                          (12.0 * between);
      EXPECT_NEAR(drilled->RemovedVolume() / lens, 1.0, 0.14 * spacing * spacing) << between;
    }
  }
}

TEST(DrilledAccuracy, RemovedVolumeConvergesWithOrderTwo)
{
  // The mean over positions of the sphere in a voxel, so that the rest is systematic.
  const auto error = [](double spacing)
  {
    std::mt19937_64 random(54);
    const ScannedBone bone = BoneOf(spacing, 7.0, random);
    const auto drilled = Drill(*bone.Make());
    double sum = 0.0;
    constexpr int Trials = 20;
    for (int trial = 0; trial < Trials; ++trial)
    {
      const Vector3 place = bone.Center + RandomOffset(spacing, random);
      CutPath(*drilled, CutTool::Sphere(3.0), place, place);
      sum += std::pow(drilled->RemovedVolume() / SphereVolume(3.0) - 1.0, 2);
      drilled->Undo();
    }
    return std::sqrt(sum / Trials);
  };
  // A quarter and a sixteenth, or nearly.
  const double coarse = error(1.0);
  EXPECT_LT(error(0.5), coarse / 3.5);
  EXPECT_LT(error(0.25), coarse / 13.0);
}

TEST(DrilledAccuracy, CanalRadiusEqualsTheToolsWithinATenthOfAVoxel)
{
  std::mt19937_64 random(55);
  constexpr double Spacing = 0.5;
  constexpr double Radius = 2.0;
  const ScannedBone bone = BoneOf(Spacing, 12.0, random);
  const auto drilled = Drill(*bone.Make());
  const Vector3 along = Vector3(0.6, -0.64, 0.48);
  for (int tick = 0; tick < 100; ++tick)
  {
    CutPath(*drilled, CutTool::Sphere(Radius), bone.Center + (0.3 * tick - 15.0) * along,
            bone.Center + (0.3 * (tick + 1) - 15.0) * along);
  }
  const RayCaster caster(VersionOf(*drilled));
  std::uniform_real_distribution<double> place(-7.0, 7.0);
  for (int n = 0; n < 500; ++n)
  {
    const Vector3 from = bone.Center + place(random) * along;
    const Vector3 out = along.cross(RandomOffset(1.0, random)).normalized();
    const FieldHit hit = caster.CastWorld({from, out}, 0.0, 20.0, OnlyMaterial(0));
    ASSERT_EQ(hit.Kind, HitKind::Surface);
    ASSERT_TRUE(hit.IsEntering);
    EXPECT_NEAR(hit.T, Radius, 0.1 * Spacing);
  }
}
} // namespace
} // namespace palpate::drilled_accuracy_test
