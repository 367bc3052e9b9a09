#pragma once

#include "Vector3.h"

#include <array>
#include <cmath>
#include <vector>

namespace palpate::test
{
/// Fields with known exact value and gradient; positive inside. Points are in any one frame;
/// kernels sample them in the frame of their choice.
struct PlaneField
{
  Vector3 Normal{0.36, 0.48, -0.8}; ///< points inwards
  double Offset = 0.0;

  double Value(const Vector3& p) const { return this->Normal.dot(p) - this->Offset; }
  Vector3 Gradient(const Vector3&) const { return this->Normal; }
};

/// Signed distance to a sphere; the gradient has length 1 except at the centre.
struct SphereField
{
  Vector3 Center = Vector3::Zero();
  double Radius = 1.0;

  double Value(const Vector3& p) const { return this->Radius - (p - this->Center).norm(); }
  Vector3 Gradient(const Vector3& p) const { return -(p - this->Center).normalized(); }
};

/// Radius^2 - |p - center|^2: the same surface as SphereField's, and a polynomial of degree two.
struct QuadraticSphereField
{
  Vector3 Center = Vector3::Zero();
  double Radius = 1.0;

  double Value(const Vector3& p) const
  {
    return this->Radius * this->Radius - (p - this->Center).squaredNorm();
  }
  Vector3 Gradient(const Vector3& p) const { return -2.0 * (p - this->Center); }
};

/// Signed distance to a torus around the axis k.
struct TorusField
{
  Vector3 Center = Vector3::Zero();
  double Radius = 2.0; ///< of the central circle
  double Tube = 0.5;

  double Value(const Vector3& p) const
  {
    const Vector3 d = p - this->Center;
    return this->Tube - std::hypot(std::hypot(d[0], d[1]) - this->Radius, d[2]);
  }
  Vector3 Gradient(const Vector3& p) const
  {
    const Vector3 d = p - this->Center;
    const double ring = std::hypot(d[0], d[1]);
    const double distance = std::hypot(ring - this->Radius, d[2]);
    const double along = (ring - this->Radius) / (distance * ring);
    return -Vector3(d[0] * along, d[1] * along, d[2] / distance);
  }
};

/// Schoen's gyroid with a period of `Period`: a surface with every orientation.
struct GyroidField
{
  double Period = 12.0;

  double Value(const Vector3& p) const
  {
    const Vector3 q = p * (2.0 * M_PI / this->Period);
    return std::sin(q[0]) * std::cos(q[1]) + std::sin(q[1]) * std::cos(q[2]) +
           std::sin(q[2]) * std::cos(q[0]);
  }
  Vector3 Gradient(const Vector3& p) const
  {
    const double scale = 2.0 * M_PI / this->Period;
    const Vector3 q = p * scale;
    const Vector3 s = q.array().sin();
    const Vector3 c = q.array().cos();
    return scale *
           Vector3(c[0] * c[1] - s[2] * s[0], c[1] * c[2] - s[0] * s[1], c[2] * c[0] - s[1] * s[2]);
  }
};

/// (x - a)(y - b)(z - c): trilinear, with a saddle at (a, b, c) where three planes of zeros meet.
struct SaddleField
{
  Vector3 Center = Vector3::Zero();

  double Value(const Vector3& p) const { return (p - this->Center).prod(); }
  Vector3 Gradient(const Vector3& p) const
  {
    const Vector3 d = p - this->Center;
    return {d[1] * d[2], d[0] * d[2], d[0] * d[1]};
  }
};

/// The field's values at the nodes of a grid, i fastest, sampled at their indices.
template <typename T = double, typename Procedure>
std::vector<T> SampleAtIndices(const std::array<int, 3>& size, const Procedure& field)
{
  std::vector<T> samples;
  samples.reserve(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) *
                  static_cast<std::size_t>(size[2]));
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        samples.push_back(static_cast<T>(field.Value(Vector3(i, j, k))));
      }
    }
  }
  return samples;
}
} // namespace palpate::test
