#include "LocalThickness.h"

#include "MeshRays.h"
#include "NearestOnMesh.h"
#include "SpatialOrder.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace palpate
{
namespace
{
constexpr std::size_t BlockSize = 64;

// The normals of the triangles at each point, weighted by their angles there.
std::vector<Vector3> NormalsAtPoints(const IndexedMesh& mesh, int smoothing)
{
  std::vector<Vector3> normals(mesh.Points.size(), Vector3::Zero());
  for (const std::array<int, 3>& corners : mesh.Triangles)
  {
    const Vector3 normal = AreaVector(mesh, corners).stableNormalized();
    for (std::size_t k = 0; k < 3; ++k)
    {
      normals[corners[k]] += CornerAngle(mesh, corners, k) * normal;
    }
  }
  for (int round = 0;; ++round)
  {
    for (Vector3& normal : normals)
    {
      normal = normal.stableNormalized();
    }
    if (round >= smoothing)
    {
      return normals;
    }
    const std::vector<Vector3> before = normals;
    for (const auto& [a, b, c] : mesh.Triangles)
    {
      normals[a] += 0.5 * (before[b] + before[c]); // each neighbour counts once, in two triangles
      normals[b] += 0.5 * (before[c] + before[a]);
      normals[c] += 0.5 * (before[a] + before[b]);
    }
  }
}

// Points that are near each other, and a box around them.
struct PointBlock
{
  Eigen::AlignedBox3d Box;
  std::vector<int> Points;
};

class BallFit
{
public:
  BallFit(const IndexedMesh& mesh, const ThicknessSettings& settings)
      : Mesh(mesh), Tolerance(settings.Tolerance),
        Normals(NormalsAtPoints(mesh, settings.NormalSmoothing)), Corners(mesh.Points.size())
  {
    for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      for (const int corner : mesh.Triangles[t])
      {
        this->Corners[corner].push_back(static_cast<int>(t));
      }
    }
    for (const int point : SpatialOrder(mesh.Points))
    {
      if (this->Corners[point].empty())
      {
        continue;
      }
      if (this->Blocks.empty() || this->Blocks.back().Points.size() == BlockSize)
      {
        this->Blocks.emplace_back();
      }
      this->Blocks.back().Points.push_back(point);
      this->Blocks.back().Box.extend(mesh.Points[point]);
      this->Bounds.extend(mesh.Points[point]);
    }
  }

  std::vector<double> Diameters()
  {
    std::vector<double> diameters(this->Mesh.Points.size(),
                                  std::numeric_limits<double>::quiet_NaN());
    for (const PointBlock& block : this->Blocks)
    {
      for (const int point : block.Points)
      {
        // With no tolerance, it would be this much less between walls and of a ball.
        diameters[point] = std::max(0.0, 2.0 * this->RadiusAt(point) - this->Tolerance);
      }
    }
    return diameters;
  }

private:
  // Of a ball through `point` that a point of the surface limits.
  double RadiusBy(const Vector3& point, const Vector3& inward, const Vector3& there) const
  {
    const Vector3 way = there - point;
    const double depth = way.dot(inward) - this->Tolerance;
    return depth > 0.0 ? (way.squaredNorm() - this->Tolerance * this->Tolerance) / (2.0 * depth)
                       : std::numeric_limits<double>::infinity();
  }

  double RadiusAt(int point)
  {
    const Vector3& at = this->Mesh.Points[point];
    const Vector3 inward = -this->Normals[point];
    double radius = 0.5 * (this->Bounds.sizes().minCoeff() + this->Tolerance);
    int limit = -1;
    const auto shrinkBy = [&](const PointBlock& block)
    {
      for (const int there : block.Points)
      {
        const double by = this->RadiusBy(at, inward, this->Mesh.Points[there]);
        limit = by < radius ? there : limit;
        radius = std::min(radius, by);
      }
    };
    shrinkBy(this->Blocks[this->Last]); // what limited the ball before
    for (std::size_t b = 0; b < this->Blocks.size(); ++b)
    {
      const double free = std::max(0.0, radius - this->Tolerance);
      if (this->Blocks[b].Box.squaredExteriorDistance(at + radius * inward) < free * free)
      {
        const double before = radius;
        shrinkBy(this->Blocks[b]);
        this->Last = radius < before ? b : this->Last;
      }
    }
    return limit < 0 ? radius : this->Refined(at, inward, limit, radius);
  }

  // The ball touches a triangle between points; unless it is limited by the curvature around `at`,
  // which triangles do not have.
  double Refined(const Vector3& at, const Vector3& inward, int limit, double radius) const
  {
    double refined = radius;
    if ((this->Mesh.Points[limit] - at).norm() < radius)
    {
      return radius;
    }
    for (const int triangle : this->Corners[limit])
    {
      const auto [a, b, c] = this->Mesh.Triangles[triangle];
      const Vector3 foot = NearestOnTriangle(at + radius * inward, this->Mesh.Points[a],
                                             this->Mesh.Points[b], this->Mesh.Points[c]);
      refined = std::min(refined, this->RadiusBy(at, inward, foot));
    }
    return refined;
  }

  const IndexedMesh& Mesh;
  double Tolerance;
  std::vector<Vector3> Normals;
  std::vector<std::vector<int>> Corners; // the triangles at each point
  std::vector<PointBlock> Blocks;
  Eigen::AlignedBox3d Bounds;
  std::size_t Last = 0;
};
// Along the inward normals. NaN if the mesh is none that rays can be sent through.
std::vector<double> RayLengths(const IndexedMesh& mesh, const ThicknessSettings& settings)
{
  std::vector<double> lengths(mesh.Points.size(), std::numeric_limits<double>::quiet_NaN());
  const std::vector<Vector3> normals = NormalsAtPoints(mesh, settings.NormalSmoothing);
  MeshRays rays;
  if (MeshRays::Make(mesh, rays).IsOk())
  {
    for (std::size_t i = 0; i < lengths.size(); ++i)
    {
      const bool hasNormal = normals[i].squaredNorm() > 0.5;
      lengths[i] =
          hasNormal ? rays.ExitFrom(mesh.Points[i], -normals[i], static_cast<int>(i)) : lengths[i];
    }
  }
  return lengths;
}
} // namespace

ThicknessSettings ThicknessSettings::OfVoxels(const Matrix3& steps)
{
  const Vector3 sizes = steps.colwise().norm();
  return {ThicknessRule::Spheres, 0.2 * std::cbrt(sizes.prod()), 4};
}

std::vector<double> LocalThicknessOf(const IndexedMesh& mesh, const ThicknessSettings& settings)
{
  if (mesh.Triangles.empty())
  {
    return std::vector<double>(mesh.Points.size(), std::numeric_limits<double>::quiet_NaN());
  }
  return settings.Rule == ThicknessRule::Rays ? RayLengths(mesh, settings)
                                              : BallFit(mesh, settings).Diameters();
}
} // namespace palpate
