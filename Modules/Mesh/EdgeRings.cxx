#include "EdgeRings.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace palpate
{
namespace
{
// Prepends the half-edges to the lists of their smaller points. rings holds the lists' links.
std::vector<int> ListByPoint(const IndexedMesh& mesh, std::vector<int>& rings)
{
  std::vector<int> first(mesh.Points.size(), -1);
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const std::array<int, 3>& triangle = mesh.Triangles[t];
    if (!HasThreePoints(triangle, mesh.Points.size()))
    {
      continue;
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      int& head = first[std::min(triangle[k], triangle[(k + 1) % 3])];
      rings[3 * t + k] = head;
      head = static_cast<int>(3 * t + k);
    }
  }
  return first;
}

// Sorted, equal larger points are adjacent, and their half-edges in ascending order.
struct Entry
{
  int Larger;
  int HalfEdge;
  bool operator<(const Entry& other) const noexcept
  {
    return this->Larger != other.Larger ? this->Larger < other.Larger
                                        : this->HalfEdge < other.HalfEdge;
  }
};

// Links the entries of equal points to rings; returns the number of rings.
int CloseRings(const std::vector<Entry>& entries, std::vector<int>& rings)
{
  int count = 0;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    const bool isLast = i + 1 == entries.size() || entries[i + 1].Larger != entries[i].Larger;
    rings[entries[i].HalfEdge] = entries[isLast ? begin : i + 1].HalfEdge;
    if (isLast)
    {
      begin = i + 1;
      ++count;
    }
  }
  return count;
}
} // namespace

EdgeRings::EdgeRings(const IndexedMesh& mesh) : Rings(3 * mesh.Triangles.size(), -1)
{
  const std::vector<int> first = ListByPoint(mesh, this->Rings);
  std::vector<Entry> entries;
  for (const int head : first)
  {
    entries.clear();
    for (int h = head; h >= 0; h = this->Rings[h])
    {
      entries.push_back({std::max(StartOf(mesh, h), StartOf(mesh, NextInTriangle(h))), h});
    }
    std::sort(entries.begin(), entries.end());
    this->Edges += CloseRings(entries, this->Rings);
  }
}
} // namespace palpate
