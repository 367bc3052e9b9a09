#include "SurfacePaths.h"

#include "GeodesicDistances.h"
#include "MeshMending.h"
#include "StripPath.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <unordered_map>

namespace palpate
{
namespace
{
// An edge to cross: the length of the path over it if the rest were straight, and the half-edge
// through which a triangle is left.
struct Step
{
  double Expected;
  int HalfEdge;
  bool operator<(const Step& other) const noexcept { return this->Expected > other.Expected; }
};

bool HasValidIndices(const IndexedMesh& mesh)
{
  const auto isPoint = [&mesh](int point)
  { return point >= 0 && point < static_cast<int>(mesh.Points.size()); };
  return std::all_of(mesh.Triangles.begin(), mesh.Triangles.end(),
                     [&](const std::array<int, 3>& t)
                     { return std::all_of(t.begin(), t.end(), isPoint); });
}
} // namespace

SurfacePaths::SurfacePaths(IndexedMesh mesh, NearestOnMesh places)
    : Surface(std::move(mesh)), Rings(this->Surface), Places(std::move(places))
{
}

Status SurfacePaths::Make(IndexedMesh mesh, std::unique_ptr<const SurfacePaths>& made)
{
  if (HasValidIndices(mesh))
  {
    WeldPoints(mesh);
    DropDegenerateTriangles(mesh);
  }
  NearestOnMesh places;
  const Status status = NearestOnMesh::Make(mesh, places); // checks points and indices
  if (status.IsOk())
  {
    made.reset(new SurfacePaths(std::move(mesh), std::move(places)));
  }
  return status;
}

int SurfacePaths::AcrossOf(int halfEdge) const noexcept
{
  return this->Rings.IsPair(halfEdge) ? this->Rings.Next(halfEdge) : -1;
}

Vector3 SurfacePaths::MiddleOf(int halfEdge) const noexcept
{
  return 0.5 * (this->Surface.Points[StartOf(this->Surface, halfEdge)] +
                this->Surface.Points[StartOf(this->Surface, NextInTriangle(halfEdge))]);
}

// A* over the midpoints of edges.
std::vector<int> SurfacePaths::Search(const NearestOnMesh::Result& from,
                                      const NearestOnMesh::Result& to,
                                      const std::vector<bool>& corridor) const
{
  constexpr double Outside = 10.0; // so much longer are ways outside of the corridor
  const std::size_t count = 3 * this->Surface.Triangles.size();
  std::vector<double> lengths(count, std::numeric_limits<double>::infinity());
  std::vector<int> parents(count, -1);
  std::priority_queue<Step> open;
  const auto visit = [&](int halfEdge, int parent, double length)
  {
    if (this->AcrossOf(halfEdge) >= 0 && length < lengths[halfEdge])
    {
      lengths[halfEdge] = length;
      parents[halfEdge] = parent;
      open.push({length + (this->MiddleOf(halfEdge) - to.Point).norm(), halfEdge});
    }
  };
  for (int k = 0; k < 3; ++k)
  {
    const int first = 3 * from.Triangle + k;
    visit(first, -1, (this->MiddleOf(first) - from.Point).norm());
  }
  while (!open.empty())
  {
    const int at = open.top().HalfEdge;
    open.pop();
    const int entered = this->AcrossOf(at);
    if (entered / 3 == to.Triangle)
    {
      std::vector<int> crossed;
      for (int h = at; h >= 0; h = parents[h])
      {
        crossed.push_back(h);
      }
      std::reverse(crossed.begin(), crossed.end());
      return crossed;
    }
    const double factor = corridor.empty() || corridor[entered / 3] ? 1.0 : Outside;
    for (const int next : {NextInTriangle(entered), PreviousInTriangle(entered)})
    {
      visit(next, at, lengths[at] + factor * (this->MiddleOf(next) - this->MiddleOf(at)).norm());
    }
  }
  return {};
}

StripPath SurfacePaths::PathOf(const std::vector<int>& crossed, const Vector3& from,
                               const Vector3& to) const
{
  std::vector<int> entered(crossed.size());
  std::transform(crossed.begin(), crossed.end(), entered.begin(),
                 [this](int halfEdge) { return this->AcrossOf(halfEdge); });
  return FindStripPath(this->Surface, crossed, entered, from, to);
}

bool SurfacePaths::RunsAround(int halfEdge, int point) const noexcept
{
  return StartOf(this->Surface, halfEdge) == point ||
         StartOf(this->Surface, NextInTriangle(halfEdge)) == point;
}

// The edges of a strip around a point, and those on the point's other side; none at a boundary.
SurfacePaths::Detour SurfacePaths::DetourAt(const std::vector<int>& crossed, int point,
                                            int place) const
{
  Detour around{place, place, {}};
  const int count = static_cast<int>(crossed.size());
  while (around.First > 0 && this->RunsAround(crossed[around.First - 1], point))
  {
    --around.First;
  }
  while (around.Last + 1 < count && this->RunsAround(crossed[around.Last + 1], point))
  {
    ++around.Last;
  }
  const int goal = this->AcrossOf(crossed[around.Last]) / 3;
  int entered = crossed[around.First];
  for (std::size_t turn = 0; turn < this->Surface.Triangles.size(); ++turn)
  {
    const int next = this->RunsAround(NextInTriangle(entered), point) ? NextInTriangle(entered)
                                                                      : PreviousInTriangle(entered);
    entered = this->AcrossOf(next);
    if (entered < 0)
    {
      break;
    }
    around.Other.push_back(next);
    if (entered / 3 == goal)
    {
      return around;
    }
  }
  around.Other.clear();
  return around;
}

// A strip that returns to a triangle need not have left it.
void SurfacePaths::RemoveLoops(std::vector<int>& crossed) const
{
  std::unordered_map<int, std::size_t> last; // place of the half-edge that leaves a triangle
  for (std::size_t i = 0; i < crossed.size(); ++i)
  {
    last[crossed[i] / 3] = i;
  }
  const int end = crossed.empty() ? -1 : this->AcrossOf(crossed.back()) / 3;
  std::vector<int> kept;
  for (std::size_t i = 0; i < crossed.size() && crossed[i] / 3 != end; ++i)
  {
    i = last[crossed[i] / 3];
    kept.push_back(crossed[i]);
  }
  crossed = std::move(kept);
}

// An end on an edge or at a corner lies in several triangles: the strip is one from the last that
// holds its start to the first that holds its end, so that it does not turn around an end.
void SurfacePaths::CutEnds(std::vector<int>& crossed, const Vector3& from, const Vector3& to) const
{
  constexpr double Near = 1e-9; // of an edge
  const auto holds = [this](int triangle, const Vector3& point)
  {
    const std::array<int, 3>& t = this->Surface.Triangles[triangle];
    const Vector3& a = this->Surface.Points[t[0]];
    const Vector3& b = this->Surface.Points[t[1]];
    const Vector3 nearest = NearestOnTriangle(point, a, b, this->Surface.Points[t[2]]);
    return (nearest - point).norm() <= Near * (b - a).norm();
  };
  const auto end = std::find_if(crossed.begin(), crossed.end(),
                                [&](int halfEdge) { return holds(halfEdge / 3, to); });
  crossed.erase(end, crossed.end());
  const auto start =
      std::find_if(crossed.rbegin(), crossed.rend(),
                   [&](int halfEdge) { return holds(this->AcrossOf(halfEdge) / 3, from); });
  crossed.erase(crossed.begin(), start.base());
}

// Leads the strip around the other side of each corner where that shortens the path nearby; corners
// whose surroundings meet wait for the next pass. Returns whether it changed.
bool SurfacePaths::PassCorners(const StripPath& path, std::vector<int>& crossed) const
{
  constexpr double LeastGain = 1e-12; // of the length
  std::vector<int> next;
  int done = 0; // edges that are in `next`, or replaced
  bool isChanged = false;
  for (const StripPath::Pivot& corner : path.Pivots)
  {
    const Detour around = this->DetourAt(crossed, corner.Point, corner.Crossing);
    if (around.Other.empty() || around.First < done)
    {
      continue;
    }
    const auto first = crossed.begin() + around.First;
    const auto end = crossed.begin() + around.Last + 1;
    const Vector3& before = path.Points[around.First];
    const Vector3& after = path.Points[around.Last + 2];
    const double length = this->PathOf({first, end}, before, after).Length;
    if (this->PathOf(around.Other, before, after).Length < length * (1.0 - LeastGain))
    {
      next.insert(next.end(), crossed.begin() + done, first);
      next.insert(next.end(), around.Other.begin(), around.Other.end());
      done = around.Last + 1;
      isChanged = true;
    }
  }
  next.insert(next.end(), crossed.begin() + done, crossed.end());
  crossed = std::move(next);
  this->RemoveLoops(crossed);
  return isChanged;
}

// Leads the strip around corners until that shortens the path no more.
StripPath SurfacePaths::Shorten(std::vector<int>& crossed, const Vector3& from,
                                const Vector3& to) const
{
  StripPath path = this->PathOf(crossed, from, to);
  const std::size_t mostPasses = 100 + crossed.size();
  for (std::size_t pass = 0; pass < mostPasses && this->PassCorners(path, crossed); ++pass)
  {
    path = this->PathOf(crossed, from, to);
  }
  return path;
}

Status SurfacePaths::FindIn(const NearestOnMesh::Result& start, const NearestOnMesh::Result& end,
                            const std::vector<bool>& corridor, Path& found) const
{
  std::vector<int> crossed;
  if (start.Triangle != end.Triangle)
  {
    crossed = this->Search(start, end, corridor);
    if (crossed.empty())
    {
      return Status::Failure("The points lie on parts of the surface that are not connected.");
    }
  }
  // The ends are cut only then: the strip may first have to pass them on their other side.
  this->Shorten(crossed, start.Point, end.Point);
  this->CutEnds(crossed, start.Point, end.Point);
  StripPath path = this->Shorten(crossed, start.Point, end.Point);
  // At a corner, several edges are crossed at once.
  const double least = 1e-12 * path.Length;
  const auto last =
      std::unique(path.Points.begin(), path.Points.end(),
                  [least](const Vector3& a, const Vector3& b) { return (a - b).norm() <= least; });
  found = {{path.Points.begin(), last}, path.Length};
  return Status::Success();
}

Status SurfacePaths::Find(const Vector3& from, const Vector3& to, Path& found) const
{
  return this->FindIn(this->Places.Find(from), this->Places.Find(to), {}, found);
}

Status SurfacePaths::FindShortest(const Vector3& from, const Vector3& to,
                                  const KernelProgress& progress, Path& found) const
{
  const NearestOnMesh::Result start = this->Places.Find(from);
  const NearestOnMesh::Result end = this->Places.Find(to);
  std::vector<double> distances;
  Status status = FindGeodesicDistances(this->Surface, start, progress, distances);
  if (status.IsOk())
  {
    status = this->FindIn(start, end, CorridorBack(this->Surface, distances, end), found);
  }
  return status;
}
} // namespace palpate
