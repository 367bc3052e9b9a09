#pragma once

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"

#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace palpate::test
{
inline std::vector<std::array<vtkIdType, 3>> TrianglesOf(vtkPolyData* surface)
{
  std::vector<std::array<vtkIdType, 3>> triangles;
  auto cells = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (cells->GoToFirstCell(); !cells->IsDoneWithTraversal(); cells->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    cells->GetCurrentCell(count, ids);
    triangles.push_back({ids[0], ids[1], ids[2]});
  }
  return triangles;
}

/// The first reason why a triangle surface is not a closed, oriented two-manifold; empty if it is
/// one. Every half edge must meet exactly one opposite half edge, and the triangles around every
/// point must form one ring; every point must be used.
inline std::string TopologyFault(vtkPolyData* surface)
{
  const auto triangles = TrianglesOf(surface);
  if (triangles.empty())
  {
    return "no triangles";
  }
  std::set<std::pair<vtkIdType, vtkIdType>> halfEdges;
  // For each point, the next neighbour of each neighbour, counter-clockwise.
  std::map<vtkIdType, std::map<vtkIdType, vtkIdType>> rings;
  for (const auto& t : triangles)
  {
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const vtkIdType a = t[corner];
      const vtkIdType b = t[(corner + 1) % 3];
      const vtkIdType c = t[(corner + 2) % 3];
      if (a == b || !halfEdges.insert({a, b}).second)
      {
        return "an edge is used twice in one direction, or has no length";
      }
      rings[a][b] = c;
    }
  }
  for (const auto& [a, b] : halfEdges)
  {
    if (halfEdges.count({b, a}) == 0)
    {
      return "an edge has only one triangle";
    }
  }
  for (const auto& [point, next] : rings)
  {
    vtkIdType at = next.begin()->first;
    std::size_t steps = 0;
    do
    {
      at = next.at(at);
      ++steps;
    } while (at != next.begin()->first && steps <= next.size());
    if (steps != next.size())
    {
      return "the triangles around a point form more than one ring";
    }
  }
  return static_cast<vtkIdType>(rings.size()) == surface->GetNumberOfPoints()
             ? std::string()
             : "a point belongs to no triangle";
}
} // namespace palpate::test
