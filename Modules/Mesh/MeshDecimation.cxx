#include "MeshDecimation.h"

#include "EdgeCollapser.h"
#include "HalfEdgeMesh.h"
#include "SurfaceRelaxation.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
double SquaredLength(const HalfEdgeMesh& mesh, int h)
{
  return (mesh.Point(mesh.End(h)) - mesh.Point(mesh.Start(h))).squaredNorm();
}

/// The shortest edges first. An edge whose length changed is added again, and its old entry
/// skipped.
class EdgeQueue
{
public:
  explicit EdgeQueue(const HalfEdgeMesh& mesh) : Mesh(mesh) {}

  void AddAll()
  {
    this->Entries.clear();
    for (int h = 0; h < this->Mesh.HalfEdgeLimit(); ++h)
    {
      if (this->Mesh.IsAlive(h) && h < this->Mesh.Twin(h))
      {
        this->Entries.push_back({this->SquareOf(h), h});
      }
    }
    std::make_heap(this->Entries.begin(), this->Entries.end());
    this->Limit = 2 * this->Entries.size();
  }

  void AddAround(int point)
  {
    const int first = this->Mesh.Leaving(point);
    int h = first;
    do
    {
      this->Entries.push_back({this->SquareOf(h), h});
      std::push_heap(this->Entries.begin(), this->Entries.end());
      h = this->Mesh.Around(h);
    } while (h != first);
    if (this->Entries.size() > this->Limit)
    {
      this->DropOld();
    }
  }

  /// The half-edge of the shortest edge, removed from the queue; -1 if the queue is empty.
  int TakeShortest()
  {
    while (!this->Entries.empty())
    {
      const Entry entry = this->Entries.front();
      std::pop_heap(this->Entries.begin(), this->Entries.end());
      this->Entries.pop_back();
      if (this->IsCurrent(entry))
      {
        return entry.HalfEdge;
      }
    }
    return -1;
  }

private:
  struct Entry
  {
    float Square; // mm^2
    int HalfEdge;
    bool operator<(const Entry& other) const noexcept // the heap's top is its greatest
    {
      return this->Square != other.Square ? this->Square > other.Square
                                          : this->HalfEdge > other.HalfEdge;
    }
  };

  float SquareOf(int h) const { return static_cast<float>(SquaredLength(this->Mesh, h)); }
  bool IsCurrent(const Entry& entry) const
  {
    return this->Mesh.IsAlive(entry.HalfEdge) && this->SquareOf(entry.HalfEdge) == entry.Square;
  }
  // Bounds the memory.
  void DropOld()
  {
    const auto end = std::remove_if(this->Entries.begin(), this->Entries.end(),
                                    [this](const Entry& entry) { return !this->IsCurrent(entry); });
    this->Entries.erase(end, this->Entries.end());
    std::make_heap(this->Entries.begin(), this->Entries.end());
    this->Limit = std::max(this->Limit, 2 * this->Entries.size());
  }

  const HalfEdgeMesh& Mesh;
  std::vector<Entry> Entries;
  std::size_t Limit = 0;
};

/// Reports the fraction of the triangles removed, now and then.
class CollapseProgress
{
public:
  CollapseProgress(const KernelProgress& report, int first, int last)
      : Report(report), First(first), Last(last)
  {
  }
  bool Continues(int count) const
  {
    const bool isDue = (this->First - count) % 2048 == 0;
    // The last collapse may remove one triangle more than asked for.
    const double part = static_cast<double>(this->First - count) / (this->First - this->Last);
    return !this->Report || !isDue || this->Report(std::min(part, 1.0));
  }

private:
  const KernelProgress& Report;
  int First;
  int Last;
};

double MeanSquaredEdge(const HalfEdgeMesh& mesh)
{
  double sum = 0.0;
  for (int h = 0; h < mesh.HalfEdgeLimit(); ++h)
  {
    sum += mesh.IsAlive(h) ? SquaredLength(mesh, h) : 0.0;
  }
  return sum / (3.0 * mesh.TriangleCount());
}

/// Removes edges until a number of triangles is reached.
class Decimation
{
public:
  Decimation(HalfEdgeMesh& mesh, ReferenceNormals& normals, int goal, const KernelProgress& report)
      : Mesh(mesh), Collapser(mesh, normals), Goal(goal),
        Progress(report, mesh.TriangleCount(), goal)
  {
  }

  /// Returns false if cancelled.
  bool Run() { return this->Sweep() && this->CollapseShortestFirst(); }

private:
  bool IsDone() const noexcept { return this->Mesh.TriangleCount() <= this->Goal; }
  bool HasManyMore() const noexcept { return this->Mesh.TriangleCount() / 2 > this->Goal; }

  // Collapses short edges in the order of the memory, which takes a fraction of the time of the
  // shortest first; the last half of the triangles, which leaves no trace of it, is left to these.
  bool Sweep()
  {
    double share = 0.7; // of the mean: the edges of an even mesh are about that different
    while (this->HasManyMore() && share < 2.0)
    {
      const int before = this->Mesh.TriangleCount();
      if (!this->CollapseShorterThan(share * MeanSquaredEdge(this->Mesh)))
      {
        return false;
      }
      share *= this->Mesh.TriangleCount() > 0.9 * before ? 1.2 : 1.0;
    }
    return true;
  }

  bool CollapseShorterThan(double square)
  {
    for (int h = 0; h < this->Mesh.HalfEdgeLimit() && this->HasManyMore(); ++h)
    {
      if (this->Mesh.IsAlive(h) && SquaredLength(this->Mesh, h) < square &&
          this->Collapser.TryCollapse(h) && !this->Progress.Continues(this->Mesh.TriangleCount()))
      {
        return false;
      }
    }
    return true;
  }

  // An edge that had to stay is tried again when all others have been.
  bool CollapseShortestFirst()
  {
    EdgeQueue queue(this->Mesh);
    for (int before = this->Mesh.TriangleCount() + 1;
         !this->IsDone() && this->Mesh.TriangleCount() < before;)
    {
      before = this->Mesh.TriangleCount();
      queue.AddAll();
      for (int h = queue.TakeShortest(); h >= 0 && !this->IsDone(); h = queue.TakeShortest())
      {
        const int kept = this->Mesh.Start(h);
        if (this->Collapser.TryCollapse(h))
        {
          queue.AddAround(kept);
          if (!this->Progress.Continues(this->Mesh.TriangleCount()))
          {
            return false;
          }
        }
      }
    }
    return true;
  }

  HalfEdgeMesh& Mesh;
  EdgeCollapser Collapser;
  int Goal;
  CollapseProgress Progress;
};
} // namespace

Status DecimateMesh(const IndexedMesh& mesh, const DecimationSettings& settings,
                    const ReferenceNormal& normal, const KernelProgress& progress,
                    IndexedMesh& decimated)
{
  if (settings.Triangles < 4 || settings.RelaxationRounds < 0)
  {
    return Status::Failure("A decimated surface needs at least 4 triangles.");
  }
  HalfEdgeMesh surface;
  if (Status status = HalfEdgeMesh::Make(mesh, surface); !status.IsOk())
  {
    return status;
  }
  ReferenceNormals normals(surface, normal);
  if (!Decimation(surface, normals, settings.Triangles, progress).Run())
  {
    return Status::Failure("Cancelled.");
  }
  RelaxSurface(surface, normals, settings.RelaxationRounds);
  decimated = surface.ToIndexedMesh();
  return Status::Success();
}
} // namespace palpate
