#include "BrushVoxels.h"
#include "CorrectedCases.h"
#include "CorrectedMask.h"
#include "MaskEdits.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <ctime>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace palpate::brush_voxels_test
{
namespace
{
using namespace palpate::test;
using Index = std::array<int, 3>;

constexpr Index SmallImage{21, 18, 15};

// Turned, of unequal steps.
IndexToWorld ObliqueFrame()
{
  const Matrix3 turn = Eigen::AngleAxisd(0.7, Vector3(1.0, 2.0, -0.5).normalized()).matrix();
  return {Vector3(3.0, -7.0, 11.0), turn * Vector3(0.9, 1.3, 2.1).asDiagonal()};
}

BrushStroke StrokeOf(BrushStroke::Path path, double radius)
{
  BrushStroke stroke;
  stroke.PointsWorld = std::make_shared<const BrushStroke::Path>(std::move(path));
  stroke.Radius = radius;
  return stroke;
}

// By the cases of the nearest point.
double DistanceToSegment(const Vector3& point, const Vector3& a, const Vector3& b)
{
  if ((b - a).dot(point - a) <= 0.0)
  {
    return (point - a).norm();
  }
  if ((a - b).dot(point - b) <= 0.0)
  {
    return (point - b).norm();
  }
  return (b - a).cross(point - a).norm() / (b - a).norm();
}

double DistanceToPath(const Vector3& point, const BrushStroke::Path& path)
{
  double least = (point - path.front()).norm();
  for (std::size_t n = 1; n < path.size(); ++n)
  {
    least = std::min(least, DistanceToSegment(point, path[n - 1], path[n]));
  }
  return least;
}

template <typename Visit>
void ForEachIn(const Index& size, const Visit& visit)
{
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        visit(Index{i, j, k});
      }
    }
  }
}

Vector3 CenterOf(const IndexToWorld& toWorld, const Index& index)
{
  return toWorld(Vector3(index[0], index[1], index[2]));
}

TEST(BrushVoxels, StrokeIsTheUnionOfBallsAlongItsSegments)
{
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> share(-0.1, 1.1);
  const IndexToWorld toWorld = ObliqueFrame();
  for (int round = 0; round < 40; ++round)
  {
    BrushStroke::Path path;
    for (int n = 0; n < 1 + round % 4; ++n)
    {
      path.push_back(
          toWorld(Vector3(share(random) * 20.0, share(random) * 17.0, share(random) * 14.0)));
    }
    const double radius = 0.5 + 4.0 * std::abs(share(random));
    VoxelMask made;
    ASSERT_TRUE(MakeStroke(StrokeOf(path, radius), toWorld, SmallImage, made).IsOk());
    long long count = 0;
    ForEachIn(SmallImage,
              [&](const Index& index)
              {
                const double distance = DistanceToPath(CenterOf(toWorld, index), path);
                count += HasVoxel(made, index) ? 1 : 0;
                if (std::abs(distance - radius) > 1e-9) // rounding
                {
                  EXPECT_EQ(HasVoxel(made, index), distance < radius);
                }
              });
    EXPECT_EQ(count, made.Count()) << "none beyond the image";
  }
}

TEST(BrushVoxels, BallHasItsVoxelsByBruteForce)
{
  VoxelMask made;
  const Vector3 center = CorrectedMiddle();
  ASSERT_TRUE(MakeStroke(StrokeOf({center}, 6.0), CorrectedFrame(), CorrectedImage, made).IsOk());
  long long count = 0;
  ForEachVoxel(
      [&](const Index& index, const Vector3& place)
      {
        const bool isInside = (place - center).squaredNorm() <= 36.0; // whole numbers
        EXPECT_EQ(HasVoxel(made, index), isInside);
        count += isInside ? 1 : 0;
      });
  EXPECT_EQ(made.Count(), count);
  EXPECT_GT(count, 400);
}

TEST(BrushVoxels, DiscPaintsOneSliceWhereverItsPlaneIs)
{
  for (const double height : {-0.9999999, -0.6, 0.0, 0.9, 1.0, 1.0000001, 3.0})
  {
    const Vector3 center = CorrectedMiddle() + Vector3(0.0, 0.0, height);
    BrushStroke stroke = StrokeOf({center, center + Vector3(9.0, 2.0, 0.0)}, 4.0);
    stroke.SliceNormal = Vector3(0.0, 0.0, -2.0);
    VoxelMask made;
    ASSERT_TRUE(MakeStroke(stroke, CorrectedFrame(), CorrectedImage, made).IsOk());
    int slices = 0;
    for (int k = 0; k < CorrectedImage[2]; ++k)
    {
      long long count = 0;
      long long wanted = 0;
      for (int j = 0; j < CorrectedImage[1]; ++j)
      {
        for (int i = 0; i < CorrectedImage[0]; ++i)
        {
          Vector3 place = CenterOf(CorrectedFrame(), {i, j, k});
          place.z() = center.z();
          count += HasVoxel(made, {i, j, k}) ? 1 : 0;
          wanted += DistanceToPath(place, *stroke.PointsWorld) <= 4.0 ? 1 : 0;
        }
      }
      slices += count > 0 ? 1 : 0;
      EXPECT_TRUE(count == 0 || count == wanted) << height;
      EXPECT_TRUE(count == 0 || std::abs(2.0 * (k - 16) - height) <= 1.001) << height;
    }
    EXPECT_EQ(slices, 1) << height;
  }
}

// 100 before a wall across i, 200 from it on.
double StepAt(const Index& index, int wall)
{
  return index[0] < wall ? 100.0 : 200.0;
}

TEST(BrushVoxels, EdgesStopAStrokeAtAStepInTheImage)
{
  const Vector3 from = CenterOf(CorrectedFrame(), {20, 31, 16});
  const BrushStroke stroke = StrokeOf({from, from + Vector3(20.0, 0.0, 0.0)}, 5.0);
  VoxelMask all;
  VoxelMask kept;
  ASSERT_TRUE(MakeStroke(stroke, CorrectedFrame(), CorrectedImage, all).IsOk());
  ASSERT_TRUE(MakeStrokeToEdges(
                  stroke, CorrectedFrame(), CorrectedImage,
                  [](const Index& index) { return StepAt(index, 30); }, kept)
                  .IsOk());
  ForEachIn(CorrectedImage, [&](const Index& index)
            { EXPECT_EQ(HasVoxel(kept, index), HasVoxel(all, index) && index[0] < 30); });
}

TEST(BrushVoxels, EdgesStopANoisyStroke)
{
  std::mt19937_64 random(11);
  std::normal_distribution<double> noise(0.0, 8.0); // a twelfth of the step
  std::vector<double> values;
  ForEachIn(CorrectedImage,
            [&](const Index& index) { values.push_back(StepAt(index, 30) + noise(random)); });
  const auto value = [&values](const Index& index)
  {
    return values[static_cast<std::size_t>(
        (index[2] * CorrectedImage[1] + index[1]) * CorrectedImage[0] + index[0])];
  };
  const Vector3 from = CenterOf(CorrectedFrame(), {20, 31, 16});
  BrushStroke stroke = StrokeOf({from, from + Vector3(20.0, 0.0, 0.0)}, 6.0);
  stroke.SliceNormal = Vector3::UnitZ();
  VoxelMask all;
  VoxelMask kept;
  ASSERT_TRUE(MakeStroke(stroke, CorrectedFrame(), CorrectedImage, all).IsOk());
  ASSERT_TRUE(MakeStrokeToEdges(stroke, CorrectedFrame(), CorrectedImage, value, kept).IsOk());
  int before = 0;
  int taken = 0;
  ForEachIn(CorrectedImage,
            [&](const Index& index)
            {
              before += HasVoxel(all, index) && index[0] < 30 ? 1 : 0;
              taken += HasVoxel(kept, index) ? 1 : 0;
              EXPECT_FALSE(HasVoxel(kept, index) && index[0] >= 30);
            });
  EXPECT_GT(taken, 0.97 * before) << "within three standard deviations are 99.7 %";
}

TEST(BrushVoxels, EdgesKeepWhatIsJoinedToTheStart)
{
  const Vector3 from = CenterOf(CorrectedFrame(), {20, 31, 16});
  const BrushStroke stroke = StrokeOf({from, from + Vector3(20.0, 0.0, 0.0)}, 5.0);
  VoxelMask kept;
  const auto wall = [](const Index& index) {
    return index[0] == 30 ? 200.0 : index[0] < 0 ? std::nan("") : 100.0;
  };
  ASSERT_TRUE(MakeStrokeToEdges(stroke, CorrectedFrame(), CorrectedImage, wall, kept).IsOk());
  EXPECT_TRUE(HasVoxel(kept, {29, 31, 16}));
  EXPECT_FALSE(HasVoxel(kept, {31, 31, 16})) << "the same value, beyond the wall";
  ASSERT_TRUE(
      MakeStrokeToEdges(
          stroke, CorrectedFrame(), CorrectedImage, [](const Index&) { return std::nan(""); }, kept)
          .IsOk());
  EXPECT_EQ(kept.Count(), 0) << "there is no image";
}

TEST(BrushVoxels, EdgesTakeSingleVoxelsOfNoiseOnly)
{
  const Vector3 from = CenterOf(CorrectedFrame(), {20, 31, 16});
  BrushStroke stroke = StrokeOf({from, from + Vector3(20.0, 0.0, 0.0)}, 5.0);
  stroke.SliceNormal = Vector3::UnitZ();
  const auto isOutlier = [](const Index& index)
  { return (index[0] == 24 || index[0] == 32 || index[0] == 33) && index[1] == 31; };
  VoxelMask kept;
  ASSERT_TRUE(MakeStrokeToEdges(
                  stroke, CorrectedFrame(), CorrectedImage,
                  [&](const Index& index)
                  { return isOutlier(index) || index[0] < 16 ? 200.0 : 100.0; },
                  kept)
                  .IsOk());
  EXPECT_TRUE(HasVoxel(kept, {24, 31, 16}));
  EXPECT_FALSE(HasVoxel(kept, {32, 31, 16})) << "two are more than noise";
  EXPECT_FALSE(HasVoxel(kept, {33, 31, 16}));
  EXPECT_TRUE(HasVoxel(kept, {16, 31, 16}));
  EXPECT_FALSE(HasVoxel(kept, {15, 31, 16})) << "the disc's tip beyond an edge is no noise";
}

// In a box of its own, which strokes widen.
CorrectedMask BallUnderCorrection(MaskCorrection::Barrier barrier = {})
{
  return {InBox(BallMask(12.0), {19, 18, 9}, {45, 44, 23}), CorrectedFrame(), CorrectedImage,
          std::move(barrier)};
}

BrushStroke Painted(const Vector3& from, const Vector3& to, double radius, bool erases = false)
{
  BrushStroke stroke = StrokeOf({CorrectedMiddle() + from, CorrectedMiddle() + to}, radius);
  stroke.Erases = erases;
  return stroke;
}

std::vector<CorrectionStep> ManySteps()
{
  BrushStroke disc = Painted(Vector3(-8.0, 6.0, 4.0), Vector3(5.0, 9.0, 4.0), 3.0);
  disc.SliceNormal = Vector3::UnitZ();
  const VoxelEdit edit{std::make_shared<const std::vector<IndexRun>>(std::vector<IndexRun>{
                           {{1, 2, 3}, 5}, {{30, 31, 16}, 4}, {{60, 62, 31}, 2}}),
                       false};
  return {Painted(Vector3(12.0, 0.0, 0.0), Vector3(28.0, 4.0, 0.0), 5.0), // beyond the box
          disc,
          Painted(Vector3(0.0, 0.0, 0.0), Vector3(0.0, 9.0, 0.0), 4.0, true),
          SurfacePull{CorrectedMiddle() - Vector3(12.0, 0.0, 0.0), 3.0, {}, 6.0, 0.0},
          edit,
          SliceCopy{2, 18, 23},
          SliceFilling{2, 18, 23},
          Painted(Vector3(-12.0, 0.0, 0.0), Vector3(-14.0, 0.0, 6.0), 2.0, true),
          IslandRemoval{},
          SliceCopy{0, 40, 50},
          Painted(Vector3(0.0, -12.0, 0.0), Vector3(0.0, -29.0, 0.0), 3.0)};
}

TEST(BrushVoxels, UndoAllTheWayGivesTheSameBits)
{
  CorrectedMask corrected = BallUnderCorrection();
  std::vector<VoxelMask> states{corrected.Mask()};
  for (const CorrectionStep& step : ManySteps())
  {
    const Status status = corrected.Apply(step);
    ASSERT_TRUE(status.IsOk()) << status.Message();
    states.push_back(corrected.Mask());
    EXPECT_TRUE(states.back().Inside != states[states.size() - 2].Inside ||
                std::holds_alternative<IslandRemoval>(step));
    EXPECT_EQ(corrected.Mask().Inside.size(),
              corrected.Mask().Offset(0, 0, corrected.Mask().Size[2]));
  }
  for (std::size_t n = states.size() - 1; n > 0; --n)
  {
    ASSERT_TRUE(corrected.Undo());
    EXPECT_EQ(corrected.Mask().Inside, states[n - 1].Inside) << n;
    EXPECT_EQ(corrected.Mask().StartIndex, states[n - 1].StartIndex) << n;
    EXPECT_EQ(corrected.Mask().Size, states[n - 1].Size) << n;
  }
  EXPECT_FALSE(corrected.Undo());
  EXPECT_EQ(&corrected.Mask(), &corrected.Start());
}

TEST(BrushVoxels, StrokesChangeNoCopyAndNoStart)
{
  CorrectedMask corrected = BallUnderCorrection();
  const std::vector<unsigned char> start = corrected.Start().Inside;
  ASSERT_TRUE(corrected.Apply(Painted({12, 0, 0}, {16, 0, 0}, 3.0)).IsOk());
  CorrectedMask copy = corrected;
  const std::vector<unsigned char> before = copy.Mask().Inside;
  ASSERT_TRUE(corrected.Apply(Painted({0, 0, 0}, {0, 8, 0}, 3.0, true)).IsOk());
  EXPECT_NE(corrected.Mask().Inside, before);
  EXPECT_EQ(copy.Mask().Inside, before);
  ASSERT_TRUE(copy.Undo());
  EXPECT_EQ(copy.Mask().Inside, start);
  EXPECT_EQ(corrected.Start().Inside, start);
}

TEST(BrushVoxels, StrokeAddsAndErasesItsVoxelsOnly)
{
  CorrectedMask corrected = BallUnderCorrection();
  const VoxelMask before = corrected.Mask();
  const BrushStroke add = Painted({10, 0, 0}, {20, 0, 0}, 4.0);
  const BrushStroke remove = Painted({-10, 0, 0}, {-4, 3, 0}, 4.0, true);
  VoxelMask added;
  VoxelMask removed;
  ASSERT_TRUE(MakeStroke(add, CorrectedFrame(), CorrectedImage, added).IsOk());
  ASSERT_TRUE(MakeStroke(remove, CorrectedFrame(), CorrectedImage, removed).IsOk());
  ASSERT_TRUE(corrected.Apply(add).IsOk());
  ASSERT_TRUE(corrected.Apply(remove).IsOk());
  ForEachIn(CorrectedImage,
            [&](const Index& index)
            {
              const bool wanted =
                  (HasVoxel(before, index) || HasVoxel(added, index)) && !HasVoxel(removed, index);
              EXPECT_EQ(HasVoxel(corrected.Mask(), index), wanted);
            });
}

TEST(BrushVoxels, NeighbourIsUntouchedByEveryStep)
{
  const auto isOther = [](const Index& index) { return index[0] > 45 || index[2] > 22; };
  CorrectedMask corrected = BallUnderCorrection(isOther);
  ASSERT_TRUE(corrected.Apply(Painted({0, 0, 0}, {25, 0, 0}, 5.0)).IsOk());
  ASSERT_TRUE(corrected.Apply(SliceCopy{2, 16, 24}).IsOk());
  ASSERT_TRUE(corrected.Apply(SliceCopy{0, 40, 47}).IsOk());
  EXPECT_TRUE(HasVoxel(corrected.Mask(), {45, 31, 16}));
  ForEachIn(CorrectedImage, [&](const Index& index)
            { EXPECT_FALSE(isOther(index) && HasVoxel(corrected.Mask(), index)); });
}

TEST(BrushVoxels, CopiedSliceIsTheOtherOne)
{
  for (const int axis : {0, 1, 2})
  {
    const auto a = static_cast<std::size_t>(axis);
    CorrectedMask corrected = BallUnderCorrection();
    const VoxelMask before = corrected.Mask();
    const int from = axis == 2 ? 14 : 36;
    const int to = from + 4;
    ASSERT_TRUE(corrected.Apply(SliceCopy{axis, from, to}).IsOk());
    ForEachIn(CorrectedImage,
              [&](const Index& index)
              {
                Index source = index;
                source[a] = index[a] == to ? from : index[a];
                EXPECT_EQ(HasVoxel(corrected.Mask(), index), HasVoxel(before, source));
              });
  }
}

// In a slice, mm, by brute force; the boundary is half a voxel away.
double SignedInSlice(const VoxelMask& mask, const Index& index)
{
  double least = std::numeric_limits<double>::infinity();
  const bool isInside = HasVoxel(mask, index);
  for (int j = 0; j < CorrectedImage[1]; ++j)
  {
    for (int i = 0; i < CorrectedImage[0]; ++i)
    {
      if (HasVoxel(mask, {i, j, index[2]}) != isInside)
      {
        least = std::min(least, std::hypot(i - index[0], j - index[1]));
      }
    }
  }
  return isInside ? least - 0.5 : 0.5 - least;
}

TEST(BrushVoxels, FillingIsBetweenTheSignedDistances)
{
  // A disc and a smaller one aside; what is between them is not theirs.
  const VoxelMask start = MaskWhere(
      [](const Vector3& point)
      {
        const Vector3 arm = point - CorrectedMiddle();
        return (std::abs(arm.z() + 4.0) < 0.5 && arm.head<2>().norm() < 10.0) ||
               (std::abs(arm.z() - 4.0) < 0.5 &&
                (arm.head<2>() - Eigen::Vector2d(5.0, 1.0)).norm() < 6.0) ||
               (std::abs(arm.z()) < 0.5 && arm.head<2>().norm() > 20.0 && arm.x() > 22.0);
      });
  CorrectedMask corrected(start, CorrectedFrame(), CorrectedImage);
  ASSERT_TRUE(corrected.Apply(SliceFilling{2, 18, 14}).IsOk()) << "in any order";
  for (int j = 10; j < 52; j += 1)
  {
    for (int i = 10; i < 60; i += 1)
    {
      const double low = SignedInSlice(start, {i, j, 14});
      const double high = SignedInSlice(start, {i, j, 18});
      for (int k = 15; k < 18; ++k)
      {
        const double between = (low * (18 - k) + high * (k - 14)) / 4.0;
        if (std::abs(between) > 1e-5) // distances are floats
        {
          EXPECT_EQ(HasVoxel(corrected.Mask(), {i, j, k}), between > 0.0);
        }
      }
      EXPECT_EQ(HasVoxel(corrected.Mask(), {i, j, 14}), HasVoxel(start, {i, j, 14}));
      EXPECT_EQ(HasVoxel(corrected.Mask(), {i, j, 18}), HasVoxel(start, {i, j, 18}));
    }
  }
}

TEST(BrushVoxels, RefusesWithoutAnEffect)
{
  CorrectedMask corrected = BallUnderCorrection();
  const std::vector<unsigned char> before = corrected.Mask().Inside;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BrushStroke flat = Painted({0, 0, 0}, {1, 0, 0}, 3.0);
  flat.SliceNormal = Vector3::Zero();
  const auto runs = [](IndexRun run) {
    return VoxelEdit{std::make_shared<const std::vector<IndexRun>>(1, run), false};
  };
  for (const CorrectionStep& step : std::vector<CorrectionStep>{
           BrushStroke{}, StrokeOf({}, 3.0), flat, Painted({nan, 0, 0}, {0, 0, 0}, 3.0),
           Painted({0, 0, 0}, {0, 0, 0}, nan), Painted({0, 0, 0}, {0, 0, 0}, 0.05),
           Painted({0, 0, 0}, {0, 0, 0}, 51.0), Painted({0, 0, 0}, {0, 0, 0}, 30.0, true),
           StrokeOf(BrushStroke::Path(10001, Vector3::Zero()), 3.0), VoxelEdit{},
           runs({{-1, 0, 0}, 1}), runs({{0, 0, 32}, 1}), runs({{60, 0, 0}, 5}),
           runs({{0, 0, 0}, 0}), SliceCopy{3, 0, 1}, SliceCopy{2, 0, 32}, SliceCopy{2, -1, 1},
           SliceFilling{2, 16, 31}, SliceFilling{-1, 16, 17}})
  {
    EXPECT_FALSE(corrected.Apply(step).IsOk());
  }
  EXPECT_EQ(corrected.Mask().Inside, before);
  EXPECT_TRUE(corrected.Steps().empty());
  EXPECT_TRUE(corrected.Apply(Painted({900, 0, 0}, {1e300, 0, 0}, 3.0)).IsOk()) << "beyond all";
  EXPECT_EQ(corrected.Mask().Inside, before);
  const IndexToWorld fine{Vector3::Zero(), 0.01 * Matrix3::Identity()};
  VoxelMask made;
  EXPECT_FALSE(
      MakeStroke(StrokeOf({Vector3(5, 5, 5)}, 50.0), fine, {1100, 1100, 1100}, made).IsOk())
      << "without reserving memory for it";
}

TEST(BrushVoxels, TheLastVoxelsAreNotErased)
{
  CorrectedMask corrected = BallUnderCorrection();
  const auto erase = [&corrected](double x) {
    return corrected.Apply(Painted({x, 0, 0}, {x, 0, 0}, 20.0, true)).IsOk();
  };
  ASSERT_TRUE(corrected.Apply(Painted({0, 25, 0}, {0, 25, 0}, 3.0)).IsOk());
  ASSERT_TRUE(erase(-15.0));
  ASSERT_TRUE(erase(15.0)) << "what was painted is left";
  ASSERT_TRUE(corrected.Undo());
  ASSERT_TRUE(erase(15.0)) << "again";
  EXPECT_FALSE(corrected.Apply(Painted({0, 25, 0}, {0, 25, 0}, 3.0, true)).IsOk());
  EXPECT_EQ(corrected.Steps().size(), 3U);
}

TEST(BrushVoxels, StrokesAreBounded)
{
  CorrectedMask corrected(BallMask(4.0), CorrectedFrame(), CorrectedImage);
  for (std::size_t n = 0; n < CorrectedMask::MostStrokes; ++n)
  {
    ASSERT_TRUE(corrected.Apply(Painted({0, 0, 0}, {0, 0, 0}, 1.0)).IsOk());
  }
  EXPECT_FALSE(corrected.Apply(Painted({0, 0, 0}, {0, 0, 0}, 1.0)).IsOk());
  EXPECT_TRUE(corrected.Apply(IslandRemoval{}).IsOk()) << "an edit begins again";
  EXPECT_TRUE(corrected.Apply(Painted({0, 0, 0}, {0, 0, 0}, 1.0)).IsOk());
}

// Of processor time, the least of five, ms, for a stroke of 60 mm and 10 mm radius on a structure
// that fills a part of an image of 512 x 512 x 600. The first stroke copies the mask.
double StrokeTime(const Index& first, const Index& size)
{
  VoxelMask mask;
  mask.StartIndex = first;
  mask.Size = size;
  mask.Spacing = {0.7, 0.7, 0.7};
  mask.Inside.assign(mask.Offset(0, 0, mask.Size[2]), 0);
  mask.Inside[mask.Offset(1, 1, 1)] = 1;
  CorrectedMask corrected(std::move(mask), {Vector3::Zero(), 0.7 * Matrix3::Identity()},
                          {512, 512, 600});
  BrushStroke::Path path;
  for (int n = 0; n <= 60; ++n)
  {
    path.emplace_back(120.0 + n, 150.0 + 10.0 * std::sin(0.1 * n), 200.0);
  }
  BrushStroke stroke = StrokeOf(path, 10.0);
  double least = std::numeric_limits<double>::infinity();
  for (int n = 0; n < 6; ++n)
  {
    const std::clock_t begin = std::clock();
    EXPECT_TRUE(corrected.Apply(stroke).IsOk());
    const double milliseconds = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    least = n == 0 ? least : std::min(least, milliseconds);
    stroke.Erases = !stroke.Erases;
  }
  return least;
}

TEST(BrushVoxels, StrokeTakesTheTimeOfItsBoxNotOfTheMask)
{
  const double small = StrokeTime({140, 160, 240}, {160, 120, 80});
  const double large = StrokeTime({-1, -1, -1}, {514, 514, 602});
  this->RecordProperty("microseconds", static_cast<int>(1e3 * large));
  EXPECT_LT(large, 2.0 * small + 2.0) << "a hundred times the voxels";
}
} // namespace
} // namespace palpate::brush_voxels_test
