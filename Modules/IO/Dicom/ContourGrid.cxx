#include "ContourGrid.h"

#include "DecimalText.h"
#include "Median.h"
#include "Refusal.h"
#include "SliceStack.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace palpate
{
namespace
{
constexpr double LargestPixel = 1.0;  // mm
constexpr double SmallestPixel = 0.2; // mm
constexpr double MostVoxelsAlong = 4096.0;

template <typename Action>
void ForEachContour(const DicomContours& contours, const Action& action)
{
  for (const ContourStructure& structure : contours.Structures)
  {
    for (const ContourWorld& contour : structure.Contours)
    {
      action(contour);
    }
  }
}

// Twice the area as a vector along the normal (Newell).
Vector3 AreaVector(const ContourWorld& contour)
{
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 1; i + 1 < contour.size(); ++i)
  {
    sum += (contour[i] - contour[0]).cross(contour[i + 1] - contour[0]);
  }
  return sum;
}

// Of the contour with the largest area; the axis that it is closest to points to L, P or S.
Vector3 NormalOf(const std::filesystem::path& file, const DicomContours& contours)
{
  Vector3 largest = Vector3::Zero();
  ForEachContour(contours,
                 [&largest](const ContourWorld& contour)
                 {
                   const Vector3 area = AreaVector(contour);
                   largest = area.norm() > largest.norm() ? area : largest;
                 });
  const double length = largest.norm();
  if (!std::isfinite(length) || !(length > 0.0))
  {
    Refuse(file, "has contours without an area", "export it again");
  }
  Eigen::Index axis = 0;
  largest.cwiseAbs().maxCoeff(&axis);
  Vector3 normal = largest / (largest[axis] < 0.0 ? -length : length);
  // Within rounding of coordinates of a patient axis.
  if (std::abs(normal[axis]) > 1.0 - 1e-6)
  {
    normal = Vector3::Unit(axis);
  }
  return normal;
}

// Axes of the slices: rows along the patient axis L, or P for sagittal planes, as far as possible.
StackedSlice PlaneAcross(const Vector3& normal)
{
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const Vector3 along = Vector3::Unit(axis == 0 ? 1 : 0);
  StackedSlice plane;
  plane.RowWorld = (along - along.dot(normal) * normal).normalized();
  plane.ColumnWorld = normal.cross(plane.RowWorld);
  plane.Columns = 1;
  plane.Rows = 1;
  return plane;
}

double MedianPointDistance(const DicomContours& contours)
{
  std::vector<double> distances;
  ForEachContour(contours,
                 [&distances](const ContourWorld& contour)
                 {
                   for (std::size_t i = 1; i < contour.size(); ++i)
                   {
                     distances.push_back((contour[i] - contour[i - 1]).norm());
                   }
                 });
  return UpperMedian(distances);
}
} // namespace

Vector3 IndexOf(const ImageGrid& grid, const Vector3& pointWorld)
{
  return (grid.Direction.transpose() * (pointWorld - grid.OriginWorld)).cwiseQuotient(grid.Spacing);
}

ImageGrid GridOfContours(const std::filesystem::path& file, const DicomContours& contours,
                         double mostVoxels, std::vector<std::string>& notes)
{
  const Vector3 normal = NormalOf(file, contours);
  StackedSlice plane = PlaneAcross(normal);
  std::vector<StackedSlice> planes;
  Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 high = -low;
  ForEachContour(contours,
                 [&](const ContourWorld& contour)
                 {
                   for (const Vector3& point : contour)
                   {
                     const Vector3 place(plane.RowWorld.dot(point), plane.ColumnWorld.dot(point),
                                         normal.dot(point));
                     low = low.cwiseMin(place);
                     high = high.cwiseMax(place);
                   }
                   // Rounded, so that planes whose points are rounded differently are one.
                   plane.PositionWorld =
                       std::round(normal.dot(contour[0]) * 100.0) / 100.0 * normal;
                   planes.push_back(plane);
                 });
  SliceStackRules rules;
  rules.Sparse = true;
  const SliceStack stack = StackSlices(file, planes, rules);
  notes.insert(notes.end(), stack.Notes.begin(), stack.Notes.end());
  ImageGrid grid = stack.Grid;
  const double area = (high[0] - low[0]) * (high[1] - low[1]);
  const double pixel = std::clamp(MedianPointDistance(contours), SmallestPixel, LargestPixel);
  grid.Spacing[0] = grid.Spacing[1] = std::max(pixel, std::sqrt(area * grid.Size[2] / mostVoxels));
  grid.OriginWorld += low[0] * plane.RowWorld + low[1] * plane.ColumnWorld;
  return grid;
}

ImageGrid GridAroundContours(const std::filesystem::path& file, const DicomContours& contours,
                             ImageGrid grid, int slices)
{
  Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity());
  Vector3 high = -low;
  ForEachContour(contours,
                 [&](const ContourWorld& contour)
                 {
                   for (const Vector3& point : contour)
                   {
                     const Vector3 index = IndexOf(grid, point);
                     low = low.cwiseMin(index);
                     high = high.cwiseMax(index);
                   }
                 });
  const Vector3 margin(1.0, 1.0, 1.0 + slices);
  const Vector3 first = low.array().floor().matrix() - margin;
  const Vector3 size = (high.array().ceil() + 1.0).matrix() + margin - first;
  if (!size.allFinite() || size.maxCoeff() > MostVoxelsAlong)
  {
    Refuse(file, "has contours that extend over " + SignificantText(size.maxCoeff()) + " voxels",
           "export its structures in parts");
  }
  grid.OriginWorld += grid.Direction * first.cwiseProduct(grid.Spacing);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    grid.Size[axis] = static_cast<int>(size[static_cast<Eigen::Index>(axis)]);
  }
  return grid;
}
} // namespace palpate
