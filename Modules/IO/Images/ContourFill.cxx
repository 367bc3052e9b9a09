#include "ContourFill.h"

#include "Refusal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace palpate
{
namespace
{
// In slices. Contours of one plane may be rounded differently; planes halfway between two slices
// must not alternate between them.
constexpr double SamePlane = 0.02;
constexpr double Halfway = 0.05;

struct ContourPlane
{
  double Slice = 0.0;
  std::vector<const SliceContour*> Contours;
};

std::vector<ContourPlane> PlanesOf(const std::vector<SliceContour>& contours)
{
  std::vector<const SliceContour*> sorted;
  for (const SliceContour& contour : contours)
  {
    sorted.push_back(&contour);
  }
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const SliceContour* a, const SliceContour* b)
                   { return a->Slice < b->Slice; });
  std::vector<ContourPlane> planes;
  for (const SliceContour* contour : sorted)
  {
    if (planes.empty() || contour->Slice - planes.back().Slice > SamePlane)
    {
      planes.push_back({contour->Slice, {}});
    }
    planes.back().Contours.push_back(contour);
  }
  return planes;
}

// Half the slices that a plane stands for, by the sorted indices of the planes.
double HalfThickness(const std::vector<double>& planes)
{
  double gap = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < planes.size(); ++i)
  {
    const double next = planes[i] - planes[i - 1];
    gap = next > SamePlane ? std::min(gap, next) : gap;
  }
  return 0.5 * (std::isinf(gap) ? 1.0 : std::max(1.0, gap));
}

// The plane that every slice takes, or -1.
std::vector<int> PlaneOfSlices(const std::vector<ContourPlane>& planes, int slices)
{
  std::vector<double> places;
  for (const ContourPlane& plane : planes)
  {
    places.push_back(plane.Slice);
  }
  const double half = HalfThickness(places) + Halfway;
  std::vector<int> taken(static_cast<std::size_t>(slices), -1);
  for (std::size_t i = 0; i < planes.size(); ++i)
  {
    // Half-open, so that planes with an even gap of n slices stand for n slices each.
    const double first = std::ceil(planes[i].Slice - half);
    const double end = std::ceil(planes[i].Slice + half - 2.0 * Halfway);
    for (double slice = std::max(first, 0.0); slice < std::min(end, double(slices)); slice += 1.0)
    {
      int& plane = taken[static_cast<std::size_t>(slice)];
      const auto distance = [&](std::size_t k) { return std::abs(planes[k].Slice - slice); };
      plane = plane < 0 || distance(i) < distance(static_cast<std::size_t>(plane))
                  ? static_cast<int>(i)
                  : plane;
    }
  }
  return taken;
}
} // namespace

int SlicesBeyondPlanes(std::vector<double> planes)
{
  std::sort(planes.begin(), planes.end());
  return static_cast<int>(std::ceil(std::min(HalfThickness(planes), 1e6)));
}

ContourFill::ContourFill(const std::filesystem::path& file, const std::array<int, 3>& size,
                         std::int64_t mostCrossings)
    : File(file), Size(size), CrossingsLeft(mostCrossings)
{
}

// A row is crossed by an edge that starts at or before it and ends behind it, so that a corner on a
// row counts once.
void ContourFill::AddCrossings(const SliceContour& contour, std::vector<Crossing>& crossings) const
{
  for (std::size_t i = 0; i < contour.Points.size(); ++i)
  {
    const Eigen::Vector2d* low = &contour.Points[i];
    const Eigen::Vector2d* high = &contour.Points[(i + 1) % contour.Points.size()];
    if (low->y() > high->y())
    {
      std::swap(low, high);
    }
    const double end = std::min(std::ceil(high->y()), static_cast<double>(this->Size[1]));
    for (double row = std::max(std::ceil(low->y()), 0.0); row < end; row += 1.0)
    {
      const double part = (row - low->y()) / (high->y() - low->y());
      crossings.push_back(
          {static_cast<std::int64_t>(row), low->x() + part * (high->x() - low->x())});
    }
  }
}

// In order, for a plane that `slices` slices take.
std::vector<ContourFill::Crossing> ContourFill::CrossingsOf(const Plane& plane, std::int64_t slices)
{
  double expected = 0.0;
  for (const SliceContour* contour : plane)
  {
    for (std::size_t i = 0; i < contour->Points.size(); ++i)
    {
      const double other = contour->Points[(i + 1) % contour->Points.size()].y();
      expected += 1.0 + std::min(std::abs(contour->Points[i].y() - other), double(this->Size[1]));
    }
  }
  expected *= static_cast<double>(slices);
  if (!(expected <= static_cast<double>(this->CrossingsLeft)))
  {
    Refuse(this->File, "has contours that go to and fro too often for their number of points",
           "export its structures in parts");
  }
  this->CrossingsLeft -= static_cast<std::int64_t>(expected);
  std::vector<Crossing> crossings;
  for (const SliceContour* contour : plane)
  {
    this->AddCrossings(*contour, crossings);
  }
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& a, const Crossing& b)
            { return std::tie(a.Row, a.Column) < std::tie(b.Row, b.Column); });
  return crossings;
}

// Between the first and the second, the third and the fourth ... of a row; every row has an even
// number, since contours are closed.
std::vector<VoxelRun> ContourFill::RunsOf(const std::vector<Crossing>& crossings) const
{
  std::vector<VoxelRun> runs;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
  {
    const double columns = this->Size[0];
    const double first = std::clamp(std::ceil(crossings[i].Column), 0.0, columns);
    const double end = std::clamp(std::ceil(crossings[i + 1].Column), 0.0, columns);
    if (end > first)
    {
      runs.push_back({crossings[i].Row * this->Size[0] + static_cast<std::int64_t>(first),
                      static_cast<std::int64_t>(end - first)});
    }
  }
  return runs;
}

std::vector<VoxelRun> ContourFill::Runs(const std::vector<SliceContour>& contours)
{
  const std::vector<ContourPlane> planes = PlanesOf(contours);
  const std::vector<int> taken = PlaneOfSlices(planes, this->Size[2]);
  const std::int64_t sliceVoxels = static_cast<std::int64_t>(this->Size[0]) * this->Size[1];
  std::vector<VoxelRun> runs;
  std::vector<VoxelRun> ofPlane;
  for (std::size_t slice = 0; slice < taken.size(); ++slice)
  {
    const int plane = taken[slice];
    if (plane >= 0 && (slice == 0 || taken[slice - 1] != plane))
    {
      ofPlane = this->RunsOf(this->CrossingsOf(planes[static_cast<std::size_t>(plane)].Contours,
                                               std::count(taken.begin(), taken.end(), plane)));
    }
    for (std::size_t i = 0; plane >= 0 && i < ofPlane.size(); ++i)
    {
      const VoxelRun& run = ofPlane[i];
      runs.push_back({static_cast<std::int64_t>(slice) * sliceVoxels + run.First, run.Count});
    }
  }
  return runs;
}
} // namespace palpate
