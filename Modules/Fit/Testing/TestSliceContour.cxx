#include "SliceContour.h"

#include "ImageAxes.h"
#include "SyntheticFit.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <sstream>

namespace palpate::slice_contour_test
{
namespace
{
struct PathMeasure
{
  double Length = 0.0; // pixels
  double Area = 0.0;   // pixels, of all closed curves, by the shoelace formula
};

// Parses path data of the written kind: M x y, L x y, Z.
PathMeasure Measure(const std::string& path)
{
  PathMeasure measure;
  Eigen::Vector2d start;
  Eigen::Vector2d last;
  const auto lineTo = [&](const Eigen::Vector2d& point)
  {
    measure.Length += (point - last).norm();
    measure.Area += 0.5 * (last.x() * point.y() - last.y() * point.x());
    last = point;
  };
  std::istringstream text(path);
  char command = 0;
  while (text >> command)
  {
    if (command == 'Z')
    {
      lineTo(start);
      continue;
    }
    Eigen::Vector2d point;
    text >> point.x() >> point.y();
    if (command == 'M')
    {
      start = last = point;
    }
    else
    {
      lineTo(point);
    }
  }
  return measure;
}

TEST(SliceContour, SphereContourEnclosesDisc)
{
  palpate::test::SyntheticFit fit;
  const auto sphere = palpate::test::MakeModelMesh(
      palpate::test::SphereModel(18.0, palpate::test::SyntheticFit::Center), 40);
  for (const SlicePlane& plane : palpate::ChooseSlicePlanes(fit.Result.Mask, 1, 3, 300))
  {
    const double height =
        plane.NormalWorld().dot(palpate::test::SyntheticFit::Center - plane.CornerWorld);
    const double squaredRadius =
        (18.0 * 18.0 - height * height) / std::pow(plane.PixelMillimeters, 2);
    const PathMeasure measure = Measure(palpate::SurfaceContourPath(sphere, plane));
    // One digit behind the point and points 0.4 pixels apart: well below one per cent.
    EXPECT_NEAR(std::abs(measure.Area) / (M_PI * squaredRadius), 1.0, 0.01) << plane.Name;
  }
}

TEST(SliceContour, MaskOutlineIsVoxelBoundary)
{
  palpate::test::SyntheticFit fit;
  int size[3];
  fit.Result.Mask->GetDimensions(size);
  const double* spacing = fit.Result.Mask->GetSpacing();
  for (const SlicePlane& plane : palpate::ChooseSlicePlanes(fit.Result.Mask, 1, 3, 300))
  {
    // Reference: every voxel's four sides in the slice.
    const auto inside = [&](std::array<int, 3> index)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        if (index[axis] < 0 || index[axis] >= size[axis])
        {
          return false;
        }
      }
      return fit.Result.Mask->GetScalarComponentAsDouble(index[0], index[1], index[2], 0) == 1.0;
    };
    double length = 0.0;
    for (int a = -1; a < size[plane.RightAxis]; ++a)
    {
      for (int b = -1; b < size[plane.DownAxis]; ++b)
      {
        std::array<int, 3> here{};
        here[plane.SliceAxis] = plane.SliceIndex;
        here[plane.RightAxis] = a;
        here[plane.DownAxis] = b;
        std::array<int, 3> right = here;
        ++right[plane.RightAxis];
        std::array<int, 3> below = here;
        ++below[plane.DownAxis];
        length += inside(here) != inside(right) ? spacing[plane.DownAxis] : 0.0;
        length += inside(here) != inside(below) ? spacing[plane.RightAxis] : 0.0;
      }
    }
    const PathMeasure measure = Measure(palpate::MaskOutlinePath(fit.Result.Mask, 1, plane));
    // Ends are rounded to a tenth of a pixel, which may round either way.
    EXPECT_NEAR(measure.Length * plane.PixelMillimeters / length, 1.0, 0.01) << plane.Name;
  }
}

TEST(SliceContour, MaskOutlineFollowsVoxelFaces)
{
  palpate::test::SyntheticFit fit;
  const palpate::ImageAxes axes(fit.Result.Mask);
  for (const SlicePlane& plane : palpate::ChooseSlicePlanes(fit.Result.Mask, 1, 2, 400))
  {
    std::string path = palpate::MaskOutlinePath(fit.Result.Mask, 1, plane);
    std::replace_if(
        path.begin(), path.end(), [](char c) { return c == 'M' || c == 'L'; }, ' ');
    std::istringstream text(path);
    Eigen::Vector2d point;
    int count = 0;
    while (text >> point.x() >> point.y())
    {
      const palpate::Vector3 index = axes.ToIndex(plane.ToWorld(point));
      for (const int axis : {plane.RightAxis, plane.DownAxis})
      {
        // A twentieth of a pixel of 0.2 mm is a hundredth of a voxel.
        EXPECT_NEAR(std::abs(index[axis] - std::floor(index[axis])), 0.5, 0.02);
      }
      ++count;
    }
    EXPECT_GT(count, 40);
  }
}

TEST(SliceContour, AbsentStructureHasNoPath)
{
  palpate::test::SyntheticFit fit;
  const SlicePlane plane = palpate::ChooseSlicePlanes(fit.Result.Mask, 1, 1, 100).front();
  EXPECT_EQ(palpate::MaskOutlinePath(fit.Result.Mask, 5, plane), "");
}
} // namespace
} // namespace palpate::slice_contour_test
