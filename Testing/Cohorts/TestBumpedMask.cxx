#include "BumpedMask.h"

#include "SphereQuadrature.h"

#include <cmath>
#include <gtest/gtest.h>
#include <tuple>

namespace palpate::bumped_mask_test
{
namespace
{
using test::SurfaceBump;

constexpr double Radius = 22.0; // mm
const Vector3 Place = Vector3(1.0, 2.0, -0.5).normalized();

RadialModel Sphere()
{
  return {0, {Radius * std::sqrt(4.0 * M_PI)}, Vector3::Zero()};
}

SurfaceBump BumpOf(double height, const Vector3& place = Place)
{
  return {Sphere(), place, height, 20.0};
}

/// The voxels of the sphere around a centre, 0.5 x 0.5 x 3 mm, in axes turned about z.
struct SphereMask
{
  VoxelMask Mask;
  IndexToWorld ToWorld;
};

SphereMask MaskAround(const Vector3& center)
{
  SphereMask made;
  made.Mask.StartIndex = {3, -5, 1};
  made.Mask.Size = {120, 120, 22};
  made.Mask.Spacing = {0.5, 0.5, 3.0};
  made.Mask.Inside.resize(made.Mask.Offset(0, 0, 22));
  made.ToWorld.Axes << 0.4, -0.3, 0.0, 0.3, 0.4, 0.0, 0.0, 0.0, 3.0;
  const Vector3 middle = Vector3(3.0, -5.0, 1.0) + Vector3(59.5, 59.5, 10.5);
  made.ToWorld.Origin = -(made.ToWorld.Axes * middle);
  for (int k = 0; k < 22; ++k)
  {
    for (int j = 0; j < 120; ++j)
    {
      for (int i = 0; i < 120; ++i)
      {
        const Vector3 point = made.ToWorld(Vector3(i + 3, j - 5, k + 1));
        made.Mask.Inside[made.Mask.Offset(i, j, k)] = (point - center).norm() < Radius ? 1 : 0;
      }
    }
  }
  return made;
}

TEST(SurfaceBump, FallsAsASquaredCosineOfTheDistance)
{
  const SurfaceBump bump = BumpOf(2.0);
  EXPECT_DOUBLE_EQ(bump.AlongNormal(Place), 2.0);
  // At a chord of 5 mm, a quarter of the extent; at 10 mm there is nothing left.
  const Vector3 across = Place.unitOrthogonal();
  const auto at = [&](double chord)
  {
    const double angle = 2.0 * std::asin(0.5 * chord / Radius);
    return Vector3(std::cos(angle) * Place + std::sin(angle) * across);
  };
  EXPECT_NEAR(bump.AlongNormal(at(5.0)), 1.0, 1e-12);
  EXPECT_TRUE(bump.Covers(at(9.999)));
  EXPECT_FALSE(bump.Covers(at(10.001)));
  EXPECT_EQ(bump.AlongNormal(at(10.001)), 0.0);
}

TEST(SurfaceBump, MovesAlongTheRadiusByWhatItsNormalNeeds)
{
  const RadialModel oval(2, {70.0, 0, 0, 0, 0, 0, 4.0, 0, 6.0}, Vector3::Zero());
  const SurfaceBump bump(oval, Place, 1.0, 20.0);
  const Vector3 direction = (Place + 0.1 * Vector3::UnitX()).normalized();
  EXPECT_NEAR(bump.AlongRadius(direction) * oval.Normal(direction).dot(direction),
              bump.AlongNormal(direction), 1e-14);
  EXPECT_GT(bump.AlongRadius(direction), bump.AlongNormal(direction));
}

// Between the spheres with and without a bump: the integral of the cubes of their radii.
double VolumeOfBump(const SurfaceBump& bump)
{
  const SphereQuadrature quadrature(80);
  double volume = 0.0;
  for (std::size_t i = 0; i < quadrature.Directions.size(); ++i)
  {
    const double radius = Radius + bump.AlongRadius(quadrature.Directions[i]);
    volume += quadrature.Weights[i] * (std::pow(radius, 3) - std::pow(Radius, 3)) / 3.0;
  }
  return volume;
}

// Whether the bump is along the slices, and its height.
class BumpOfVoxels : public testing::TestWithParam<std::tuple<bool, double>>
{
};

TEST_P(BumpOfVoxels, AddsTheVolumeOfTheBump)
{
  const auto& [isAlongSlices, height] = GetParam();
  const Vector3 place = isAlongSlices ? Vector3::UnitZ() : Place;
  const SurfaceBump bump = BumpOf(height, place);
  const SurfaceBump none = BumpOf(0.0, place);
  // Spheres that lie otherwise in their voxels, on slices that lie otherwise, since one rounds to
  // voxels.
  constexpr int Grids = 32;
  double added = 0.0;
  for (int grid = 0; grid < Grids; ++grid)
  {
    const Vector3 center(0.56 * grid / Grids, 0.4 * grid / Grids, 1.5 * (grid % 2));
    const double shift = (grid + 0.5) / Grids - 0.5;
    const SphereMask sphere = MaskAround(center);
    const VoxelMask flat = WithBump(sphere.Mask, sphere.ToWorld, center, none, shift);
    const VoxelMask bumped = WithBump(sphere.Mask, sphere.ToWorld, center, bump, shift);
    added +=
        (static_cast<double>(bumped.Count()) - static_cast<double>(flat.Count())) * 0.75 / Grids;
  }
  // 0.022 mm over the bump's 314 mm^2: pixels of 0.5 mm and slices of 3 mm, mean of the grids.
  EXPECT_NEAR(added, VolumeOfBump(bump), 7.0);
}

INSTANTIATE_TEST_SUITE_P(Bumps, BumpOfVoxels,
                         testing::Combine(testing::Bool(), testing::Values(1.0, 3.0)));

TEST(BumpedMask, KeepsVoxelsBeyondTheBump)
{
  const SphereMask sphere = MaskAround(Vector3::Zero());
  const SurfaceBump bump = BumpOf(3.0);
  const VoxelMask bumped = WithBump(sphere.Mask, sphere.ToWorld, Vector3::Zero(), bump, 0.0);
  int changed = 0;
  for (int k = 0; k < 22; ++k)
  {
    for (int j = 0; j < 120; ++j)
    {
      for (int i = 0; i < 120; ++i)
      {
        const std::size_t at = bumped.Offset(i, j, k);
        const Vector3 point = sphere.ToWorld(Vector3(i + 3, j - 5, k + 1));
        if (bumped.Inside[at] != sphere.Mask.Inside[at])
        {
          ++changed;
          ASSERT_TRUE(bump.Covers(point.normalized())) << point.transpose();
        }
      }
    }
  }
  EXPECT_GT(changed, 100);
}
} // namespace
} // namespace palpate::bumped_mask_test
