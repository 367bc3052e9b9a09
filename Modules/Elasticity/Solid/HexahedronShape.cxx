#include "HexahedronShape.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
// Corners of [-1, 1]^3 in VTK's order.
constexpr std::array<std::array<double, 3>, 8> Corners{{{-1, -1, -1},
                                                        {1, -1, -1},
                                                        {1, 1, -1},
                                                        {-1, 1, -1},
                                                        {-1, -1, 1},
                                                        {1, -1, 1},
                                                        {1, 1, 1},
                                                        {-1, 1, 1}}};

struct Reference
{
  std::array<double, 8> Shape;
  std::array<Vector3, 8> Slopes; // with respect to the coordinates in [-1, 1]^3
};

Reference ReferenceAt(const Vector3& at) noexcept
{
  Reference reference{};
  for (std::size_t i = 0; i < 8; ++i)
  {
    const std::array<double, 3>& c = Corners[i];
    const double x = 1.0 + c[0] * at[0];
    const double y = 1.0 + c[1] * at[1];
    const double z = 1.0 + c[2] * at[2];
    reference.Shape[i] = 0.125 * x * y * z;
    reference.Slopes[i] = 0.125 * Vector3(c[0] * y * z, c[1] * x * z, c[2] * x * y);
  }
  return reference;
}
} // namespace

HexahedronShape::HexahedronShape(const std::vector<Vector3>& nodes,
                                 const StarMesh::Element& element) noexcept
{
  const double gauss = 1.0 / std::sqrt(3.0);
  for (std::size_t g = 0; g < 8; ++g)
  {
    const Reference reference =
        ReferenceAt(gauss * Vector3(Corners[g][0], Corners[g][1], Corners[g][2]));
    Point& point = this->GaussPoints[g];
    point.Position = Vector3::Zero();
    point.Shape = reference.Shape;
    Matrix3 jacobian = Matrix3::Zero();
    for (std::size_t i = 0; i < 8; ++i)
    {
      const Vector3& node = nodes[static_cast<std::size_t>(element[i])];
      point.Position += reference.Shape[i] * node;
      jacobian += node * reference.Slopes[i].transpose();
    }
    point.Volume = jacobian.determinant();
    const Matrix3 toGradients = jacobian.inverse().transpose();
    for (std::size_t i = 0; i < 8; ++i)
    {
      point.Gradients[i] = toGradients * reference.Slopes[i];
    }
  }
}

bool HexahedronShape::IsValid() const noexcept
{
  return std::all_of(this->GaussPoints.begin(), this->GaussPoints.end(),
                     [](const Point& point)
                     { return point.Volume > 0.0 && std::isfinite(point.Volume); });
}
} // namespace palpate
