#include "TubeAxis.h"

#include "LevelLoops.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::size_t LeastSections = 5;
constexpr std::size_t MostSections = 4000;
// Sections whose centres give a direction: 1.5 diameters.
constexpr std::size_t PointsOfDirection = 7;

double RadiusOf(const LoopSection& section)
{
  return std::sqrt(section.Area / M_PI);
}

// Mm along a polygon, at each of its corners.
std::vector<double> LengthsAlong(const std::vector<Vector3>& points)
{
  std::vector<double> lengths{0.0};
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    lengths.push_back(lengths.back() + (points[i + 1] - points[i]).norm());
  }
  return lengths;
}

// The derivative, at one of several points on a curve, of the parabola through all.
Vector3 SlopeAt(const std::vector<Vector3>& points, const std::vector<double>& lengths,
                std::size_t first, std::size_t count, std::size_t at)
{
  const auto rows = static_cast<Eigen::Index>(count);
  Eigen::MatrixX3d powers(rows, 3);
  Eigen::MatrixX3d values(rows, 3);
  for (Eigen::Index row = 0; row < rows; ++row)
  {
    const std::size_t point = first + static_cast<std::size_t>(row);
    const double along = lengths[point] - lengths[at];
    powers.row(row) << 1.0, along, along * along;
    values.row(row) = points[point].transpose();
  }
  const Matrix3 fitted = powers.householderQr().solve(values);
  return fitted.row(1).transpose().stableNormalized();
}
} // namespace

Status TubeAxis::Measure(const IndexedMesh& tube, std::vector<Vector3> points, double step,
                         Calibre& measured)
{
  TubeAxis axis(tube, std::move(points), step);
  if (Status status = MeshRays::Make(tube, axis.Rays); !status.IsOk())
  {
    return status;
  }
  const auto isShort = [&] { return axis.Points.size() < LeastSections; };
  if (!isShort())
  {
    axis.Extend();
    std::reverse(axis.Points.begin(), axis.Points.end());
    axis.Extend();
  }
  return isShort() ? Status::Failure("has no axis") : axis.Finish(measured);
}

// The curve around a point of the axis: whose centre is nearest, in comparison with its size.
bool TubeAxis::FindLoop(const Vector3& point, const Vector3& axis, Loop& loop) const
{
  std::vector<double> heights;
  heights.reserve(this->Tube.Points.size());
  for (const Vector3& one : this->Tube.Points)
  {
    heights.push_back(axis.dot(one - point));
  }
  double least = std::numeric_limits<double>::infinity();
  for (Loop& one : LevelLoopsOf(this->Tube, heights))
  {
    const LoopSection section = EnclosedBy(one, axis);
    const double distance = (section.Center - point).norm() - RadiusOf(section);
    if (distance < least)
    {
      least = distance;
      loop = std::move(one);
    }
  }
  return std::isfinite(least);
}

std::vector<Vector3> TubeAxis::Directions() const
{
  const std::vector<double> lengths = LengthsAlong(this->Points);
  const std::size_t count = std::min(PointsOfDirection, this->Points.size());
  std::vector<Vector3> directions;
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    const std::size_t first = std::min(i - std::min(i, count / 2), this->Points.size() - count);
    directions.push_back(SlopeAt(this->Points, lengths, first, count, i));
  }
  return directions;
}

// Adds points at the end of the list as long as one more lies at least a radius inside the end.
void TubeAxis::Extend()
{
  while (this->Points.size() < MostSections)
  {
    const std::size_t count = std::min(PointsOfDirection, this->Points.size());
    const std::vector<Vector3> last(this->Points.end() - static_cast<std::ptrdiff_t>(count),
                                    this->Points.end());
    const Vector3 direction = SlopeAt(last, LengthsAlong(last), 0, count, count - 1);
    const Vector3 next = last.back() + this->Step * direction;
    Loop loop;
    if (!(this->Rays.ExitFrom(last.back(), direction) > this->Step) ||
        !this->FindLoop(next, direction, loop))
    {
      return;
    }
    const LoopSection section = EnclosedBy(loop, direction);
    const double rest = this->Rays.ExitFrom(section.Center, direction);
    const bool isOn = (section.Center - last.back()).dot(direction) > 0.5 * this->Step &&
                      (section.Center - next).norm() < 2.0 * this->Step;
    if (!isOn || !(rest >= RadiusOf(section)))
    {
      return;
    }
    this->Points.push_back(section.Center);
  }
}

Status TubeAxis::Finish(Calibre& measured) const
{
  const std::vector<Vector3> directions = this->Directions();
  std::vector<Vector3> centers;
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    Loop loop;
    if (this->FindLoop(this->Points[i], directions[i], loop))
    {
      const LoopSection section = SectionOf(loop, directions[i]);
      centers.push_back(section.Center);
      measured.Sections.push_back(
          {0.0, section.Center, directions[i], section.Area, section.Least, section.Largest});
    }
  }
  if (centers.size() < LeastSections)
  {
    return Status::Failure("has no sections");
  }
  const double before = this->Rays.ExitFrom(centers.front(), -measured.Sections.front().Axis);
  const double after = this->Rays.ExitFrom(centers.back(), measured.Sections.back().Axis);
  if (!std::isfinite(before + after))
  {
    return Status::Failure("has an axis without ends");
  }
  const std::vector<double> lengths = LengthsAlong(centers);
  for (std::size_t i = 0; i < centers.size(); ++i)
  {
    measured.Sections[i].Along = before + lengths[i];
  }
  measured.Length = before + lengths.back() + after;
  return Status::Success();
}
} // namespace palpate
