#include "BrushVoxels.h"

#include "Median.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
constexpr double MostTests = 1e9;
constexpr double LeastStart = 1.5; // voxels
constexpr double LikeDeviations = 3.0;

constexpr unsigned char InStroke = 1;
constexpr unsigned char Kept = 2;
constexpr unsigned char Unlike = 3;

// Image indices, inclusive.
struct BrushBox
{
  std::array<int, 3> First{};
  std::array<int, 3> Last{};

  bool IsEmpty() const
  {
    return this->First[0] > this->Last[0] || this->First[1] > this->Last[1] ||
           this->First[2] > this->Last[2];
  }
  double Count() const
  {
    double count = this->IsEmpty() ? 0.0 : 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      count *= this->Last[axis] - this->First[axis] + 1.0;
    }
    return count;
  }
};

// A brush on its way along the segments of its path.
class SweptBrush
{
public:
  SweptBrush(const BrushStroke& stroke, const IndexToWorld& toWorld,
             const std::array<int, 3>& imageSize)
      : ToWorld(toWorld), ToIndex(toWorld.Axes.inverse()), ImageSize(imageSize),
        Plane(stroke.PointsWorld->front()), Square(stroke.Radius * stroke.Radius)
  {
    if (stroke.SliceNormal)
    {
      this->Normal = stroke.SliceNormal->normalized();
      this->HalfSlice = 0.5 * (toWorld.Axes.transpose() * this->Normal).cwiseAbs().sum();
    }
    for (Eigen::Index axis = 0; axis < 3; ++axis)
    {
      const Vector3 slope = this->ToIndex.row(axis);
      this->Reach[axis] = stroke.Radius * this->InPlane(slope).norm() +
                          this->HalfSlice * std::abs(slope.dot(this->Normal)) + 1e-6;
    }
  }

  void Follow(const Vector3& from, const Vector3& to)
  {
    this->From = from;
    this->To = to;
    this->Along = this->InPlane(to - from);
    this->Length2 = this->Along.squaredNorm();
  }
  // Of the image, around the segment.
  BrushBox Box() const
  {
    const Vector3 a = this->ToIndex * (this->From - this->ToWorld.Origin);
    const Vector3 b = this->ToIndex * (this->To - this->ToWorld.Origin);
    const Vector3 low = a.cwiseMin(b) - this->Reach;
    const Vector3 high = a.cwiseMax(b) + this->Reach;
    BrushBox box;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto n = static_cast<Eigen::Index>(axis);
      const double end = this->ImageSize[axis];
      box.First[axis] = static_cast<int>(std::clamp(std::ceil(low[n]), 0.0, end));
      box.Last[axis] = static_cast<int>(std::clamp(std::floor(high[n]), -1.0, end - 1.0));
    }
    return box;
  }
  // The voxels of a row (i from first to last) that may be within, from the sphere around the
  // segment's middle; `row` is the place of its i = 0.
  void Narrow(const Vector3& row, int& first, int& last) const
  {
    const Vector3 step = this->ToWorld.Axes.col(0);
    const Vector3 arm = 0.5 * (this->From + this->To) - row;
    const double far =
        std::sqrt(this->Square) + 0.5 * (this->To - this->From).norm() + this->HalfSlice;
    const double at = arm.dot(step) / step.squaredNorm();
    const double square = far * far - (arm - at * step).squaredNorm();
    const double half = std::sqrt(std::max(square, 0.0)) / step.norm() + 1e-6;
    if (std::isfinite(at) && std::isfinite(half)) // of a segment that ends in the infinite all are
    {
      const double end = last + 1.0;
      const double low = square < 0.0 ? end : std::ceil(at - half);
      last = static_cast<int>(std::clamp(std::floor(at + half), first - 1.0, end - 1.0));
      first = static_cast<int>(std::clamp(low, static_cast<double>(first), end));
    }
  }
  // A plane half way between slices is that of one of them, whatever rounding does.
  bool Has(const Vector3& world) const
  {
    if (this->HalfSlice > 0.0)
    {
      const double height = (world - this->Plane).dot(this->Normal) + 1e-7 * this->HalfSlice;
      if (height < -this->HalfSlice || height >= this->HalfSlice)
      {
        return false;
      }
    }
    const Vector3 arm = this->InPlane(world - this->From);
    const double at =
        this->Length2 > 0.0 ? std::clamp(arm.dot(this->Along) / this->Length2, 0.0, 1.0) : 0.0;
    return (arm - at * this->Along).squaredNorm() <= this->Square;
  }

private:
  Vector3 InPlane(const Vector3& arm) const { return arm - arm.dot(this->Normal) * this->Normal; }

  IndexToWorld ToWorld;
  Matrix3 ToIndex;
  std::array<int, 3> ImageSize;
  Vector3 Plane;
  double Square;
  Vector3 Normal = Vector3::Zero(); // of a ball
  double HalfSlice = 0.0;
  Vector3 Reach = Vector3::Zero();
  Vector3 From = Vector3::Zero();
  Vector3 To = Vector3::Zero();
  Vector3 Along = Vector3::Zero();
  double Length2 = 0.0;
};

Status CheckStroke(const BrushStroke& stroke)
{
  if (stroke.PointsWorld == nullptr || stroke.PointsWorld->empty() ||
      stroke.PointsWorld->size() > BrushStroke::MostPoints)
  {
    return Status::Failure("is a stroke without points, or with more than 10,000");
  }
  if (!(stroke.Radius >= BrushStroke::LeastRadius) ||
      !(stroke.Radius <= BrushStroke::LargestRadius))
  {
    return Status::Failure("has a brush whose radius is not from 0.1 to 50 mm");
  }
  const bool isFlat =
      !stroke.SliceNormal || (stroke.SliceNormal->allFinite() && stroke.SliceNormal->norm() > 0.0);
  const bool isThere = std::all_of(stroke.PointsWorld->begin(), stroke.PointsWorld->end(),
                                   [](const Vector3& point) { return point.allFinite(); });
  return isFlat && isThere
             ? Status::Success()
             : Status::Failure("has a point or normal that is not finite, or a normal of 0");
}

// Calls `visit` with the brush on each segment of the path.
template <typename Visit>
void ForEachSegment(const BrushStroke& stroke, SweptBrush& brush, const Visit& visit)
{
  const BrushStroke::Path& path = *stroke.PointsWorld;
  for (std::size_t n = path.size() > 1 ? 1 : 0; n < path.size(); ++n)
  {
    brush.Follow(path[n > 0 ? n - 1 : 0], path[n]);
    visit(brush.Box());
  }
}

void Sweep(const SweptBrush& brush, const BrushBox& box, const IndexToWorld& toWorld,
           VoxelMask& made)
{
  for (int k = box.First[2]; k <= box.Last[2]; ++k)
  {
    for (int j = box.First[1]; j <= box.Last[1]; ++j)
    {
      int first = box.First[0];
      int last = box.Last[0];
      brush.Narrow(toWorld(Vector3(0.0, j, k)), first, last);
      unsigned char* voxel = &made.Inside[made.Offset(
          first - made.StartIndex[0], j - made.StartIndex[1], k - made.StartIndex[2])];
      for (int i = first; i <= last; ++i, ++voxel)
      {
        if (*voxel == 0 && brush.Has(toWorld(Vector3(i, j, k))))
        {
          *voxel = InStroke;
        }
      }
    }
  }
}

// Of the values at a stroke's start, from their median; then what differs from it by more is unlike
// them.
std::pair<double, double> LevelAndTolerance(const VoxelMask& start, const ValueAtVoxel& value)
{
  std::vector<double> values;
  for (const IndexRun& run : ImageRunsOf(start))
  {
    for (int n = 0; n < run.Count; ++n)
    {
      const double one = value({run.First[0] + n, run.First[1], run.First[2]});
      if (std::isfinite(one))
      {
        values.push_back(one);
      }
    }
  }
  if (values.empty())
  {
    return {0.0, -1.0};
  }
  const double level = UpperMedian(values);
  double mean = 0.0;
  for (double& one : values)
  {
    one = std::abs(one - level);
    mean += one / static_cast<double>(values.size());
  }
  const double middle = UpperMedian(values);
  return {level, LikeDeviations * (middle > 0.0 ? 1.4826 * middle : 1.2533 * mean)};
}

// Grows from voxels of the start; the boxes are the same.
class EdgeGrowth
{
public:
  EdgeGrowth(VoxelMask& stroke, const ValueAtVoxel& value, double level, double tolerance)
      : Stroke(stroke), Value(value), Level(level),
        Tolerance(tolerance), Steps{1, stroke.Size[0],
                                    static_cast<std::ptrdiff_t>(stroke.Offset(0, 0, 1))}
  {
  }

  void Grow(const std::vector<IndexRun>& start)
  {
    for (const IndexRun& run : start)
    {
      for (int n = 0; n < run.Count; ++n)
      {
        this->Test(static_cast<std::ptrdiff_t>(this->Stroke.Offset(
            run.First[0] + n - this->Stroke.StartIndex[0],
            run.First[1] - this->Stroke.StartIndex[1], run.First[2] - this->Stroke.StartIndex[2])));
      }
    }
    while (!this->Pending.empty())
    {
      const std::ptrdiff_t at = this->Pending.back();
      this->Pending.pop_back();
      this->ForNeighbors(at, [this](std::ptrdiff_t next) { this->Test(next); });
    }
    this->KeepSingles();
    for (unsigned char& voxel : this->Stroke.Inside)
    {
      voxel = voxel == Kept ? 1 : 0;
    }
  }

private:
  template <typename Visit>
  void ForNeighbors(std::ptrdiff_t at, const Visit& visit)
  {
    for (const std::ptrdiff_t step : this->Steps)
    {
      visit(at - step);
      visit(at + step);
    }
  }
  unsigned char& Voxel(std::ptrdiff_t at)
  {
    return this->Stroke.Inside[static_cast<std::size_t>(at)];
  }
  std::array<int, 3> IndexOf(std::ptrdiff_t at) const
  {
    const auto row = static_cast<int>(at / this->Steps[1]);
    return {this->Stroke.StartIndex[0] + static_cast<int>(at % this->Steps[1]),
            this->Stroke.StartIndex[1] + row % this->Stroke.Size[1],
            this->Stroke.StartIndex[2] + row / this->Stroke.Size[1]};
  }
  void Test(std::ptrdiff_t at)
  {
    if (this->Voxel(at) == InStroke)
    {
      const bool isLike = std::abs(this->Value(this->IndexOf(at)) - this->Level) <= this->Tolerance;
      this->Voxel(at) = isLike ? Kept : Unlike;
      (isLike ? this->Pending : this->Others).push_back(at);
    }
  }
  void KeepSingles()
  {
    constexpr int Enclosing = 3; // fewer are at the stroke's own border
    std::vector<std::ptrdiff_t> singles;
    for (const std::ptrdiff_t at : this->Others)
    {
      int kept = 0;
      int others = 0;
      this->ForNeighbors(at,
                         [&](std::ptrdiff_t next)
                         {
                           kept += this->Voxel(next) == Kept ? 1 : 0;
                           others += this->Voxel(next) == Unlike || this->Voxel(next) == InStroke;
                         });
      if (others == 0 && kept >= Enclosing)
      {
        singles.push_back(at);
      }
    }
    for (const std::ptrdiff_t at : singles)
    {
      this->Voxel(at) = Kept;
    }
  }

  VoxelMask& Stroke;
  const ValueAtVoxel& Value;
  double Level;
  double Tolerance;
  std::array<std::ptrdiff_t, 3> Steps;
  std::vector<std::ptrdiff_t> Pending;
  std::vector<std::ptrdiff_t> Others;
};
} // namespace

Status MakeStroke(const BrushStroke& stroke, const IndexToWorld& toWorld,
                  const std::array<int, 3>& imageSize, VoxelMask& made)
{
  if (Status status = CheckStroke(stroke); !status.IsOk())
  {
    return status;
  }
  SweptBrush brush(stroke, toWorld, imageSize);
  BrushBox all{{imageSize[0], imageSize[1], imageSize[2]}, {-1, -1, -1}};
  double tests = 0.0;
  ForEachSegment(stroke, brush,
                 [&](const BrushBox& box)
                 {
                   tests += box.Count();
                   for (std::size_t axis = 0; axis < 3 && !box.IsEmpty(); ++axis)
                   {
                     all.First[axis] = std::min(all.First[axis], box.First[axis]);
                     all.Last[axis] = std::max(all.Last[axis], box.Last[axis]);
                   }
                 });
  if (tests > MostTests)
  {
    return Status::Failure("is a stroke over too many voxels; make it shorter, or the brush "
                           "smaller");
  }
  VoxelMask mask;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    mask.Spacing[axis] = toWorld.Axes.col(static_cast<Eigen::Index>(axis)).norm();
    mask.StartIndex[axis] = all.First[axis] - 1;
    mask.Size[axis] = all.IsEmpty() ? 0 : all.Last[axis] - all.First[axis] + 3;
  }
  mask.Inside.assign(mask.Offset(0, 0, mask.Size[2]), 0);
  ForEachSegment(stroke, brush,
                 [&](const BrushBox& box)
                 {
                   if (!box.IsEmpty())
                   {
                     Sweep(brush, box, toWorld, mask);
                   }
                 });
  made = std::move(mask);
  return Status::Success();
}

Status MakeStrokeToEdges(const BrushStroke& stroke, const IndexToWorld& toWorld,
                         const std::array<int, 3>& imageSize, const ValueAtVoxel& value,
                         VoxelMask& made)
{
  Status status = MakeStroke(stroke, toWorld, imageSize, made);
  if (!status.IsOk())
  {
    return status;
  }
  BrushStroke begin = stroke;
  begin.PointsWorld = std::make_shared<const BrushStroke::Path>(1, stroke.PointsWorld->front());
  const double voxel = *std::min_element(made.Spacing.begin(), made.Spacing.end());
  begin.Radius = std::min(stroke.Radius, std::max(0.5 * stroke.Radius, LeastStart * voxel));
  VoxelMask start;
  status = MakeStroke(begin, toWorld, imageSize, start);
  if (status.IsOk())
  {
    const auto [level, tolerance] = LevelAndTolerance(start, value);
    EdgeGrowth(made, value, level, tolerance).Grow(ImageRunsOf(start));
  }
  return status;
}

std::vector<IndexRun> ImageRunsOf(const VoxelMask& mask)
{
  std::vector<IndexRun> runs;
  const unsigned char* row = mask.Inside.data();
  for (int k = 0; k < mask.Size[2]; ++k)
  {
    for (int j = 0; j < mask.Size[1]; ++j, row += mask.Size[0])
    {
      for (int i = 0; i < mask.Size[0]; ++i)
      {
        if (row[i] != 0 && i > 0 && row[i - 1] != 0)
        {
          ++runs.back().Count;
        }
        else if (row[i] != 0)
        {
          runs.push_back(
              {{mask.StartIndex[0] + i, mask.StartIndex[1] + j, mask.StartIndex[2] + k}, 1});
        }
      }
    }
  }
  return runs;
}
} // namespace palpate
