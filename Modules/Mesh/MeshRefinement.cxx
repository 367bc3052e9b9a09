#include "MeshRefinement.h"

#include "EdgeRings.h"

#include <utility>

namespace palpate
{
namespace
{
// The midpoint of each half-edge that is too long, as a new point's number; else -1.
std::vector<int> FindMidpoints(const IndexedMesh& mesh, double longest,
                               std::vector<Vector3>& midpoints)
{
  const EdgeRings rings(mesh);
  const int count = 3 * static_cast<int>(mesh.Triangles.size());
  std::vector<int> numbers(static_cast<std::size_t>(count), -1);
  for (int h = 0; h < count; ++h)
  {
    if (numbers[static_cast<std::size_t>(h)] >= 0 || rings.IsLeftOut(h / 3))
    {
      continue;
    }
    const Vector3& a = mesh.Points[static_cast<std::size_t>(StartOf(mesh, h))];
    const Vector3& b = mesh.Points[static_cast<std::size_t>(StartOf(mesh, NextInTriangle(h)))];
    if (!((b - a).squaredNorm() > longest * longest))
    {
      continue;
    }
    const int number = static_cast<int>(mesh.Points.size() + midpoints.size());
    midpoints.emplace_back(0.5 * (a + b));
    int other = h;
    do
    {
      numbers[static_cast<std::size_t>(other)] = number;
      other = rings.Next(other);
    } while (other != h);
  }
  return numbers;
}

// The triangle a, b, c with the midpoints of its edges ab, bc, ca, or -1.
void SplitTriangle(std::array<int, 3> corners, std::array<int, 3> middles,
                   std::vector<std::array<int, 3>>& triangles)
{
  const auto turn = [&]
  {
    corners = {corners[1], corners[2], corners[0]};
    middles = {middles[1], middles[2], middles[0]};
  };
  const int split = (middles[0] >= 0 ? 1 : 0) + (middles[1] >= 0 ? 1 : 0) + (middles[2] >= 0);
  while ((split == 1 && middles[0] < 0) || (split == 2 && middles[2] >= 0))
  {
    turn();
  }
  const auto [a, b, c] = corners;
  const auto [ab, bc, ca] = middles;
  switch (split)
  {
  case 0:
    triangles.push_back(corners);
    break;
  case 1:
    triangles.insert(triangles.end(), {{{a, ab, c}}, {{ab, b, c}}});
    break;
  case 2:
    triangles.insert(triangles.end(), {{{ab, b, bc}}, {{a, ab, bc}}, {{a, bc, c}}});
    break;
  default:
    triangles.insert(triangles.end(),
                     {{{a, ab, ca}}, {{ab, b, bc}}, {{ca, bc, c}}, {{ab, bc, ca}}});
  }
}
} // namespace

bool SplitLongEdges(IndexedMesh& mesh, double longest, int mostTriangles)
{
  for (;;)
  {
    std::vector<Vector3> midpoints;
    const std::vector<int> numbers = FindMidpoints(mesh, longest, midpoints);
    if (midpoints.empty())
    {
      return true;
    }
    // Each split edge gives one more triangle on each of its sides.
    std::size_t count = mesh.Triangles.size();
    for (const int number : numbers)
    {
      count += number >= 0 ? 1 : 0;
    }
    if (mostTriangles < 0 || count > static_cast<std::size_t>(mostTriangles))
    {
      return false;
    }
    std::vector<std::array<int, 3>> triangles;
    triangles.reserve(count);
    for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
    {
      SplitTriangle(mesh.Triangles[t], {numbers[3 * t], numbers[3 * t + 1], numbers[3 * t + 2]},
                    triangles);
    }
    mesh.Triangles = std::move(triangles);
    mesh.Points.insert(mesh.Points.end(), midpoints.begin(), midpoints.end());
  }
}
} // namespace palpate
