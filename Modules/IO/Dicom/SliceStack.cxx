#include "SliceStack.h"

#include "DecimalText.h"
#include "Refusal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

namespace palpate
{
namespace
{
// Tolerance of slice positions that are taken as they are, as a fraction of the spacing; decimal
// strings in DICOM are often rounded to a hundredth of a millimetre.
constexpr double EvenTolerance = 0.02;

// Of a voxel: what rounding of positions may move it.
constexpr double RoundedTolerance = 0.1;

// More than any scan has, and within the range of an index.
constexpr double MostSlices = 65536.0;

/// Planes, their distances along the normal from the first one given (mm), and their order.
struct OrderedPlanes
{
  const std::vector<StackedSlice>& Planes;
  std::vector<double> Heights;
  std::vector<std::size_t> Order;           // of planes, by height
  std::vector<double> DistinctHeights;      // sorted; within a thousandth of a millimetre merged
  std::vector<std::size_t> FirstOfDistinct; // a plane at each

  const StackedSlice& Lowest() const { return this->Planes[this->Order.front()]; }
  double Extent() const { return this->DistinctHeights.back() - this->DistinctHeights.front(); }
};

OrderedPlanes Ordered(const std::filesystem::path& file, const std::vector<StackedSlice>& planes)
{
  OrderedPlanes ordered{planes, {}, {}, {}, {}};
  const Vector3 normal = planes.front().NormalWorld();
  for (const StackedSlice& plane : planes)
  {
    ordered.Heights.push_back(normal.dot(plane.PositionWorld - planes.front().PositionWorld));
    if (!std::isfinite(ordered.Heights.back()))
    {
      Refuse(file, "has a slice at an infinite distance", "export it again");
    }
  }
  ordered.Order.resize(planes.size());
  std::iota(ordered.Order.begin(), ordered.Order.end(), std::size_t{0});
  std::stable_sort(ordered.Order.begin(), ordered.Order.end(),
                   [&](std::size_t a, std::size_t b)
                   { return ordered.Heights[a] < ordered.Heights[b]; });
  for (const std::size_t plane : ordered.Order)
  {
    const double height = ordered.Heights[plane];
    if (ordered.DistinctHeights.empty() || !(height - ordered.DistinctHeights.back() < 1e-3))
    {
      ordered.DistinctHeights.push_back(height);
      ordered.FirstOfDistinct.push_back(plane);
    }
  }
  return ordered;
}

// Of adjacent slices, ascending.
std::vector<double> SortedGaps(const OrderedPlanes& ordered)
{
  const std::vector<double>& heights = ordered.DistinctHeights;
  std::vector<double> gaps;
  for (std::size_t i = 1; i < heights.size(); ++i)
  {
    gaps.push_back(heights[i] - heights[i - 1]);
  }
  std::sort(gaps.begin(), gaps.end());
  return gaps;
}

// The mean of the gaps without missing slices, which rounding makes different.
double UsualGap(const std::vector<double>& sortedGaps)
{
  constexpr double MissingSlice = 1.5; // of the median
  const double most = MissingSlice * sortedGaps[sortedGaps.size() / 2];
  const auto end = std::upper_bound(sortedGaps.begin(), sortedGaps.end(), most);
  return std::accumulate(sortedGaps.begin(), end, 0.0) /
         static_cast<double>(end - sortedGaps.begin());
}

// What lies between two adjacent slices that are not as far apart as most.
std::string GapText(const OrderedPlanes& ordered, std::size_t upper, double usual)
{
  const double gap = ordered.DistinctHeights[upper] - ordered.DistinctHeights[upper - 1];
  const auto missing = static_cast<std::int64_t>(std::llround(std::min(gap / usual, 1e6))) - 1;
  return (missing > 0 ? "about " + CountText(missing, "slice", "slices") + " missing"
                      : SignificantText(gap) + " mm") +
         " between " + ordered.Planes[ordered.FirstOfDistinct[upper - 1]].Place() + " and " +
         ordered.Planes[ordered.FirstOfDistinct[upper]].Place();
}

[[noreturn]] void RefuseUneven(const std::filesystem::path& file, const OrderedPlanes& ordered)
{
  constexpr int MostNamed = 3;
  const std::vector<double> gaps = SortedGaps(ordered);
  const double usual = UsualGap(gaps);
  // Missing slices, or what else is uneven.
  const double from = gaps.back() > 1.5 * usual ? 0.5 : RoundedTolerance;
  std::string named;
  int count = 0;
  for (std::size_t i = 1; i < ordered.DistinctHeights.size(); ++i)
  {
    const double gap = ordered.DistinctHeights[i] - ordered.DistinctHeights[i - 1];
    if (std::abs(gap - usual) > from * usual && ++count <= MostNamed)
    {
      named += (named.empty() ? ": " : "; ") + GapText(ordered, i, usual);
    }
  }
  named += count > MostNamed ? "; and " + std::to_string(count - MostNamed) + " more" : "";
  Refuse(file,
         "has uneven gaps between its slices (" + SignificantText(gaps.front()) + " to " +
             SignificantText(gaps.back()) + " mm)" + named,
         "add the missing slices or resample it");
}

void CheckSinglePlanes(const std::filesystem::path& file, const OrderedPlanes& ordered)
{
  const std::size_t count = ordered.Planes.size();
  if (count < 2)
  {
    Refuse(file, "is a single slice", "use a volume of at least two slices");
  }
  if (ordered.DistinctHeights.size() == count)
  {
    return;
  }
  std::size_t pair = 1;
  while (ordered.Heights[ordered.Order[pair]] - ordered.Heights[ordered.Order[pair - 1]] >= 1e-3)
  {
    ++pair;
  }
  const StackedSlice& one = ordered.Planes[ordered.Order[pair - 1]];
  const StackedSlice& other = ordered.Planes[ordered.Order[pair]];
  const std::string names =
      one.Name.empty() ? "" : ", such as " + one.Name + " and " + other.Place();
  Refuse(file,
         "has " + std::to_string(count) + " images in " +
             std::to_string(ordered.DistinctHeights.size()) + " positions" + names +
             ": it mixes several volumes (times, echoes or repetitions)",
         "put one of them into a separate folder");
}

void CheckParallel(const std::filesystem::path& file, const std::vector<StackedSlice>& planes)
{
  const auto other =
      std::find_if(planes.begin(), planes.end(),
                   [&](const StackedSlice& plane) { return !plane.IsParallelTo(planes.front()); });
  if (other != planes.end())
  {
    const std::string names =
        other->Name.empty() ? "" : " (" + planes.front().Place() + " and " + other->Place() + ")";
    Refuse(file, "mixes slices of different orientation, size or pixel spacing" + names,
           "put each orientation into a separate folder");
  }
}

// The largest sideways distance from a position, in pixels.
double SidewaysDrift(const OrderedPlanes& ordered, const Vector3& positionWorld)
{
  const StackedSlice& first = ordered.Planes.front();
  double drift = 0.0;
  for (const StackedSlice& plane : ordered.Planes)
  {
    const Vector3 offset = plane.PositionWorld - positionWorld;
    drift = std::max({drift, std::abs(offset.dot(first.RowWorld)) / first.Spacing[0],
                      std::abs(offset.dot(first.ColumnWorld)) / first.Spacing[1]});
  }
  return drift;
}

// The largest distance of a height from a whole number of steps, in steps.
double StepDeviation(const std::vector<double>& distinct, double step)
{
  double deviation = 0.0;
  for (const double height : distinct)
  {
    const double slices = (height - distinct.front()) / step;
    deviation = std::max(deviation, std::abs(slices - std::round(slices)));
  }
  return deviation;
}

/// Slice i is at First + i Step Axis, mm.
struct SliceLine
{
  Vector3 First = Vector3::Zero();
  Vector3 Axis = Vector3::UnitZ();
  double Step = 0.0;
};

// The line closest to the planes in the sense of least squares.
SliceLine FitLine(const OrderedPlanes& ordered)
{
  const double middle = 0.5 * static_cast<double>(ordered.Order.size() - 1);
  const Vector3 base = ordered.Lowest().PositionWorld;
  Vector3 mean = Vector3::Zero();
  Vector3 moment = Vector3::Zero();
  double squares = 0.0;
  for (std::size_t i = 0; i < ordered.Order.size(); ++i)
  {
    const Vector3 offset = ordered.Planes[ordered.Order[i]].PositionWorld - base;
    const double place = static_cast<double>(i) - middle;
    mean += offset / static_cast<double>(ordered.Order.size());
    moment += place * offset;
    squares += place * place;
  }
  const Vector3 step = moment / squares;
  return {base + mean - middle * step, step.normalized(), step.norm()};
}

// Of positions that are even up to EvenTolerance.
std::optional<SliceLine> ExactLine(const OrderedPlanes& ordered)
{
  const std::vector<double>& distinct = ordered.DistinctHeights;
  const double step = ordered.Extent() / static_cast<double>(distinct.size() - 1);
  for (std::size_t i = 0; i < distinct.size(); ++i)
  {
    const double place = distinct.front() + static_cast<double>(i) * step;
    if (!(std::abs(distinct[i] - place) <= EvenTolerance * step))
    {
      return std::nullopt;
    }
  }
  if (SidewaysDrift(ordered, ordered.Lowest().PositionWorld) > RoundedTolerance)
  {
    return std::nullopt;
  }
  return SliceLine{ordered.Lowest().PositionWorld, ordered.Planes.front().NormalWorld(), step};
}

// The closest line, if its slices are within a tenth of a voxel.
SliceLine RoundedLine(const std::filesystem::path& file, const OrderedPlanes& ordered,
                      std::vector<std::string>& notes)
{
  const StackedSlice& first = ordered.Planes.front();
  const SliceLine line = FitLine(ordered);
  const double step = line.Step * line.Axis.dot(first.NormalWorld());
  double farthest = 0.0;
  for (std::size_t i = 0; i < ordered.Order.size(); ++i)
  {
    const StackedSlice& plane = ordered.Planes[ordered.Order[i]];
    const Vector3 offset =
        plane.PositionWorld - line.First - static_cast<double>(i) * line.Step * line.Axis;
    if (!(std::abs(offset.dot(first.NormalWorld())) <= RoundedTolerance * step))
    {
      RefuseUneven(file, ordered);
    }
    if (!(std::abs(offset.dot(first.RowWorld)) <= RoundedTolerance * first.Spacing[0] &&
          std::abs(offset.dot(first.ColumnWorld)) <= RoundedTolerance * first.Spacing[1]))
    {
      Refuse(file,
             "has slices that are shifted sideways against each other, unevenly (" +
                 SignificantText(offset.norm(), 2) + " mm" +
                 (plane.Name.empty() ? "" : " in " + plane.Place()) + ")",
             "export it again, or correct its slice positions");
    }
    farthest = std::max(farthest, offset.norm());
  }
  // A tilted gantry's positions are even.
  if (farthest > EvenTolerance * step)
  {
    notes.push_back("Slice positions are up to " + SignificantText(farthest, 2) +
                    " mm from even ones, as if rounded; slices were placed evenly.");
  }
  return line;
}

// The step of planes of which some may be absent.
double SparseStep(const std::filesystem::path& file, const OrderedPlanes& ordered,
                  const std::optional<double>& stated, std::vector<std::string>& notes)
{
  const std::vector<double>& distinct = ordered.DistinctHeights;
  const bool isStated = stated && *stated > 0.0;
  if (isStated && StepDeviation(distinct, *stated) <= EvenTolerance)
  {
    return *stated;
  }
  if (distinct.size() < 2)
  {
    Refuse(file, "does not state the distance between its slices",
           "export it again with its slice thickness");
  }
  // A rounded gap accumulates an error over many slices; the mean over a whole number of gaps does
  // not.
  const auto meanStep = [&](double gap)
  { return ordered.Extent() / std::max(1.0, std::round(ordered.Extent() / gap)); };
  const std::vector<double> gaps = SortedGaps(ordered);
  const double step = meanStep(gaps.front());
  if (StepDeviation(distinct, step) <= EvenTolerance)
  {
    return step;
  }
  for (const double rounded : {isStated ? meanStep(*stated) : step, isStated ? *stated : step, step,
                               meanStep(UsualGap(gaps))})
  {
    if (const double deviation = StepDeviation(distinct, rounded); deviation <= RoundedTolerance)
    {
      notes.push_back("Slice positions are up to " + SignificantText(deviation * rounded, 2) +
                      " mm from even ones, as if rounded; slices were placed evenly.");
      return rounded;
    }
  }
  RefuseUneven(file, ordered);
}

// Planes of absent slices have no line to be fitted.
SliceLine SparseLine(const std::filesystem::path& file, const OrderedPlanes& ordered,
                     const SliceStackRules& rules, std::vector<std::string>& notes)
{
  const StackedSlice& lowest = ordered.Lowest();
  Vector3 mean = Vector3::Zero();
  for (const StackedSlice& plane : ordered.Planes)
  {
    mean +=
        (plane.PositionWorld - lowest.PositionWorld) / static_cast<double>(ordered.Planes.size());
  }
  const Vector3 normal = ordered.Planes.front().NormalWorld();
  const Vector3 sideways = mean - mean.dot(normal) * normal;
  SliceLine line{lowest.PositionWorld, normal, 0.0};
  if (SidewaysDrift(ordered, line.First) > RoundedTolerance)
  {
    line.First += sideways;
    if (SidewaysDrift(ordered, line.First) > RoundedTolerance)
    {
      Refuse(file, "has slices that are shifted sideways against each other (a sheared volume)",
             "resample it to a rectangular grid");
    }
  }
  line.Step = SparseStep(file, ordered, rules.StatedStep, notes);
  return line;
}
} // namespace

std::string PlaceAlong(const Vector3& normalWorld, const Vector3& positionWorld)
{
  constexpr std::array<const char*, 3> Axes{{"L ", "P ", "S "}};
  Eigen::Index axis = 0;
  normalWorld.cwiseAbs().maxCoeff(&axis);
  return Axes[static_cast<std::size_t>(axis)] + SignificantText(positionWorld[axis]) + " mm";
}

std::string StackedSlice::Place() const
{
  const std::string place = PlaceAlong(this->NormalWorld(), this->PositionWorld);
  return this->Name.empty() ? place : this->Name + " at " + place;
}

bool StackedSlice::IsParallelTo(const StackedSlice& other) const
{
  constexpr double Tolerance = 1e-4;
  return this->Columns == other.Columns && this->Rows == other.Rows &&
         (this->RowWorld - other.RowWorld).norm() < Tolerance &&
         (this->ColumnWorld - other.ColumnWorld).norm() < Tolerance &&
         (this->Spacing - other.Spacing).norm() < Tolerance * other.Spacing.norm();
}

SliceStack StackSlices(const std::filesystem::path& file, const std::vector<StackedSlice>& planes,
                       const SliceStackRules& rules)
{
  const OrderedPlanes ordered = Ordered(file, planes);
  CheckParallel(file, planes);
  SliceStack stack;
  SliceLine line;
  if (rules.Sparse)
  {
    line = SparseLine(file, ordered, rules, stack.Notes);
  }
  else
  {
    CheckSinglePlanes(file, ordered);
    const std::optional<SliceLine> exact = ExactLine(ordered);
    line = exact ? *exact : RoundedLine(file, ordered, stack.Notes);
  }
  const StackedSlice& first = planes.front();
  // Exactly the step of a line along the normal.
  const double cosine = line.Axis == first.NormalWorld() ? 1.0 : line.Axis.dot(first.NormalWorld());
  const double step = line.Step * cosine;
  if (ordered.DistinctHeights.size() > 1 && !(ordered.Extent() / step < MostSlices))
  {
    Refuse(file,
           "has slices that are " + SignificantText(ordered.Extent() / step) +
               " slice spacings apart",
           "export it again, or correct its slice positions");
  }
  for (const double height : ordered.Heights)
  {
    stack.SliceOfPlane.push_back(
        static_cast<int>(std::lround((height - ordered.DistinctHeights.front()) / step)));
  }
  const int slices = 1 + *std::max_element(stack.SliceOfPlane.begin(), stack.SliceOfPlane.end());
  stack.Grid.Size = {first.Columns, first.Rows, slices};
  stack.Grid.Spacing = Vector3(first.Spacing[0], first.Spacing[1], line.Step);
  stack.Grid.OriginWorld = line.First;
  stack.Grid.Direction << first.RowWorld, first.ColumnWorld, line.Axis;
  return stack;
}
} // namespace palpate
