#include "FieldVolume.h"
#include "RandomOrientation.h"
#include "ShapeField.h"
#include "TopologyPhantoms.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace palpate::shape_field_test
{
namespace
{
using namespace palpate::phantoms;

palpate::ShapeFieldSettings Unsmoothed()
{
  palpate::ShapeFieldSettings settings;
  settings.Smoothing = 0.0;
  // Not above the depth of the boxes' slices, so that both sides of a slice's end count the same.
  settings.SliceClamp = 0.25;
  return settings;
}

// Voxels 2 to 5 along each axis of a box with an empty rim.
palpate::VoxelMask BoxMask(const std::array<double, 3>& spacing)
{
  return MaskOf({8, 8, 8}, spacing,
                [](int i, int j, int k) {
                  return std::min({i, j, k}) >= 2 && std::max({i, j, k}) <= 5;
                });
}

palpate::VoxelMask EllipsoidMask(const std::array<double, 3>& spacing)
{
  return MaskOf({24, 20, 9}, spacing,
                [](int i, int j, int k)
                { return std::hypot((i - 11.2) / 10.0, (j - 9.7) / 8.0, (k - 3.8) / 3.5) < 1.0; });
}

TEST(ShapeField, RunsHalfWayBetweenVoxelCentres)
{
  for (const std::array<double, 3>& spacing :
       {std::array<double, 3>{1.0, 1.0, 1.0}, std::array<double, 3>{0.5, 0.5, 3.0},
        std::array<double, 3>{3.0, 0.5, 0.5}, std::array<double, 3>{0.5, 3.0, 0.5}})
  {
    palpate::ShapeField field;
    ASSERT_TRUE(palpate::MakeShapeField(BoxMask(spacing), Unsmoothed(), field).IsOk());
    for (int axis = 0; axis < 3; ++axis)
    {
      const double step = spacing[static_cast<std::size_t>(axis)];
      for (const double side : {1.5, 5.5})
      {
        Vector3 point(3.5 * spacing[0], 3.5 * spacing[1], 3.5 * spacing[2]);
        point[axis] = side * step;
        // Float values; the field is linear around a face's centre.
        EXPECT_NEAR(field.Sample(point), 0.0, 1e-5 * step) << axis << ' ' << side;
        point[axis] += side < 3.0 ? 0.2 * step : -0.2 * step;
        EXPECT_GT(field.Sample(point), 0.0);
      }
    }
  }
}

TEST(ShapeField, KeepsPlaceWhenEmptyVoxelsAreAdded)
{
  const std::array<double, 3> spacing{0.5, 0.5, 3.0};
  palpate::ShapeField field;
  ASSERT_TRUE(palpate::MakeShapeField(BoxMask(spacing), {}, field).IsOk());
  const palpate::VoxelMask tight = MaskOf({4, 4, 4}, spacing, [](int, int, int) { return true; });
  palpate::ShapeField other;
  ASSERT_TRUE(palpate::MakeShapeField(tight, {}, other).IsOk());
  ASSERT_EQ(field.Grid.Size, other.Grid.Size);
  for (std::size_t node = 0; node < field.Values.size(); ++node)
  {
    ASSERT_NEAR(field.Values[node], other.Values[node], 1e-6); // rounding of the shift
  }
  const Vector3 shift(2.0 * spacing[0], 2.0 * spacing[1], 2.0 * spacing[2]);
  EXPECT_LT((field.Grid.Origin - other.Grid.Origin - shift).norm(), 1e-12);
}

// Whether distances are bounded as between thick slices, of 4 x 4 x 4 voxels.
bool AreThickSlices(const std::array<double, 3>& spacing)
{
  palpate::ShapeField field;
  EXPECT_TRUE(palpate::MakeShapeField(BoxMask(spacing), Unsmoothed(), field).IsOk());
  const double coarsest = *std::max_element(spacing.begin(), spacing.end());
  return *std::min_element(field.Values.begin(), field.Values.end()) >= -0.25 * coarsest;
}

TEST(ShapeField, InterpolatesThickSlicesOnly)
{
  EXPECT_TRUE(AreThickSlices({0.5, 0.5, 3.0}));
  EXPECT_TRUE(AreThickSlices({3.0, 0.5, 0.5}));
  EXPECT_FALSE(AreThickSlices({1.0, 1.0, 1.4}));
  EXPECT_FALSE(AreThickSlices({3.0, 3.0, 0.5})); // no single coarsest axis
}

TEST(ShapeField, BoundsDistancesWithinThickSlices)
{
  // The box's centre is 1 mm from its nearest faces, the clamp is 0.25 * 3 mm.
  const palpate::VoxelMask mask = BoxMask({0.5, 0.5, 3.0});
  const Vector3 centre(3.5 * 0.5, 3.5 * 0.5, 3.5 * 3.0);
  palpate::ShapeFieldSettings settings = Unsmoothed();
  settings.Spacing = 0.5;
  palpate::ShapeField field;
  ASSERT_TRUE(palpate::MakeShapeField(mask, settings, field).IsOk());
  EXPECT_NEAR(field.Sample(centre), 0.75, 0.25); // voxel centres next to it are less deep
  EXPECT_LE(*std::max_element(field.Values.begin(), field.Values.end()), 0.75F);
}

TEST(ShapeField, SpacingFollowsFromSurface)
{
  // 8 x 8 x 4 voxels of 1 mm: 256 mm^2 of faces.
  const palpate::VoxelMask mask =
      MaskOf({10, 10, 6}, {1.0, 1.0, 1.0},
             [](int i, int j, int k) {
               return std::min({i, j, k}) >= 1 && i <= 8 && j <= 8 && k <= 4;
             });
  palpate::ShapeFieldSettings settings;
  settings.CellsOnSurface = 500.0;
  EXPECT_NEAR(palpate::ShapeFieldSpacing(mask, settings), std::sqrt(256.0 * 2.0 / 3.0 / 500.0),
              1e-12);
  palpate::ShapeField field;
  ASSERT_TRUE(palpate::MakeShapeField(mask, settings, field).IsOk());
  EXPECT_EQ(field.Grid.Spacing, palpate::ShapeFieldSpacing(mask, settings));
  EXPECT_EQ(palpate::ShapeFieldSpacing({}, settings), 0.0);
}

void ExpectMirroredField(const palpate::ShapeFieldSettings& settings)
{
  for (const std::array<double, 3>& spacing :
       {std::array<double, 3>{0.5, 0.5, 3.0}, std::array<double, 3>{0.5, 0.8, 0.5},
        std::array<double, 3>{1.0, 1.0, 1.0}})
  {
    const palpate::VoxelMask mask = EllipsoidMask(spacing);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const palpate::VoxelMask mirrored =
          MaskOf(mask.Size, spacing,
                 [&](int i, int j, int k)
                 {
                   std::array<int, 3> at{i, j, k};
                   at[axis] = mask.Size[axis] - 1 - at[axis];
                   return mask.Inside[mask.Offset(at[0], at[1], at[2])] != 0;
                 });
      palpate::ShapeField field;
      palpate::ShapeField other;
      ASSERT_TRUE(palpate::MakeShapeField(mask, settings, field).IsOk());
      ASSERT_TRUE(palpate::MakeShapeField(mirrored, settings, other).IsOk());
      ASSERT_EQ(field.Grid.Size, other.Grid.Size);
      for (std::size_t node = 0; node < field.Values.size(); ++node)
      {
        std::array<int, 3> at = field.Grid.Index(node);
        at[axis] = field.Grid.Size[axis] - 1 - at[axis];
        // Rounding of float sums in another order.
        ASSERT_NEAR(other.Values[other.Grid.Offset(at[0], at[1], at[2])], field.Values[node], 1e-5);
      }
    }
  }
}

TEST(ShapeField, MirrorsWithMask)
{
  ExpectMirroredField({});
}

TEST(ShapeField, OfStarMirrorsWithMask)
{
  ExpectMirroredField(palpate::ShapeFieldSettings::OfStar());
}

TEST(ShapeField, ScalesWithUnit)
{
  palpate::ShapeField field;
  palpate::ShapeField large;
  ASSERT_TRUE(palpate::MakeShapeField(EllipsoidMask({0.5, 0.5, 3.0}), {}, field).IsOk());
  ASSERT_TRUE(palpate::MakeShapeField(EllipsoidMask({512.0, 512.0, 3072.0}), {}, large).IsOk());
  ASSERT_EQ(field.Grid.Size, large.Grid.Size);
  EXPECT_NEAR(large.Grid.Spacing, 1024.0 * field.Grid.Spacing, 1e-9 * large.Grid.Spacing);
  for (std::size_t node = 0; node < field.Values.size(); ++node)
  {
    ASSERT_NEAR(large.Values[node], 1024.0f * field.Values[node], 1e-2);
  }
}

TEST(ShapeField, FollowsAreaAndStaysWithinNodes)
{
  palpate::ShapeField field;
  palpate::ShapeFieldSettings settings;
  ASSERT_TRUE(palpate::MakeShapeField(BoxMask({1.0, 1.0, 1.0}), settings, field).IsOk());
  EXPECT_NEAR(field.Grid.Spacing, std::sqrt(96.0 * 2.0 / 3.0 / settings.CellsOnSurface), 1e-12);
  settings.MaximumNodes = 1e4;
  ASSERT_TRUE(palpate::MakeShapeField(BoxMask({1.0, 1.0, 1.0}), settings, field).IsOk());
  EXPECT_LE(field.Values.size(), 10000u);
  EXPECT_GT(field.Values.size(), 5000u);
  settings.Spacing = 0.5;
  ASSERT_TRUE(palpate::MakeShapeField(BoxMask({1.0, 1.0, 1.0}), settings, field).IsOk());
  EXPECT_EQ(field.Grid.Spacing, 0.5);
}

TEST(ShapeField, JoinsOutlinesOfNeighbouringSlicesByObliqueWall)
{
  // Discs whose radius falls by half a pixel from slice to slice: the interpolated cone's radius
  // between slices is the mean of both.
  const palpate::VoxelMask mask =
      MaskOf({41, 41, 5}, {1.0, 1.0, 4.0},
             [](int i, int j, int k) { return std::hypot(i - 20.0, j - 20.0) < 15.0 - 0.5 * k; });
  palpate::ShapeField field;
  ASSERT_TRUE(palpate::MakeShapeField(mask, Unsmoothed(), field).IsOk());
  for (int k = 0; k < 4; ++k)
  {
    const double radius = 15.0 - 0.5 * k - 0.25;
    const double z = 4.0 * (k + 0.5);
    // An outline of voxels is within a pixel of its circle.
    EXPECT_GT(field.Sample({20.0 + radius - 1.0, 20.0, z}), 0.0);
    EXPECT_LT(field.Sample({20.0 + radius + 1.0, 20.0, z}), 0.0);
  }
}

// Of the field's zero level around a point in the plane of its slice, mean of all directions.
double MeanRadiusAround(const Vector3& centre, const palpate::ShapeField& field)
{
  constexpr int Directions = 720;
  constexpr double Longest = 30.0; // mm
  double sum = 0.0;
  for (int n = 0; n < Directions; ++n)
  {
    const double angle = 2.0 * M_PI * n / Directions;
    const Vector3 direction(std::cos(angle), std::sin(angle), 0.0);
    double inside = 0.0;
    double outside = Longest;
    while (outside - inside > 1e-6)
    {
      const double middle = 0.5 * (inside + outside);
      (field.Sample(centre + middle * direction) > 0.0 ? inside : outside) = middle;
    }
    sum += inside;
  }
  return sum / Directions;
}

TEST(ShapeField, CurvesBetweenThickSlicesLikeTheBody)
{
  // A ball's widest plane, half way between slices 6 mm apart. Their outlines have radii of 19.774
  // mm, and so would a straight wall between them.
  constexpr double Radius = 20.0;
  const Vector3 centre(24.9, 25.2, 27.0);
  const palpate::VoxelMask mask =
      MaskOf({100, 102, 10}, {0.5, 0.5, 6.0},
             [&](int i, int j, int k)
             { return (Vector3(0.5 * i, 0.5 * j, 6.0 * k) - centre).norm() < Radius; });
  palpate::ShapeFieldSettings settings = Unsmoothed();
  settings.SliceClamp = 0.5;
  palpate::ShapeField field;
  ASSERT_TRUE(palpate::MakeShapeField(mask, settings, field).IsOk());
  EXPECT_NEAR(MeanRadiusAround(centre, field), 19.774, 0.05);
  settings.IsCurved = true;
  ASSERT_TRUE(palpate::MakeShapeField(mask, settings, field).IsOk());
  // The cubic through the four outlines has 20.013; the rest is pixels.
  EXPECT_NEAR(MeanRadiusAround(centre, field), Radius, 0.05);
}

// Tilted, in a box of its own; slices of 4 mm lie anywhere in it.
class TiltedEllipsoid
{
public:
  TiltedEllipsoid(const Vector3& halfAxes, unsigned int seed)
      : HalfAxes(halfAxes), Random(9600 + seed)
  {
    this->Centre[2] += this->Uniform(this->Random) * Slice;
    this->Turn = palpate::test::RandomOrientation(this->Random);
  }

  palpate::VoxelMask Mask() const
  {
    return MaskOf({101, 101, 14}, {Pixel, Pixel, Slice},
                  [&](int i, int j, int k) {
                    return this->Contains({Pixel * i, Pixel * j, Slice * k});
                  });
  }
  bool Contains(const Vector3& point) const
  {
    return (this->Turn * (point - this->Centre)).cwiseQuotient(this->HalfAxes).norm() < 1.0;
  }
  // In the box, with the slices' height or on one of them.
  Vector3 Point(bool isOnSlice)
  {
    const double height = 13.0 * this->Uniform(this->Random);
    return {50.0 * this->Uniform(this->Random), 50.0 * this->Uniform(this->Random),
            Slice * (isOnSlice ? std::round(height) : height)};
  }

private:
  static constexpr double Slice = 4.0; // mm
  static constexpr double Pixel = 0.5;

  Vector3 HalfAxes;
  std::mt19937_64 Random;
  std::uniform_real_distribution<double> Uniform{0.0, 1.0};
  Vector3 Centre{25.0, 25.0, 24.0};
  Matrix3 Turn;
};

// The part of such bodies that the field of fits of radii gets wrong, at random points.
double WrongPart(const Vector3& halfAxes, bool isOnSlices)
{
  constexpr unsigned int Bodies = 12;
  int inside = 0;
  int wrong = 0;
  for (unsigned int seed = 0; seed < Bodies; ++seed)
  {
    TiltedEllipsoid body(halfAxes, seed);
    const palpate::VoxelMask mask = body.Mask();
    palpate::ShapeField field;
    EXPECT_TRUE(palpate::MakeShapeField(mask, palpate::ShapeFieldSettings::OfStar(), field).IsOk());
    const double volume = static_cast<double>(mask.Count()) * mask.VoxelVolume();
    const double area = 4.0 * M_PI * std::pow(halfAxes.prod(), 2.0 / 3.0);
    const double level = palpate::LevelOfVolume(field, volume, area);
    for (int n = 0; n < 100000; ++n)
    {
      const Vector3 point = body.Point(isOnSlices);
      const bool isInside = body.Contains(point);
      inside += isInside ? 1 : 0;
      wrong += isInside != (field.Sample(point) > level) ? 1 : 0;
    }
  }
  return static_cast<double>(wrong) / inside;
}

// 2.9 %; with distances bounded by half a slice 3.6 %.
TEST(ShapeField, OfStarFollowsLargeBodiesBetweenSlices)
{
  EXPECT_LT(WrongPart({22.0, 16.0, 14.0}, false), 0.032);
}

// 5 %; with distances bounded by its whole depth 10 %.
TEST(ShapeField, OfStarFollowsTheSlicesOfSmallBodies)
{
  EXPECT_LT(WrongPart({8.0, 5.0, 4.0}, true), 0.06);
}

// Voxels that the field has on the other side, of the mask's.
double PartOfWrongVoxels(const palpate::VoxelMask& mask)
{
  palpate::ShapeFieldSettings settings = palpate::ShapeFieldSettings::OfStar();
  settings.Spacing = mask.Spacing[0];
  settings.Smoothing = 0.5; // as vtkSegmentationSurface
  palpate::ShapeField field;
  EXPECT_TRUE(palpate::MakeShapeField(mask, settings, field).IsOk());
  const double volume = static_cast<double>(mask.Count()) * mask.VoxelVolume();
  const double level = palpate::LevelOfVolume(field, volume, std::cbrt(volume * volume));
  int wrong = 0;
  for (int k = 0; k < mask.Size[2]; ++k)
  {
    for (int j = 0; j < mask.Size[1]; ++j)
    {
      for (int i = 0; i < mask.Size[0]; ++i)
      {
        const Vector3 point(mask.Spacing[0] * i, mask.Spacing[1] * j, mask.Spacing[2] * k);
        const bool isInside = mask.Inside[mask.Offset(i, j, k)] != 0;
        wrong += isInside != (field.Sample(point) > level) ? 1 : 0;
      }
    }
  }
  return static_cast<double>(wrong) / static_cast<double>(mask.Count());
}

TEST(ShapeField, OfStarKeepsWallsOfOnePixel)
{
  const std::array<double, 3> spacing{0.5, 0.5, 3.0};
  const auto plate =
      MaskOf({10, 40, 20}, spacing,
             [](int i, int j, int k) { return i == 5 && j >= 8 && j < 32 && k >= 4 && k < 16; });
  const auto frame =
      MaskOf({40, 40, 13}, spacing,
             [](int i, int j, int k)
             { return std::max(std::abs(i - 20), std::abs(j - 20)) == 12 && k >= 2 && k < 11; });
  // Corners are cut off.
  EXPECT_LT(PartOfWrongVoxels(plate), 0.1);
  EXPECT_LT(PartOfWrongVoxels(frame), 0.1);
}

TEST(ShapeField, CurvesDoNotLeaveAThinObjectNextToItsEnds)
{
  // Slices a thousand times as thick as pixels: the clamp is far more than the object is deep.
  palpate::ShapeFieldSettings settings = Unsmoothed();
  settings.IsCurved = true;
  palpate::ShapeField field;
  ASSERT_TRUE(palpate::MakeShapeField(BoxMask({0.01, 0.01, 10.0}), settings, field).IsOk());
  // Beside the box, half way between its last two slices.
  EXPECT_LT(field.Sample({0.065, 0.035, 45.0}), 0.0);
  EXPECT_GT(field.Sample({0.035, 0.035, 45.0}), 0.0);
}

TEST(ShapeField, RejectsBadMasksAndSettings)
{
  palpate::ShapeField field;
  const palpate::VoxelMask good = BoxMask({1.0, 1.0, 1.0});
  for (const double spacing : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
  {
    palpate::VoxelMask mask = good;
    mask.Spacing[1] = spacing;
    EXPECT_FALSE(palpate::MakeShapeField(mask, {}, field).IsOk()) << spacing;
  }
  palpate::VoxelMask mask = good;
  mask.Size = {1 << 30, 1 << 30, 1 << 30};
  EXPECT_FALSE(palpate::MakeShapeField(mask, {}, field).IsOk());
  mask.Size = {-8, -8, 8};
  EXPECT_FALSE(palpate::MakeShapeField(mask, {}, field).IsOk());
  mask = good;
  std::fill(mask.Inside.begin(), mask.Inside.end(), static_cast<unsigned char>(0));
  EXPECT_EQ(palpate::MakeShapeField(mask, {}, field).Message(), "The mask is empty.");
  palpate::ShapeFieldSettings settings;
  settings.Spacing = std::nan("");
  EXPECT_FALSE(palpate::MakeShapeField(good, settings, field).IsOk());
  settings = {};
  settings.Smoothing = 1e9;
  EXPECT_FALSE(palpate::MakeShapeField(good, settings, field).IsOk());
}
} // namespace
} // namespace palpate::shape_field_test
