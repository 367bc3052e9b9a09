#pragma once

#include "IndexedMesh.h"
#include "KuhnComponents.h"
#include "KuhnNeighborhood.h"
#include "ShapeField.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

// Fields and masks of known topology, and what a mesh or a field has.
namespace palpate::phantoms
{
/// Distance-like fields around the origin, mm, positive inside.
inline double Sphere(const Vector3& p, double radius)
{
  return radius - p.norm();
}

/// A ring around the z axis whose tube is thinner by `dent` around the positive x axis.
inline double Ring(const Vector3& p, double radius, double tube, double dent = 0.0)
{
  const double around = std::hypot(p[0], p[1]);
  const double part = around > 0.0 ? 0.5 + 0.5 * p[0] / around : 0.0;
  return tube - dent * std::pow(part, 16.0) - std::hypot(around - radius, p[2]);
}

/// Samples value(point) on a grid around the origin with `spacing`, up to `reach` (mm) and shifted
/// by a third of a step so that nothing falls on nodes.
template <typename Function>
ShapeField Sampled(double reach, double spacing, const Function& value)
{
  ShapeField field;
  const int half = static_cast<int>(std::ceil(reach / spacing)) + 1;
  field.Grid.Size.fill(2 * half + 1);
  field.Grid.Spacing = spacing;
  field.Grid.Origin = Vector3::Constant(-spacing * (half + 1.0 / 3.0));
  field.Values.resize(field.Grid.NodeCount());
  for (std::size_t node = 0; node < field.Values.size(); ++node)
  {
    const std::array<int, 3> at = field.Grid.Index(node);
    const auto [low, high] = std::minmax_element(at.begin(), at.end());
    const bool isBorder = *low == 0 || *high == 2 * half;
    const auto sample = static_cast<float>(value(field.Grid.Point(at)));
    field.Values[node] = isBorder ? std::min(sample, -0.01f) : sample;
  }
  return field;
}

/// A mask of the voxels whose index fulfils a condition.
template <typename Condition>
VoxelMask MaskOf(const std::array<int, 3>& size, const std::array<double, 3>& spacing,
                 const Condition& isInside)
{
  VoxelMask mask;
  mask.Size = size;
  mask.Spacing = spacing;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        mask.Inside.push_back(isInside(i, j, k) ? 1 : 0);
      }
    }
  }
  return mask;
}

inline std::vector<unsigned char> InsideOf(const ShapeField& field)
{
  std::vector<unsigned char> inside(field.Values.size());
  std::transform(field.Values.begin(), field.Values.end(), inside.begin(),
                 [](float value) -> unsigned char { return value > 0.0f ? 1 : 0; });
  return inside;
}

/// Parts, cavities and handles of the nodes inside.
struct Topology
{
  int Parts = 0;
  int Cavities = -1; // the outside is none
  long long Handles = 0;

  bool operator==(const Topology& other) const
  {
    return this->Parts == other.Parts && this->Cavities == other.Cavities &&
           this->Handles == other.Handles;
  }
};

inline Topology TopologyOf(const ShapeField& field)
{
  const std::vector<unsigned char> inside = InsideOf(field);
  const KuhnComponents components(field.Grid, inside);
  Topology topology;
  for (int part = 0; part < components.Count(); ++part)
  {
    (components.IsInside(part) ? topology.Parts : topology.Cavities) += 1;
  }
  topology.Handles = topology.Parts + topology.Cavities - EulerCharacteristic(field.Grid, inside);
  return topology;
}

inline bool IsBall(const ShapeField& field)
{
  return TopologyOf(field) == Topology{1, 0, 0};
}

inline double VolumeOf(const IndexedMesh& mesh)
{
  double sum = 0.0;
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    const auto point = [&](std::size_t n) -> const Vector3&
    { return mesh.Points[static_cast<std::size_t>(t[n])]; };
    sum += point(0).dot(point(1).cross(point(2))) / 6.0;
  }
  return sum;
}

inline long long EulerOf(const IndexedMesh& mesh)
{
  return static_cast<long long>(mesh.Points.size()) -
         static_cast<long long>(mesh.Triangles.size()) / 2;
}

/// Every edge has one triangle on each side, which run along it in opposite directions, and the
/// triangles around each vertex are one fan.
inline bool IsClosedManifold(const IndexedMesh& mesh)
{
  struct Side // of a triangle at a vertex: the neighbours before and after it
  {
    int Vertex, From, To;
  };
  const auto isBefore = [](const Side& a, const Side& b)
  { return std::tie(a.Vertex, a.From) < std::tie(b.Vertex, b.From); };
  std::vector<Side> sides;
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    for (std::size_t n = 0; n < 3; ++n)
    {
      sides.push_back({t[n], t[(n + 1) % 3], t[(n + 2) % 3]});
    }
  }
  std::sort(sides.begin(), sides.end(), isBefore);
  int vertices = 0;
  for (std::size_t first = 0; first < sides.size();)
  {
    std::size_t end = first;
    while (end < sides.size() && sides[end].Vertex == sides[first].Vertex)
    {
      ++end;
    }
    std::size_t steps = 0;
    int at = sides[first].From;
    do
    {
      const auto fan = sides.begin() + static_cast<std::ptrdiff_t>(first);
      const auto last = sides.begin() + static_cast<std::ptrdiff_t>(end);
      const auto found = std::lower_bound(fan, last, Side{sides[first].Vertex, at, 0}, isBefore);
      if (found == last || found->From != at || ++steps > end - first)
      {
        return false;
      }
      at = found->To;
    } while (at != sides[first].From);
    if (steps != end - first)
    {
      return false;
    }
    first = end;
    ++vertices;
  }
  return vertices > 0 && static_cast<std::size_t>(vertices) == mesh.Points.size();
}
} // namespace palpate::phantoms
