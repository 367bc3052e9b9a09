#pragma once

#include "FieldContactCases.h"
#include "MeshCases.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace palpate::test
{
enum class Representation
{
  RadialNearest,
  RadialByRadius,
  Facets,
  FieldProxy,
  FieldShell
};

enum class ExtremeShape
{
  Sphere,   ///< 9 mm
  ThinWall, ///< a plate or a pancake
  Needle,
  Cleft,   ///< with walls that meet; for spherical harmonics, a deep and narrow hollow
  OneVoxel ///< 0.5 mm wide
};

/// Centre of the structures (mm).
inline const Vector3 ExtremeCenter(7.0, -30.0, 12.0);

struct ExtremeCase
{
  std::shared_ptr<const ContactModel> Model;
  std::vector<Vector3> SurfacePoints; ///< exact up to rounding
};

inline Mesh Moved(Mesh mesh, const Matrix3& rotation, const Vector3& path)
{
  for (Vector3& point : mesh.Points)
  {
    point = rotation * point + path;
  }
  return mesh;
}

inline Mesh Joined(Mesh mesh, const Mesh& other)
{
  const int first = static_cast<int>(mesh.Points.size());
  mesh.Points.insert(mesh.Points.end(), other.Points.begin(), other.Points.end());
  for (const auto& [a, b, c] : other.Triangles)
  {
    mesh.Triangles.push_back({first + a, first + b, first + c});
  }
  return mesh;
}

inline RadialModel ExtremeHarmonics(ExtremeShape shape)
{
  const auto ellipsoid = [](const Vector3& axes)
  {
    return Project(
        24, [axes](const Vector3& u) { return 1.0 / u.cwiseQuotient(axes).norm(); }, ExtremeCenter);
  };
  switch (shape)
  {
  case ExtremeShape::ThinWall:
    return ellipsoid({4.0, 4.0, 0.5});
  case ExtremeShape::Needle:
    return ellipsoid({0.7, 0.7, 4.0});
  case ExtremeShape::Cleft:
    return Project(
        24,
        [](const Vector3& u)
        { return 9.0 - 7.0 * std::exp(-(u - Vector3::UnitZ()).squaredNorm() / 0.05); },
        ExtremeCenter);
  case ExtremeShape::OneVoxel:
    return Sphere(0.25, ExtremeCenter);
  case ExtremeShape::Sphere:
    break;
  }
  return Sphere(9.0, ExtremeCenter);
}

inline Mesh ExtremeMesh(ExtremeShape shape)
{
  const Matrix3 level = Matrix3::Identity();
  switch (shape)
  {
  case ExtremeShape::ThinWall:
    return Moved(BoxMesh({10.0, 10.0, 0.005}), level, ExtremeCenter);
  case ExtremeShape::Needle:
    return Moved(BoxMesh({0.01, 0.01, 10.0}), level, ExtremeCenter);
  case ExtremeShape::Cleft:
  {
    // Two bars on their edges, next to each other.
    const Matrix3 turned = Eigen::AngleAxisd(0.25 * M_PI, Vector3::UnitY()).matrix();
    const Vector3 aside = 3.0 * std::sqrt(2.0) * Vector3::UnitX();
    const Mesh bar = BoxMesh({3.0, 6.0, 3.0});
    return Joined(Moved(bar, turned, ExtremeCenter - aside),
                  Moved(bar, turned, ExtremeCenter + aside));
  }
  case ExtremeShape::OneVoxel:
    return Moved(BoxMesh(Vector3::Constant(0.25)), level, ExtremeCenter);
  case ExtremeShape::Sphere:
    break;
  }
  return MeshOf(ExtremeHarmonics(ExtremeShape::Sphere), 10);
}

/// In voxels of 0.5 mm, from the centre.
struct ExtremeField
{
  ExtremeShape Shape;

  double Value(const Vector3& index) const
  {
    const Vector3 p = index - Vector3::Constant(24.0);
    const double longest = 15.0 - p.lpNorm<Eigen::Infinity>();
    switch (this->Shape)
    {
    case ExtremeShape::ThinWall:
      return std::min(longest, 0.5 - std::abs(p[2]));
    case ExtremeShape::Needle:
      return std::min(longest, 0.5 - std::hypot(p[0], p[1]));
    case ExtremeShape::Cleft:
      return std::min(longest, 6.0 - std::abs(std::abs(p[0]) - 6.0) - std::abs(p[2]));
    case ExtremeShape::OneVoxel:
      return 0.5 - p.norm();
    case ExtremeShape::Sphere:
      break;
    }
    return 18.0 - p.norm();
  }
};

inline std::vector<Vector3> ProbingDirections()
{
  Random random(8201);
  std::vector<Vector3> directions = RandomDirections(random, 20);
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    directions.push_back(Vector3::Unit(axis));
    directions.push_back(-Vector3::Unit(axis));
  }
  return directions;
}

inline ExtremeCase ExtremeFieldCase(ExtremeShape shape, bool isPublished)
{
  constexpr int Nodes = 49;
  const FieldGrid grid({Nodes, Nodes, Nodes}, ExtremeCenter - Vector3::Constant(12.0),
                       Vector3::Constant(0.5), Matrix3::Identity());
  const auto field = SampledField(grid, ExtremeField{shape});
  const RayCaster caster(field);
  ExtremeCase made{isPublished ? PublishedContact(field) : FieldContact(field), {}};
  for (const Vector3& u : ProbingDirections())
  {
    const FieldHit hit = caster.CastWorld({ExtremeCenter + 40.0 * u, -u}, 0.0, 80.0);
    if (hit.Kind == HitKind::Surface)
    {
      made.SurfacePoints.push_back(hit.Position);
    }
  }
  return made;
}

inline ExtremeCase ExtremeHarmonicCase(ExtremeShape shape, RadialContactMode mode)
{
  const RadialModel model = ExtremeHarmonics(shape);
  ExtremeCase made{RadialContact(model, mode), {}};
  for (const Vector3& u : ProbingDirections())
  {
    made.SurfacePoints.push_back(model.PointWorld(u));
  }
  return made;
}

inline ExtremeCase ExtremeFacetCase(ExtremeShape shape)
{
  const Mesh mesh = ExtremeMesh(shape);
  ExtremeCase made{FacetContact(mesh), mesh.Points};
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    const Facet facet = mesh.FacetAt(i);
    made.SurfacePoints.push_back(0.5 * (facet.A + facet.B));
    made.SurfacePoints.push_back((facet.A + facet.B + facet.C) / 3.0);
  }
  return made;
}

inline ExtremeCase MadeExtremeCase(Representation representation, ExtremeShape shape)
{
  switch (representation)
  {
  case Representation::RadialNearest:
    return ExtremeHarmonicCase(shape, RadialContactMode::Nearest);
  case Representation::RadialByRadius:
    return ExtremeHarmonicCase(shape, RadialContactMode::Radial);
  case Representation::Facets:
    return ExtremeFacetCase(shape);
  case Representation::FieldProxy:
    return ExtremeFieldCase(shape, false);
  case Representation::FieldShell:
    break;
  }
  return ExtremeFieldCase(shape, true);
}

/// Without points at the centre itself, which has no outward direction.
inline ExtremeCase MakeExtremeCase(Representation representation, ExtremeShape shape)
{
  ExtremeCase made = MadeExtremeCase(representation, shape);
  auto& points = made.SurfacePoints;
  const auto isInTheMiddle = [](const Vector3& p) { return (p - ExtremeCenter).norm() < 1e-3; };
  points.erase(std::remove_if(points.begin(), points.end(), isInTheMiddle), points.end());
  return made;
}
} // namespace palpate::test
