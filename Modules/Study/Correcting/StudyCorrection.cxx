#include "StudyCorrection.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

namespace palpate
{
namespace
{
auto Fields(const StudyCorrection& c)
{
  return std::tie(c.StructureId, c.Steps, c.Neighbors);
}

struct StepTitle
{
  std::string operator()(const SurfacePull& /*pull*/) const { return "Pull the surface"; }
  std::string operator()(const IslandRemoval& /*removal*/) const { return "Remove islands"; }
  std::string operator()(const CavityFilling& /*filling*/) const { return "Fill cavities"; }
  std::string operator()(const SurfaceSmoothing& /*smoothing*/) const
  {
    return "Smooth the surface";
  }
  std::string operator()(const PlaneCut& /*cut*/) const { return "Cut at a plane"; }
  std::string operator()(const BrushStroke& stroke) const
  {
    return stroke.Erases ? "Erase by a brush" : "Paint by a brush";
  }
  std::string operator()(const VoxelEdit& edit) const
  {
    return edit.Erases ? "Erase to edges" : "Paint to edges";
  }
  std::string operator()(const SliceCopy& /*copy*/) const { return "Copy a slice"; }
  std::string operator()(const SliceFilling& /*filling*/) const { return "Fill between slices"; }
};

struct NumberCount
{
  std::size_t operator()(const BrushStroke& stroke) const { return 3 * stroke.PointsWorld->size(); }
  std::size_t operator()(const VoxelEdit& edit) const { return 4 * edit.Runs->size(); }
  template <typename Other>
  std::size_t operator()(const Other& /*step*/) const
  {
    return 0;
  }
};

// The slice in which a step paints, if it does so in one.
struct PaintedSlice
{
  const IndexToWorld& Grid;

  std::optional<GridSlice> operator()(const BrushStroke& stroke) const
  {
    return stroke.SliceNormal
               ? SliceOfPlane(this->Grid, stroke.PointsWorld->front(), *stroke.SliceNormal)
               : std::nullopt;
  }
  std::optional<GridSlice> operator()(const VoxelEdit& edit) const
  {
    for (const std::size_t axis : {2U, 1U, 0U})
    {
      const int slice = edit.Runs->empty() ? 0 : edit.Runs->front().First[axis];
      const auto isIn = [&](const IndexRun& run)
      { return run.First[axis] == slice && (axis != 0 || run.Count == 1); };
      if (!edit.Runs->empty() && std::all_of(edit.Runs->begin(), edit.Runs->end(), isIn))
      {
        return GridSlice{static_cast<int>(axis), slice};
      }
    }
    return std::nullopt;
  }
  std::optional<GridSlice> operator()(const SliceCopy& copy) const
  {
    return GridSlice{copy.Axis, copy.To};
  }
  template <typename Other>
  std::optional<GridSlice> operator()(const Other& /*step*/) const
  {
    return std::nullopt;
  }
};
} // namespace

bool operator==(const StudyCorrection& a, const StudyCorrection& b)
{
  return Fields(a) == Fields(b);
}

SurfacePull PullAt(const PullWidth& width, const Vector3& placeWorld)
{
  SurfacePull pull;
  pull.PlaceWorld = placeWorld;
  pull.Width = std::clamp(width.Width, PullWidth::Least, PullWidth::Largest);
  pull.SecondWidth = width.HasTwo ? PullWidth::Second * pull.Width : 0.0;
  return pull;
}

std::optional<double> OffsetOnNormal(const Vector3& place, const Vector3& normal,
                                     const Vector3& from, const Vector3& to)
{
  constexpr double LeastSine = 0.42; // of 25 degrees
  const Vector3 sight = (to - from).normalized();
  const double along = normal.dot(sight);
  const double square = 1.0 - along * along;
  if (!(square > LeastSine * LeastSine))
  {
    return std::nullopt;
  }
  const Vector3 apart = place - from;
  return (along * sight.dot(apart) - normal.dot(apart)) / square;
}

std::size_t NumbersIn(const std::vector<CorrectionStep>& steps)
{
  std::size_t count = 0;
  for (const CorrectionStep& step : steps)
  {
    count += std::visit(NumberCount(), step);
  }
  return count;
}

std::optional<GridSlice> SliceOfPlane(const IndexToWorld& grid, const Vector3& pointWorld,
                                      const Vector3& normal)
{
  constexpr double LeastCosine = 0.9994; // of 2 degrees
  const Matrix3 toIndex = grid.Axes.inverse();
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    const Vector3 across = toIndex.row(axis);
    if (std::abs(across.normalized().dot(normal.normalized())) > LeastCosine)
    {
      const double index = across.dot(pointWorld - grid.Origin);
      return GridSlice{static_cast<int>(axis),
                       static_cast<int>(std::clamp(std::round(index), -1e6, 1e6))};
    }
  }
  return std::nullopt;
}

std::optional<SliceFilling> FillingBetweenPainted(const std::vector<CorrectionStep>& steps,
                                                  const IndexToWorld& grid)
{
  std::optional<GridSlice> last;
  for (auto step = steps.rbegin(); step != steps.rend(); ++step)
  {
    const std::optional<GridSlice> one = std::visit(PaintedSlice{grid}, *step);
    if (!last)
    {
      last = one;
    }
    else if (one && one->Axis == last->Axis && std::abs(one->Slice - last->Slice) > 1)
    {
      return SliceFilling{last->Axis, std::min(one->Slice, last->Slice),
                          std::max(one->Slice, last->Slice)};
    }
  }
  return std::nullopt;
}

std::string NameOf(const CorrectionStep& step)
{
  return std::visit(StepTitle(), step);
}
} // namespace palpate
