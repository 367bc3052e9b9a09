#include "ReferenceNormals.h"

#include <utility>

namespace palpate
{
namespace
{
Eigen::Vector3f UnitOrZero(const Vector3& direction)
{
  const double length = direction.stableNorm();
  const bool isUsable = length > 0.0 && length <= std::numeric_limits<double>::max();
  return isUsable ? Eigen::Vector3f((direction / length).cast<float>()) : Eigen::Vector3f::Zero();
}
} // namespace

ReferenceNormals::ReferenceNormals(const HalfEdgeMesh& mesh, ReferenceNormal function)
    : Function(std::move(function)), Normals(mesh.PointCount(), Eigen::Vector3f::Zero())
{
  for (int h = 0; h < mesh.HalfEdgeLimit(); h += 4)
  {
    const Vector3& a = mesh.Point(mesh.Start(h));
    const Eigen::Vector3f area =
        (mesh.Point(mesh.Start(h + 1)) - a).cross(mesh.Point(mesh.Start(h + 2)) - a).cast<float>();
    for (int k = 0; k < 3; ++k)
    {
      this->Normals[mesh.Start(h + k)] += area;
    }
  }
  if (this->Function)
  {
    for (int p = 0; p < mesh.PointCount(); ++p)
    {
      this->Normals[p] = this->FromFunction(mesh.Point(p), this->Normals[p]);
    }
  }
}

Eigen::Vector3f ReferenceNormals::Merged(int kept, int removed, const Vector3& position) const
{
  const Eigen::Vector3f sum = this->Normals[kept] + this->Normals[removed];
  return this->Function ? this->FromFunction(position, sum) : sum;
}

Eigen::Vector3f ReferenceNormals::FromFunction(const Vector3& point,
                                               const Eigen::Vector3f& otherwise) const
{
  const Eigen::Vector3f normal = UnitOrZero(this->Function(point));
  return normal.isZero() ? Eigen::Vector3f(otherwise.stableNormalized()) : normal;
}
} // namespace palpate
