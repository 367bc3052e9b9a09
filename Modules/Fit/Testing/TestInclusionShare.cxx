#include "InclusionShare.h"

#include "LabelImages.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::inclusion_share_test
{
namespace
{
RadialModel Ball()
{
  return {0, {14.0 * std::sqrt(4.0 * M_PI)}, Vector3::Zero()};
}

// A ball of 5 mm at x, voxels of 0.5 mm.
Segmentation LesionAt(double x0)
{
  test::LabelGrid grid;
  grid.Size = {{25, 25, 25}};
  grid.Spacing = {{0.5, 0.5, 0.5}};
  grid.CenterOnOrigin();
  grid.Origin[0] += x0;
  Segmentation read;
  read.Source = "folder/lesion.nii.gz";
  read.Layers.push_back(test::MakeLabelImage(
      grid, [x0](double x, double y, double z) { return std::hypot(x - x0, y, z) < 5.0; }, 3));
  Segment segment;
  segment.Label = segment.Value = 3;
  segment.Name = "Lesion";
  read.Segments.push_back(segment);
  return read;
}

InclusionShare ShareAt(double x0)
{
  const Segmentation read = LesionAt(x0);
  return ShareOf(Ball(), read, read.Segments, FractionsOf(read, read.Segments));
}

// Volume of the part of a ball of 5 mm at a distance that lies in one of 14 mm: a lens.
double LensMilliliters(double distance)
{
  const double r = 5.0;
  const double R = 14.0;
  const double d = distance;
  return 1e-3 * M_PI * std::pow(R + r - d, 2) *
         (d * d + 2.0 * d * (r + R) - 3.0 * std::pow(R - r, 2)) / (12.0 * d);
}

TEST(InclusionShare, VolumesAreThoseOfTheBodies)
{
  const double whole = 4.0 / 3.0 * M_PI * 0.125; // ml
  const InclusionShare inside = ShareAt(5.0);
  EXPECT_NEAR(inside.Milliliters, whole, 0.02 * whole);
  EXPECT_EQ(inside.InsideMilliliters, inside.Milliliters);
  for (const double x : {12.0, 14.0, 16.5})
  {
    EXPECT_NEAR(ShareAt(x).InsideMilliliters, LensMilliliters(x), 0.03 * whole) << x;
  }
}

TEST(InclusionShare, NotesWhatLiesOutside)
{
  EXPECT_EQ(ShareAt(5.0).Note("the model"), "");
  EXPECT_EQ(ShareAt(13.0).Note("the model"), "") << "more than half of it lies inside";
  EXPECT_EQ(ShareAt(30.0).Note("the model"),
            "folder/lesion.nii.gz lies outside of the model and changes nothing");
  const std::string mostly = ShareAt(16.5).Note("the model");
  EXPECT_NE(mostly.find(" % of folder/lesion.nii.gz lies in the model (0.0"), std::string::npos)
      << mostly;
}

TEST(InclusionShare, NamesOneStructureOfSeveral)
{
  Segmentation read = LesionAt(30.0);
  Segment other;
  other.Label = other.Value = 4;
  read.Segments.push_back(other);
  const std::vector<Segment> first{read.Segments.front()};
  EXPECT_EQ(ShareOf(Ball(), read, first, FractionsOf(read, first)).Name,
            "folder/lesion.nii.gz, label 3 (Lesion)");
  EXPECT_EQ(FractionsOf(read, read.Segments).size(), 1U) << "no voxel has the other label";
}
} // namespace
} // namespace palpate::inclusion_share_test
