#include "ToolShape.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <string>
#include <utility>

namespace palpate
{
namespace
{
bool IsLength(double length)
{
  return length >= 0.0 && std::isfinite(length);
}

// The extent of a tool with these lengths; no value if any of them is invalid.
double ExtentOf(std::initializer_list<double> lengths, double extent)
{
  return std::all_of(lengths.begin(), lengths.end(), IsLength)
             ? extent
             : std::numeric_limits<double>::quiet_NaN();
}

// Outward unit vectors to the neighbours of a voxel: those that share a face, or all.
std::vector<Vector3> NeighbourDirections(bool onlyFaces)
{
  std::vector<Vector3> directions;
  for (int k = -1; k <= 1; ++k)
  {
    for (int j = -1; j <= 1; ++j)
    {
      for (int i = -1; i <= 1; ++i)
      {
        const int steps = std::abs(i) + std::abs(j) + std::abs(k);
        if (onlyFaces ? steps == 1 : steps > 0)
        {
          directions.push_back(Vector3(i, j, k).normalized());
        }
      }
    }
  }
  return directions;
}

// The n-th of `count` points on a spiral around z at equal steps of height, from -1 to 1. On a
// sphere and on a cylinder the area between two heights is proportional to their difference
// (Archimedes), so each point represents the same area.
struct SpiralPoint
{
  double Height;
  Vector3 Around; // unit vector across z

  SpiralPoint(int n, int count) : Height((2.0 * n + 1.0) / count - 1.0)
  {
    const double goldenAngle = M_PI * (3.0 - std::sqrt(5.0));
    this->Around = {std::cos(n * goldenAngle), std::sin(n * goldenAngle), 0.0};
  }
  Vector3 OnUnitSphere() const
  {
    return std::sqrt(1.0 - this->Height * this->Height) * this->Around +
           this->Height * Vector3::UnitZ();
  }
};

std::vector<Vector3> SphereDirections(int count)
{
  constexpr int Faces = 6;
  if (count == Faces || count == ToolShape::NeighbourCount)
  {
    return NeighbourDirections(count == Faces);
  }
  std::vector<Vector3> directions;
  directions.reserve(static_cast<std::size_t>(count));
  for (int n = 0; n < count; ++n)
  {
    directions.push_back(SpiralPoint(n, count).OnUnitSphere());
  }
  return directions;
}

// Counts that Check rejects get no points: they may be very large.
bool IsCount(int count)
{
  return count >= ToolShape::MinimumCount && count <= ToolShape::MaximumCount;
}

// mm, between neighbours, in the median; 0 without.
double SpacingOf(const std::vector<Vector3>& points)
{
  std::vector<double> nearest(points.size(), std::numeric_limits<double>::max());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const double square = (points[i] - points[j]).squaredNorm();
      nearest[i] = std::min(nearest[i], square);
      nearest[j] = std::min(nearest[j], square);
    }
  }
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  if (points.size() < 2)
  {
    return 0.0;
  }
  std::nth_element(nearest.begin(), middle, nearest.end());
  return std::sqrt(*middle);
}
} // namespace

ToolShape ToolShape::Sphere(double radius)
{
  ToolShape tool;
  tool.Spherical = true;
  tool.SphereRadius = radius;
  tool.Extent = radius;
  tool.Make = [radius](int, double smaller) { return Sphere(std::max(radius - smaller, 0.0)); };
  return tool;
}

ToolShape ToolShape::SpherePoints(double radius, int count)
{
  ToolShape tool = Sphere(radius);
  tool.HasShell = true;
  for (const Vector3& outward : SphereDirections(IsCount(count) ? count : 0))
  {
    tool.AddPoint(radius * outward, -outward, radius);
  }
  tool.Make = [radius](int points, double smaller)
  { return SpherePoints(std::max(radius - smaller, 0.0), points); };
  return tool;
}

ToolShape ToolShape::Capsule(double radius, double length, int count)
{
  ToolShape tool;
  tool.HasShell = true;
  tool.Extent = ExtentOf({radius, length}, radius + 0.5 * length);
  tool.Area = 2.0 * M_PI * radius * (2.0 * radius + length);
  tool.AddCapsulePoints(radius, -0.5 * length, 0.5 * length, count, true);
  if (std::isfinite(tool.Extent) && radius > 0.0)
  {
    tool.UseSkeleton(
        ToolSkeleton::Capsule(radius, length, ToolSkeleton::CountAlong(radius, length)));
  }
  tool.Make = [=](int points, double smaller)
  { return Capsule(std::max(radius - smaller, 0.0), length, points); };
  return tool;
}

ToolShape ToolShape::Drill(double radius, double shaftRadius, double length, int count)
{
  ToolShape tool;
  tool.HasShell = true;
  tool.Extent = ExtentOf({radius, shaftRadius, length}, std::max(radius, length + shaftRadius));
  const double ball = 4.0 * M_PI * radius * radius;
  const double shaft = 2.0 * M_PI * shaftRadius * (2.0 * shaftRadius + length);
  tool.Area = ball + shaft;
  const int onBall = tool.Area > 0.0 ? static_cast<int>(count * ball / tool.Area) : 0;
  tool.AddCapsulePoints(radius, 0.0, 0.0, std::max(onBall, MinimumCount), true);
  tool.AddCapsulePoints(shaftRadius, 0.0, length, std::max(count - onBall, MinimumCount), false);
  if (std::isfinite(tool.Extent) && std::min(radius, shaftRadius) > 0.0)
  {
    tool.UseSkeleton(ToolSkeleton::Drill(radius, shaftRadius, length,
                                         ToolSkeleton::CountAlong(shaftRadius, length)));
  }
  tool.Make = [=](int points, double smaller)
  { return Drill(std::max(radius - smaller, 0.0), shaftRadius, length, points); };
  return tool;
}

// Each point represents the same area: of the lower end, the side and the upper end in turn. The
// sides' first and last points lie on the rims.
ToolShape ToolShape::Cylinder(double radius, double length, int count)
{
  constexpr double Round = 0.1;
  ToolShape tool;
  tool.HasShell = true;
  tool.Extent = ExtentOf({radius, length}, std::hypot(radius, 0.5 * length));
  tool.Area = 2.0 * M_PI * radius * (radius + length);
  const double rim = Round * std::min(radius, 0.5 * length);
  const double end =
      radius > 0.0 ? 0.5 * radius / (radius + length) : 0.0; // fraction of the whole area
  for (int n = 0; IsCount(count) && n < count; ++n)
  {
    const SpiralPoint place(n, count);
    const double part = 0.5 * (place.Height + 1.0);
    const double beyond = std::max(end - part, part - (1.0 - end)); // area fraction beyond a rim
    const double up = part < 0.5 ? -1.0 : 1.0;
    if (beyond > 0.0)
    {
      const double across = (radius - rim) * std::sqrt(1.0 - beyond / end);
      tool.AddPoint(across * place.Around + up * 0.5 * length * Vector3::UnitZ(),
                    -up * Vector3::UnitZ(), rim);
      continue;
    }
    const double step = (1.0 - 2.0 * end) * count > 1.0 ? 1.0 / ((1.0 - 2.0 * end) * count) : 0.0;
    const double along = std::clamp((part - 0.5) / (1.0 - 2.0 * end) * (1.0 + step), -0.5, 0.5);
    tool.AddPoint(radius * place.Around + along * (length - 2.0 * rim) * Vector3::UnitZ(),
                  -place.Around, rim);
  }
  if (std::isfinite(tool.Extent) && rim > 0.0)
  {
    tool.UseSkeleton(ToolSkeleton::Cylinder(radius, length, rim));
  }
  tool.Make = [=](int points, double smaller)
  {
    return Cylinder(std::max(radius - smaller, 0.0), std::max(length - 2.0 * smaller, 0.0), points);
  };
  return tool;
}

ToolShape ToolShape::Ellipsoid(const Vector3& semiAxes, int count)
{
  ToolShape tool;
  tool.HasShell = true;
  tool.Extent = ExtentOf({semiAxes[0], semiAxes[1], semiAxes[2]}, semiAxes.maxCoeff());
  // Knud Thomsen's formula, right to one percent.
  constexpr double P = 1.6075;
  const Vector3 powers = semiAxes.array().pow(P);
  tool.Area =
      4.0 * M_PI *
      std::pow((powers[0] * powers[1] + powers[1] * powers[2] + powers[2] * powers[0]) / 3.0,
               1.0 / P);
  for (int n = 0; IsCount(count) && n < count; ++n)
  {
    const Vector3 outward = SpiralPoint(n, count).OnUnitSphere();
    const Vector3 normal = outward.cwiseQuotient(semiAxes);
    const double shortest = semiAxes.minCoeff();
    tool.AddPoint(semiAxes.cwiseProduct(outward), -normal, shortest * shortest * normal.norm());
  }
  if (std::isfinite(tool.Extent) && semiAxes.minCoeff() > 0.0)
  {
    tool.UseSkeleton(ToolSkeleton::Ellipsoid(semiAxes));
  }
  tool.Make = [semiAxes](int points, double smaller)
  { return Ellipsoid((semiAxes.array() - smaller).max(0.0), points); };
  return tool;
}

ToolShape ToolShape::FromSurfacePoints(std::vector<Vector3> points, std::vector<Vector3> normals)
{
  constexpr double Round = 0.25;
  ToolShape tool;
  tool.HasShell = true;
  tool.ShellPoints = std::move(points);
  tool.ShellNormals = std::move(normals);
  const double radius = Round * SpacingOf(tool.ShellPoints);
  tool.Roundings.assign(tool.ShellPoints.size(), {radius, true});
  for (Vector3& normal : tool.ShellNormals)
  {
    normal.normalize();
  }
  for (const Vector3& point : tool.ShellPoints)
  {
    tool.Extent = std::max(tool.Extent, point.norm());
  }
  if (radius > 0.0 && tool.Check().IsOk())
  {
    std::vector<ToolSkeleton::Ball> balls;
    for (std::size_t n = 0; n < tool.ShellPoints.size(); ++n)
    {
      balls.push_back(tool.BallAt(n));
    }
    tool.UseSkeleton(ToolSkeleton(std::move(balls)));
  }
  tool.Make = [shell = tool.ShellPoints, inward = tool.ShellNormals](int, double smaller)
  {
    std::vector<Vector3> moved = shell;
    for (std::size_t n = 0; n < moved.size(); ++n)
    {
      moved[n] += smaller * inward[n];
    }
    return FromSurfacePoints(std::move(moved), inward);
  };
  return tool;
}

ToolShape ToolShape::WithSpacing(double spacing) const
{
  constexpr double Fewest = 100.0;
  constexpr double Most = 600.0;
  return this->Area > 0.0
             ? this->Variant(
                   static_cast<int>(std::clamp(this->Area / (spacing * spacing), Fewest, Most)),
                   0.0)
             : *this;
}

void ToolShape::AddPoint(const Vector3& point, const Vector3& inward, double radius, bool cuts)
{
  this->ShellPoints.push_back(point);
  this->ShellNormals.push_back(inward.normalized());
  this->Roundings.push_back({radius, cuts});
}

// Of a capsule along z from one centre to the other, but what lies in a ball that is there already.
void ToolShape::AddCapsulePoints(double radius, double from, double to, int count, bool cuts)
{
  const double middle = 0.5 * (from + to);
  const double half = 0.5 * (to - from);
  for (int n = 0; IsCount(count) && n < count; ++n)
  {
    const SpiralPoint place(n, count);
    const double z = place.Height * (radius + half);
    const double axis = std::min(half, std::max(-half, z));
    const double height = z - axis;
    const double across = std::sqrt(std::max(0.0, radius * radius - height * height));
    const Vector3 offset = across * place.Around + height * Vector3::UnitZ();
    const Vector3 point = offset + (middle + axis) * Vector3::UnitZ();
    if (cuts || point.norm() > this->ShellPoints.front().norm())
    {
      this->AddPoint(point, -offset, radius, cuts);
    }
  }
}

void ToolShape::UseSkeleton(ToolSkeleton skeleton)
{
  this->Balls = std::make_shared<const ToolSkeleton>(std::move(skeleton));
}

Status ToolShape::Check() const
{
  if (!IsLength(this->SphereRadius) || !IsLength(this->Extent))
  {
    return Status::Failure("A tool's lengths must be at least 0 and finite.");
  }
  if (this->HasShell && !IsCount(static_cast<int>(this->ShellPoints.size())))
  {
    return Status::Failure("A tool's shell must have from " + std::to_string(MinimumCount) +
                           " to " + std::to_string(MaximumCount) + " points.");
  }
  if (this->ShellNormals.size() != this->ShellPoints.size())
  {
    return Status::Failure("A tool's shell must have one normal for each point.");
  }
  for (std::size_t i = 0; i < this->ShellPoints.size(); ++i)
  {
    // A zero vector cannot be normalised; NaN fails too.
    const bool isDirected = std::abs(this->ShellNormals[i].norm() - 1.0) < 1e-6;
    if (!this->ShellPoints[i].allFinite() || !isDirected)
    {
      return Status::Failure("A tool's shell must have finite points and nonzero normals.");
    }
  }
  return Status::Success();
}
} // namespace palpate
