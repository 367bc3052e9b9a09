#include "RingKernel.h"

#include "MeshSimplification.h"

#include <algorithm>
#include <array>

namespace palpate
{
namespace
{
// Each plane adds one corner at most.
constexpr std::size_t LargestKernel = MeshSimplification::LargestRing + 4;

struct Kernel
{
  std::array<Vector3, LargestKernel> Corners;
  std::size_t Count = 0;

  void Add(const Vector3& corner) { this->Corners[this->Count++] = corner; }
};

// The lune between the great circles of the two sides at the first corner. At a reflex corner the
// circles continue behind it.
Kernel LuneAtFirstCorner(const Vector3* polygon, int count)
{
  const Vector3& tip = polygon[0];
  const Vector3& next = polygon[1];
  const Vector3& last = polygon[count - 1];
  const bool reflex = tip.dot(next.cross(last)) < 0.0;
  Kernel lune;
  lune.Add(tip);
  lune.Add(reflex ? Vector3(-last) : next);
  lune.Add(-tip);
  lune.Add(reflex ? Vector3(-next) : last);
  return lune;
}

// Sutherland and Hodgman on the sphere: positive combinations of two corners stay on their arc.
Kernel Clip(const Kernel& kernel, const Vector3& normal)
{
  Kernel clipped;
  for (std::size_t i = 0; i < kernel.Count; ++i)
  {
    const Vector3& a = kernel.Corners[i];
    const Vector3& b = kernel.Corners[(i + 1) % kernel.Count];
    const double insideA = normal.dot(a);
    const double insideB = normal.dot(b);
    if (insideA >= 0.0)
    {
      clipped.Add(a);
    }
    if ((insideA > 0.0 && insideB < 0.0) || (insideA < 0.0 && insideB > 0.0))
    {
      clipped.Add((std::abs(insideB) * a + std::abs(insideA) * b).normalized());
    }
    if (clipped.Count + 2 > LargestKernel)
    {
      break;
    }
  }
  return clipped;
}
} // namespace

Vector3 KernelDirection(const Vector3* polygon, int count)
{
  Kernel kernel = LuneAtFirstCorner(polygon, count);
  for (int i = 1; i + 1 < count; ++i)
  {
    kernel = Clip(kernel, polygon[i].cross(polygon[i + 1]));
  }
  // Not the mean of the corners: rounding may double one.
  Vector3 sum = Vector3::Zero();
  for (std::size_t i = 0; i < kernel.Count; ++i)
  {
    const Vector3& a = kernel.Corners[i];
    const Vector3& b = kernel.Corners[(i + 1) % kernel.Count];
    sum += (b - a).norm() * (a + b);
  }
  const double length = sum.norm();
  return length > 0.0 ? Vector3(sum / length) : Vector3::Zero();
}
} // namespace palpate
