#include "SurfaceCut.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace palpate
{
namespace
{
// Collects the segments of a cut; their ends are the crossed edges of the mesh, so that segments
// of neighbouring triangles share them exactly.
class CutGraph
{
public:
  CutGraph(vtkPolyData* surface, const Vector3& origin, const Vector3& normal) : Surface(surface)
  {
    const vtkIdType count = surface->GetNumberOfPoints();
    this->Heights.reserve(static_cast<std::size_t>(count));
    for (vtkIdType p = 0; p < count; ++p)
    {
      this->Heights.push_back(normal.dot(this->PointAt(p) - origin));
    }
  }

  void AddTriangle(vtkIdType a, vtkIdType b, vtkIdType c)
  {
    const std::array<vtkIdType, 3> corners{{a, b, c}};
    std::array<int, 2> ends{};
    std::size_t count = 0;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const vtkIdType from = corners[corner];
      const vtkIdType to = corners[(corner + 1) % 3];
      if (this->IsAbove(from) != this->IsAbove(to))
      {
        ends[count++] = this->NodeOn(from, to);
      }
    }
    if (count == 2)
    {
      const int segment = static_cast<int>(this->Segments.size());
      this->Segments.push_back(ends);
      this->SegmentsOf[static_cast<std::size_t>(ends[0])].push_back(segment);
      this->SegmentsOf[static_cast<std::size_t>(ends[1])].push_back(segment);
    }
  }

  std::vector<SurfaceCurve> Curves()
  {
    this->IsUsed.assign(this->Segments.size(), false);
    std::vector<SurfaceCurve> curves;
    // Open curves first, from their ends; the remaining curves are closed.
    for (const bool wantsEnd : {true, false})
    {
      for (std::size_t node = 0; node < this->Nodes.size(); ++node)
      {
        if (!wantsEnd || this->SegmentsOf[node].size() == 1)
        {
          SurfaceCurve curve = this->Follow(static_cast<int>(node));
          if (curve.Points.size() > 1)
          {
            curves.push_back(std::move(curve));
          }
        }
      }
    }
    return curves;
  }

private:
  Vector3 PointAt(vtkIdType p) const
  {
    double point[3];
    this->Surface->GetPoint(p, point);
    return Vector3(point);
  }
  bool IsAbove(vtkIdType p) const { return this->Heights[static_cast<std::size_t>(p)] >= 0.0; }

  int NodeOn(vtkIdType a, vtkIdType b)
  {
    const auto low = static_cast<std::uint64_t>(std::min(a, b));
    const auto high = static_cast<std::uint64_t>(std::max(a, b));
    const int next = static_cast<int>(this->Nodes.size());
    const auto [entry, isNew] = this->NodeOfEdge.try_emplace(low << 32U | high, next);
    if (isNew)
    {
      const double heightA = this->Heights[static_cast<std::size_t>(a)];
      const double heightB = this->Heights[static_cast<std::size_t>(b)];
      const double share = heightA / (heightA - heightB);
      this->Nodes.push_back(this->PointAt(a) + share * (this->PointAt(b) - this->PointAt(a)));
      this->SegmentsOf.emplace_back();
    }
    return entry->second;
  }

  SurfaceCurve Follow(int start)
  {
    SurfaceCurve curve;
    curve.Points.push_back(this->Nodes[static_cast<std::size_t>(start)]);
    int node = start;
    for (int segment = this->UnusedAt(node); segment >= 0; segment = this->UnusedAt(node))
    {
      const auto index = static_cast<std::size_t>(segment);
      this->IsUsed[index] = true;
      node = this->Segments[index][0] == node ? this->Segments[index][1] : this->Segments[index][0];
      curve.Points.push_back(this->Nodes[static_cast<std::size_t>(node)]);
    }
    if (node == start && curve.Points.size() > 2)
    {
      curve.Points.pop_back();
      curve.IsClosed = true;
    }
    return curve;
  }

  int UnusedAt(int node) const
  {
    for (const int segment : this->SegmentsOf[static_cast<std::size_t>(node)])
    {
      if (!this->IsUsed[static_cast<std::size_t>(segment)])
      {
        return segment;
      }
    }
    return -1;
  }

  vtkPolyData* Surface;
  std::vector<double> Heights; // over the plane
  std::unordered_map<std::uint64_t, int> NodeOfEdge;
  std::vector<Vector3> Nodes;
  std::vector<std::array<int, 2>> Segments;
  std::vector<std::vector<int>> SegmentsOf; // node -> segments
  std::vector<bool> IsUsed;
};
} // namespace

std::vector<SurfaceCurve> CutSurface(vtkPolyData* surface, const Vector3& origin,
                                     const Vector3& normal)
{
  CutGraph graph(surface, origin, normal);
  const auto iterator = vtk::TakeSmartPointer(surface->GetPolys()->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(count, ids);
    for (vtkIdType corner = 2; corner < count; ++corner)
    {
      graph.AddTriangle(ids[0], ids[corner - 1], ids[corner]);
    }
  }
  return graph.Curves();
}
} // namespace palpate
