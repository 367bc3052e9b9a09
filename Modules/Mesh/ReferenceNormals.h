#pragma once

#include "HalfEdgeMesh.h"
#include "Vector3.h"

#include <functional>
#include <vector>

namespace palpate
{
/// The direction in which a surface faces at a point (mm), of any length; where it is not finite or
/// zero, the surface's own is taken. For a level set, the negative gradient of a field that is
/// positive inside.
using ReferenceNormal = std::function<Vector3(const Vector3& point)>;

/// Keeps the triangles of a surface that is being changed from turning over: they are compared with
/// directions at their points, not with the triangles that they replace, whose own normals can be
/// arbitrary where they are slivers.
class ReferenceNormals
{
public:
  /// Without a function, a point has the sum of the area vectors of its triangles, and a point into
  /// which others were merged the sum of theirs.
  ReferenceNormals(const HalfEdgeMesh& mesh, ReferenceNormal function);

  /// The direction for a triangle of these three points: the sum over them.
  Vector3 Sum(int a, int b, int c) const noexcept
  {
    return (this->Normals[a] + this->Normals[b] + this->Normals[c]).cast<double>();
  }
  /// The direction that the point `kept` would have at a position, with `removed` merged into it.
  Eigen::Vector3f Merged(int kept, int removed, const Vector3& position) const;
  void Set(int point, const Eigen::Vector3f& normal) noexcept { this->Normals[point] = normal; }
  const Eigen::Vector3f& At(int point) const noexcept { return this->Normals[point]; }

private:
  Eigen::Vector3f FromFunction(const Vector3& point, const Eigen::Vector3f& otherwise) const;

  ReferenceNormal Function;
  std::vector<Eigen::Vector3f> Normals;
};

/// cos^2 of the angle between a triangle's normal and a reference, with the cosine's sign; -1 if
/// either vanishes.
inline double Alignment(const Vector3& normal, const Vector3& reference) noexcept
{
  const double product = normal.dot(reference);
  const double squares = normal.squaredNorm() * reference.squaredNorm();
  return squares > 0.0 ? product * std::abs(product) / squares : -1.0;
}

/// Alignment from which a triangle counts as facing its reference: 72 degrees.
constexpr double LeastAlignment = 0.1;
} // namespace palpate
