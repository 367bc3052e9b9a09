#include "BodyOverlap.h"

#include "BodyComparison.h"
#include "ComparedCases.h"
#include "MaskSurface.h"
#include "RandomShapes.h"
#include "SurfacePhantoms.h"
#include "SurfaceTopology.h"
#include "WindingNumbers.h"

#include <cmath>
#include <random>

namespace palpate::body_overlap_test
{
namespace
{
using test::BodyOfVoxels;

IndexToWorld Grid(const Vector3& origin, const Vector3& steps)
{
  IndexToWorld toWorld;
  toWorld.Origin = origin;
  toWorld.Axes = steps.asDiagonal();
  return toWorld;
}

// Boxes of whole voxels: their numbers are products.
bool IsInFirst(const Vector3& point)
{
  return point.minCoeff() > 4.5 && point.maxCoeff() < 14.5;
}
bool IsInSecond(const Vector3& point)
{
  return IsInFirst(point - Vector3(3.0, 0.0, 0.0));
}

void ExpectBoxes(const BodyOverlap& overlap)
{
  EXPECT_EQ(overlap.Kind, BodyOverlap::Cells::Voxels);
  EXPECT_EQ(overlap.One, 1000);
  EXPECT_EQ(overlap.Other, 1000);
  EXPECT_EQ(overlap.Both, 700);
  EXPECT_DOUBLE_EQ(overlap.Dice(), 0.7);
  EXPECT_DOUBLE_EQ(overlap.Jaccard(), 700.0 / 1300.0);
}

TEST(BodyOverlap, MasksOnOneGridAreCountedByVoxels)
{
  const IndexToWorld grid = Grid(Vector3::Zero(), Vector3::Ones());
  BodyOverlap overlap;
  ASSERT_TRUE(FindBodyOverlap(BodyOfVoxels({20, 20, 20}, grid, IsInFirst),
                              BodyOfVoxels({20, 20, 20}, grid, IsInSecond), overlap)
                  .IsOk());
  ExpectBoxes(overlap);
}

TEST(BodyOverlap, GridsThatDifferInOriginAndAxesOnlyAreOne)
{
  const ComparedBody one =
      BodyOfVoxels({20, 20, 20}, Grid(Vector3::Zero(), Vector3::Ones()), IsInFirst);
  // x runs backwards, y and z are exchanged, and the box begins elsewhere.
  IndexToWorld turned;
  turned.Origin = {25.0, -3.0, 2.0};
  turned.Axes.col(0) = -Vector3::UnitX();
  turned.Axes.col(1) = Vector3::UnitZ();
  turned.Axes.col(2) = Vector3::UnitY();
  const ComparedBody other = BodyOfVoxels({20, 24, 24}, turned, IsInSecond, {2, 0, 1});
  BodyOverlap overlap;
  ASSERT_TRUE(FindBodyOverlap(one, other, overlap).IsOk());
  ExpectBoxes(overlap);
  ASSERT_TRUE(FindBodyOverlap(other, one, overlap).IsOk());
  ExpectBoxes(overlap);
}

TEST(BodyOverlap, MasksOnOtherGridsAreCountedOnCubes)
{
  // The same box, in voxels of half the size that begin a quarter of a voxel away and cover the
  // same space.
  const ComparedBody coarse =
      BodyOfVoxels({20, 20, 20}, Grid(Vector3::Zero(), Vector3::Ones()), IsInFirst);
  const ComparedBody fine =
      BodyOfVoxels({40, 40, 40}, Grid(Vector3::Constant(-0.25), Vector3::Constant(0.5)), IsInFirst);
  BodyOverlap overlap;
  ASSERT_TRUE(FindBodyOverlap(coarse, fine, overlap).IsOk());
  EXPECT_EQ(overlap.Kind, BodyOverlap::Cells::Cubes);
  EXPECT_LT(overlap.Spacing.maxCoeff(), 0.15);
  EXPECT_EQ(overlap.Dice(), 1.0); // each voxel is eight of the others
}

TEST(BodyOverlap, GridsApartByPartsOfAVoxelAreNotOne)
{
  BodyOverlap overlap;
  ASSERT_TRUE(
      FindBodyOverlap(
          BodyOfVoxels({20, 20, 20}, Grid(Vector3::Zero(), Vector3::Ones()), IsInFirst),
          BodyOfVoxels({20, 20, 20}, Grid(Vector3(0.25, 0.0, 0.0), Vector3::Ones()), IsInFirst),
          overlap)
          .IsOk());
  EXPECT_EQ(overlap.Kind, BodyOverlap::Cells::Cubes);
  EXPECT_NEAR(overlap.Dice(), 0.975, 2e-3); // boxes of 10 mm
}

TEST(BodyOverlap, MaskAndModelAreCountedOnTheMasksVoxels)
{
  const IndexToWorld grid = Grid(Vector3(-12.0, -12.0, -12.0), Vector3(0.8, 0.8, 1.6));
  const ComparedBody mask =
      BodyOfVoxels({31, 31, 16}, grid, [](const Vector3& point) { return point.norm() < 10.0; });
  const ComparedBody sphere = test::BodyOfModel(test::SphereModel(10.0));
  BodyOverlap overlap;
  ASSERT_TRUE(FindBodyOverlap(mask, sphere, overlap).IsOk());
  EXPECT_EQ(overlap.Kind, BodyOverlap::Cells::MaskVoxels);
  // The drawing leaves out only what is within 0.01 mm of the sphere.
  EXPECT_NEAR(overlap.Dice(), 1.0, 2e-3);
  EXPECT_EQ(overlap.One,
            static_cast<std::int64_t>(std::llround(mask.Volume() / (0.8 * 0.8 * 1.6))));
}

TEST(BodyOverlap, NumbersOfMaskAndModelAreInTheirOrder)
{
  const ComparedBody mask =
      BodyOfVoxels({31, 31, 31}, Grid(Vector3::Constant(-15.0), Vector3::Ones()),
                   [](const Vector3& point) { return point.norm() < 10.0; });
  const ComparedBody sphere = test::BodyOfModel(test::SphereModel(8.0));
  BodyOverlap overlap;
  ASSERT_TRUE(FindBodyOverlap(mask, sphere, overlap).IsOk());
  EXPECT_GT(overlap.One, overlap.Other);
  BodyOverlap back;
  ASSERT_TRUE(FindBodyOverlap(sphere, mask, back).IsOk());
  EXPECT_EQ(back.One, overlap.Other);
  EXPECT_EQ(back.Other, overlap.One);
  EXPECT_EQ(back.Both, overlap.Both);
}

BodyOverlap OverlapOf(const OrganModel& one, const OrganModel& other)
{
  BodyComparison found;
  EXPECT_TRUE(
      CompareBodies(test::BodyOfModel(one), test::BodyOfModel(other), {}, {}, found).IsOk());
  EXPECT_TRUE(found.Overlap);
  return found.Overlap ? *found.Overlap : BodyOverlap();
}

// Of two balls of radius 1: the share of each that is in the other one (Weisstein, MathWorld,
// "Sphere-Sphere Intersection").
double SharedBall(double shift)
{
  return shift >= 2.0 ? 0.0 : (4.0 + shift) * (2.0 - shift) * (2.0 - shift) / 16.0;
}

OrganModel Shifted(const OrganModel& model, const Vector3& shift)
{
  const auto& surface = std::get<SurfaceModel>(model);
  std::array<std::vector<double>, 3> coefficients;
  for (int axis = 0; axis < 3; ++axis)
  {
    coefficients[static_cast<std::size_t>(axis)] = surface.Coefficients(axis);
    coefficients[static_cast<std::size_t>(axis)][0] += std::sqrt(4.0 * M_PI) * shift[axis];
  }
  return SurfaceModel(surface.Degree(), coefficients);
}

TEST(ModelOverlap, OfShiftedSpheresIsALens)
{
  for (const double shift : {1e-3, 0.2, 1.0, 1.7, 1.99, 2.5})
  {
    const BodyOverlap overlap =
        OverlapOf(test::SphereModel(20.0), test::SphereModel(20.0, {20.0 * shift, 0.0, 0.0}));
    EXPECT_EQ(overlap.Kind, BodyOverlap::Cells::None);
    EXPECT_NEAR(overlap.Dice(), SharedBall(shift), 1e-5) << shift;
  }
}

TEST(ModelOverlap, OfShiftedEllipsoidsIsThatOfSpheresOfOneRadius)
{
  std::mt19937 random(12);
  std::uniform_real_distribution<double> semiAxis(8.0, 30.0);
  std::normal_distribution<double> normal(0.0, 0.5);
  for (int trial = 0; trial < 10; ++trial)
  {
    const Vector3 axes(semiAxis(random), semiAxis(random), semiAxis(random));
    const Vector3 shift(normal(random), normal(random), normal(random)); // of the unit ball
    const OrganModel one = test::EllipsoidModel(axes);
    const BodyOverlap overlap = OverlapOf(one, Shifted(one, axes.cwiseProduct(shift)));
    EXPECT_NEAR(overlap.Dice(), SharedBall(shift.norm()), 1e-5) << trial;
  }
}

TEST(ModelOverlap, OfABodyWithinAnotherIsItsVolume)
{
  const BodyOverlap overlap =
      OverlapOf(test::EllipsoidModel({9.0, 12.0, 15.0}), test::SphereModel(17.0, {0.5, 0.3, 0.1}));
  EXPECT_NEAR(overlap.Both, 4.0 / 3.0 * M_PI * 9.0 * 12.0 * 15.0, 1e-12 * overlap.Both);
  EXPECT_NEAR(overlap.Other, 4.0 / 3.0 * M_PI * std::pow(17.0, 3), 1e-12 * overlap.Other);
}

TEST(ModelOverlap, OfAModelWithItselfIsWhole)
{
  test::Random random(8);
  for (const OrganModel& model :
       {OrganModel(test::RandomOrgan(random, 12)), OrganModel(test::BumpyTube(random, 8))})
  {
    EXPECT_NEAR(OverlapOf(model, model).Dice(), 1.0, 1e-12);
  }
}

// An independent implementation: centres of cubes inside both by the radius in their direction.
TEST(ModelOverlap, OfRandomOrgansIsWhatCubesCount)
{
  test::Random random(31);
  for (int trial = 0; trial < 3; ++trial)
  {
    const RadialModel one = test::RandomOrgan(random, 8);
    const RadialModel other(8, test::RandomOrgan(random, 8).Coefficients(),
                            one.CenterWorld() + Vector3(7.0, -4.0, 3.0));
    const auto isIn = [](const RadialModel& model, const Vector3& point)
    {
      const Vector3 offset = point - model.CenterWorld();
      return offset.norm() < model.Radius(offset.normalized());
    };
    constexpr double Step = 0.7; // mm
    constexpr int Half = 70;
    double counts[3] = {};
    for (int i = -Half; i <= Half; ++i)
    {
      for (int j = -Half; j <= Half; ++j)
      {
        for (int k = -Half; k <= Half; ++k)
        {
          const Vector3 point = one.CenterWorld() + Step * Vector3(i + 0.31, j + 0.17, k + 0.43);
          const bool isInOne = isIn(one, point);
          const bool isInOther = isIn(other, point);
          counts[0] += isInOne ? 1.0 : 0.0;
          counts[1] += isInOther ? 1.0 : 0.0;
          counts[2] += isInOne && isInOther ? 1.0 : 0.0;
        }
      }
    }
    // Of some 100,000 cubes, the errors at the boundary's 15,000 cancel but for 1e-3.
    EXPECT_NEAR(OverlapOf(one, other).Dice(), 2.0 * counts[2] / (counts[0] + counts[1]), 1e-3);
  }
}

TEST(MaskBoundary, IsHalfWayBetweenVoxels)
{
  const ComparedBody box =
      BodyOfVoxels({20, 20, 20}, Grid(Vector3::Zero(), Vector3::Ones()), IsInFirst);
  Vector3 low = Vector3::Constant(100.0);
  Vector3 high = Vector3::Constant(-100.0);
  for (const Vector3& point : box.Surface().Points)
  {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  EXPECT_EQ(low, Vector3::Constant(4.5));
  EXPECT_EQ(high, Vector3::Constant(14.5));
  EXPECT_TRUE(box.IsClosed());
  EXPECT_EQ(box.Volume(), 1000.0);
}

TEST(MaskBoundary, EnclosesExactlyTheVoxelsOfAnyMask)
{
  std::mt19937 random(3);
  for (int trial = 0; trial < 20; ++trial)
  {
    std::bernoulli_distribution isInside(0.1 + 0.04 * trial);
    VoxelMask mask;
    mask.Size = {9, 8, 7};
    mask.Spacing = {1.0, 1.0, 1.0};
    for (int voxel = 0; voxel < 9 * 8 * 7; ++voxel)
    {
      mask.Inside.push_back(isInside(random) ? 1 : 0);
    }
    IndexedMesh mesh;
    ASSERT_TRUE(MakeMaskBoundary(mask, {}, mesh).IsOk());
    const SurfaceTopology topology = DescribeTopology(mesh);
    EXPECT_EQ(topology.BoundaryEdges, 0);
    EXPECT_EQ(topology.OrientationConflicts, 0);
    EXPECT_EQ(topology.DegenerateTriangles, 0);
    EXPECT_GT(topology.Volume, 0.0);
    EXPECT_LT(topology.Volume, static_cast<double>(mask.Count()) + 1e-9);
    // The centre of every voxel is on its side.
    std::vector<std::int16_t> numbers;
    ASSERT_TRUE(FindWindingNumbers(mesh, {Vector3::Zero(), Matrix3::Identity(), mask.Size}, numbers)
                    .IsOk());
    for (std::size_t voxel = 0; voxel < numbers.size(); ++voxel)
    {
      ASSERT_EQ(numbers[voxel], static_cast<int>(mask.Inside[voxel]));
    }
  }
}

TEST(MaskBoundary, FacesOutwardsInMirroredGrids)
{
  const IndexToWorld mirrored = Grid(Vector3(19.0, 0.0, 0.0), Vector3(-1.0, 1.0, 1.0));
  const ComparedBody box = BodyOfVoxels({20, 20, 20}, mirrored, IsInFirst);
  std::vector<double> distances;
  ASSERT_TRUE(
      box.DistancesOf({Vector3::Constant(9.5), Vector3(9.5, 9.5, 18.5)}, {}, distances).IsOk());
  EXPECT_NEAR(distances[0], -5.0, 1e-9);
  EXPECT_NEAR(distances[1], 4.0, 1e-9);
}

TEST(MaskBoundary, HasTheSurfaceOfACavity)
{
  const auto isShell = [](const Vector3& point)
  {
    const double radius = (point - Vector3::Constant(10.0)).norm();
    return radius < 8.0 && radius > 3.0;
  };
  const ComparedBody shell =
      BodyOfVoxels({21, 21, 21}, Grid(Vector3::Zero(), Vector3::Ones()), isShell);
  std::vector<double> distances;
  ASSERT_TRUE(shell.DistancesOf({Vector3::Constant(10.0)}, {}, distances).IsOk());
  EXPECT_NEAR(distances[0], 3.0, 0.5);
}
} // namespace
} // namespace palpate::body_overlap_test
