#include "ToolShape.h"

#include "ToolSkeleton.h"

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
// Half a radius apart: between them a capsule is at most a sixteenth of a radius thinner than it
// should be, at a sharp edge.
int BallCount(double radius, double length)
{
  constexpr double Most = 64.0;
  return 1 + static_cast<int>(std::clamp(std::ceil(2.0 * length / radius), 0.0, Most - 1.0));
}
} // namespace

ToolShape ToolShape::Sphere(double radius)
{
  ToolShape tool;
  tool.Spherical = true;
  tool.SphereRadius = radius;
  tool.Extent = radius;
  return tool;
}

ToolShape ToolShape::SpherePoints(double radius, int count)
{
  ToolShape tool = Sphere(radius);
  tool.HasShell = true;
  for (const Vector3& outward : SphereDirections(IsCount(count) ? count : 0))
  {
    tool.AddPoint(radius * outward, -outward);
  }
  return tool;
}

ToolShape ToolShape::Capsule(double radius, double length, int count)
{
  ToolShape tool;
  tool.HasShell = true;
  const double halfHeight = radius + 0.5 * length;
  tool.Extent = ExtentOf({radius, length}, halfHeight);
  for (int n = 0; IsCount(count) && n < count; ++n)
  {
    const SpiralPoint place(n, count);
    const double z = place.Height * halfHeight;
    const double axis = std::min(0.5 * length, std::max(-0.5 * length, z));
    const double height = z - axis;
    const double across = std::sqrt(std::max(0.0, radius * radius - height * height));
    const Vector3 offset = across * place.Around + height * Vector3::UnitZ();
    tool.AddPoint(offset + axis * Vector3::UnitZ(), -offset);
  }
  if (std::isfinite(tool.Extent) && radius > 0.0)
  {
    tool.Balls = std::make_shared<const ToolSkeleton>(
        ToolSkeleton::Capsule(radius, length, BallCount(radius, length)));
  }
  return tool;
}

// Each point represents the same area: of the lower end, the side and the upper end in turn. The
// sides' first and last points lie on the rims.
ToolShape ToolShape::Cylinder(double radius, double length, int count)
{
  ToolShape tool;
  tool.HasShell = true;
  tool.Extent = ExtentOf({radius, length}, std::hypot(radius, 0.5 * length));
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
      const double across = radius * std::sqrt(1.0 - beyond / end);
      tool.AddPoint(across * place.Around + up * 0.5 * length * Vector3::UnitZ(),
                    -up * Vector3::UnitZ());
      continue;
    }
    const double step = (1.0 - 2.0 * end) * count > 1.0 ? 1.0 / ((1.0 - 2.0 * end) * count) : 0.0;
    const double along = std::clamp((part - 0.5) / (1.0 - 2.0 * end) * (1.0 + step), -0.5, 0.5);
    tool.AddPoint(radius * place.Around + along * length * Vector3::UnitZ(), -place.Around);
  }
  return tool;
}

ToolShape ToolShape::Ellipsoid(const Vector3& semiAxes, int count)
{
  ToolShape tool;
  tool.HasShell = true;
  tool.Extent = ExtentOf({semiAxes[0], semiAxes[1], semiAxes[2]}, semiAxes.maxCoeff());
  for (int n = 0; IsCount(count) && n < count; ++n)
  {
    const Vector3 outward = SpiralPoint(n, count).OnUnitSphere();
    tool.AddPoint(semiAxes.cwiseProduct(outward), -outward.cwiseQuotient(semiAxes));
  }
  return tool;
}

ToolShape ToolShape::FromSurfacePoints(std::vector<Vector3> points, std::vector<Vector3> normals)
{
  ToolShape tool;
  tool.HasShell = true;
  tool.ShellPoints = std::move(points);
  tool.ShellNormals = std::move(normals);
  for (Vector3& normal : tool.ShellNormals)
  {
    normal.normalize();
  }
  for (const Vector3& point : tool.ShellPoints)
  {
    tool.Extent = std::max(tool.Extent, point.norm());
  }
  return tool;
}

void ToolShape::AddPoint(const Vector3& point, const Vector3& inward)
{
  this->ShellPoints.push_back(point);
  this->ShellNormals.push_back(inward.normalized());
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
