#include "SliceStack.h"

#include "DecimalText.h"
#include "Refusal.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace palpate
{
namespace
{
// Tolerance of slice positions as a fraction of the spacing; decimal strings in DICOM are often
// rounded to a hundredth of a millimetre.
constexpr double EvenTolerance = 0.02;

// More than any scan has, and within the range of an index.
constexpr double MostSlices = 65536.0;

// Distances along the normal from the first plane given, mm.
std::vector<double> Heights(const std::filesystem::path& file,
                            const std::vector<SlicePlane>& planes)
{
  const Vector3 normal = planes.front().NormalWorld();
  std::vector<double> heights;
  heights.reserve(planes.size());
  for (const SlicePlane& plane : planes)
  {
    heights.push_back(normal.dot(plane.PositionWorld - planes.front().PositionWorld));
    if (!std::isfinite(heights.back()))
    {
      Refuse(file, "has a slice at an infinite distance", "export it again");
    }
  }
  return heights;
}

// Sorted; distances within a thousandth of a millimetre are merged.
std::vector<double> DistinctHeights(std::vector<double> heights)
{
  std::sort(heights.begin(), heights.end());
  heights.erase(
      std::unique(heights.begin(), heights.end(), [](double a, double b) { return b - a < 1e-3; }),
      heights.end());
  return heights;
}

double SmallestGap(const std::vector<double>& distinct)
{
  double gap = distinct.back() - distinct.front();
  for (std::size_t i = 1; i < distinct.size(); ++i)
  {
    gap = std::min(gap, distinct[i] - distinct[i - 1]);
  }
  return gap;
}

bool Fits(const std::vector<double>& distinct, double step)
{
  return std::all_of(distinct.begin(), distinct.end(),
                     [&](double height)
                     {
                       const double slices = (height - distinct.front()) / step;
                       return std::abs(slices - std::round(slices)) <= EvenTolerance;
                     });
}

[[noreturn]] void RefuseUneven(const std::filesystem::path& file,
                               const std::vector<double>& distinct)
{
  double largest = 0.0;
  for (std::size_t i = 1; i < distinct.size(); ++i)
  {
    largest = std::max(largest, distinct[i] - distinct[i - 1]);
  }
  Refuse(file,
         "has uneven gaps between its slices (" + SignificantText(SmallestGap(distinct)) + " to " +
             SignificantText(largest) + " mm)",
         "add the missing slices or resample it");
}

double DenseStep(const std::filesystem::path& file, const std::vector<double>& distinct,
                 std::size_t planeCount)
{
  if (distinct.size() < planeCount)
  {
    Refuse(file,
           "has " + std::to_string(planeCount) + " images in " + std::to_string(distinct.size()) +
               " positions: it mixes several volumes (times, echoes or repetitions)",
           "put one of them into a separate folder");
  }
  const double step =
      (distinct.back() - distinct.front()) / static_cast<double>(distinct.size() - 1);
  for (std::size_t i = 0; i < distinct.size(); ++i)
  {
    const double place = distinct.front() + static_cast<double>(i) * step;
    if (!(std::abs(distinct[i] - place) <= EvenTolerance * step))
    {
      RefuseUneven(file, distinct);
    }
  }
  return step;
}

double SparseStep(const std::filesystem::path& file, const std::vector<double>& distinct,
                  const std::optional<double>& stated)
{
  if (stated && *stated > 0.0 && Fits(distinct, *stated))
  {
    return *stated;
  }
  if (distinct.size() < 2)
  {
    Refuse(file, "does not state the distance between its slices",
           "export it again with its slice thickness");
  }
  // A rounded smallest gap accumulates an error over many slices; the mean over a whole number of
  // gaps does not.
  const double gap = SmallestGap(distinct);
  const double extent = distinct.back() - distinct.front();
  const double step = extent / std::max(1.0, std::round(extent / gap));
  if (!Fits(distinct, step))
  {
    RefuseUneven(file, distinct);
  }
  return step;
}

void CheckParallel(const std::filesystem::path& file, const std::vector<SlicePlane>& planes,
                   const std::vector<double>& heights)
{
  const SlicePlane& first = planes.front();
  const auto lowest =
      static_cast<std::size_t>(std::min_element(heights.begin(), heights.end()) - heights.begin());
  for (const SlicePlane& plane : planes)
  {
    if (!plane.IsParallelTo(first))
    {
      Refuse(file, "mixes slices of different orientation, size or pixel spacing",
             "put each orientation into a separate folder");
    }
    const Vector3 offset = plane.PositionWorld - planes[lowest].PositionWorld;
    if (std::abs(offset.dot(first.RowWorld)) > 0.1 * first.Spacing[0] ||
        std::abs(offset.dot(first.ColumnWorld)) > 0.1 * first.Spacing[1])
    {
      Refuse(file, "has slices that are shifted sideways against each other (a sheared volume)",
             "resample it to a rectangular grid");
    }
  }
}
} // namespace

bool SlicePlane::IsParallelTo(const SlicePlane& other) const
{
  constexpr double Tolerance = 1e-4;
  return this->Columns == other.Columns && this->Rows == other.Rows &&
         (this->RowWorld - other.RowWorld).norm() < Tolerance &&
         (this->ColumnWorld - other.ColumnWorld).norm() < Tolerance &&
         (this->Spacing - other.Spacing).norm() < Tolerance * other.Spacing.norm();
}

SliceStack StackSlices(const std::filesystem::path& file, const std::vector<SlicePlane>& planes,
                       const SliceStackRules& rules)
{
  const std::vector<double> heights = Heights(file, planes);
  const std::vector<double> distinct = DistinctHeights(heights);
  CheckParallel(file, planes, heights);
  if (!rules.Sparse && planes.size() < 2)
  {
    Refuse(file, "is a single slice", "use a volume of at least two slices");
  }
  const double step = rules.Sparse ? SparseStep(file, distinct, rules.StatedStep)
                                   : DenseStep(file, distinct, planes.size());
  const double slicesApart = (distinct.back() - distinct.front()) / step;
  if (distinct.size() > 1 && !(slicesApart < MostSlices))
  {
    Refuse(file, "has slices that are " + SignificantText(slicesApart) + " slice spacings apart",
           "export it again, or correct its slice positions");
  }
  SliceStack stack;
  for (const double height : heights)
  {
    stack.SliceOfPlane.push_back(static_cast<int>(std::lround((height - distinct.front()) / step)));
  }
  const SlicePlane& first = planes.front();
  const auto lowest =
      static_cast<std::size_t>(std::min_element(heights.begin(), heights.end()) - heights.begin());
  const int slices = 1 + *std::max_element(stack.SliceOfPlane.begin(), stack.SliceOfPlane.end());
  stack.Grid.Size = {first.Columns, first.Rows, slices};
  stack.Grid.Spacing = Vector3(first.Spacing[0], first.Spacing[1], step);
  stack.Grid.OriginWorld = planes[lowest].PositionWorld;
  stack.Grid.Direction << first.RowWorld, first.ColumnWorld, first.NormalWorld();
  return stack;
}
} // namespace palpate
