#include "MapRefinement.h"

#include "MapDescent.h"
#include "RingKernel.h"

#include <algorithm>
#include <array>

namespace palpate
{
namespace
{
// A level is done whenever the number of vertices has grown by this factor.
constexpr double LevelGrowth = 1.5;
constexpr std::size_t VerticesPerReport = 1024;
// Sweeps of a level: so many visits of a vertex, but within these limits.
constexpr double LevelVisits = 60000.0;
constexpr double LeastLevelSweeps = 3.0;
constexpr double MostLevelSweeps = 300.0;
// A vertex is visited again if the D of a triangle next to it changed by more than this, relative.
constexpr double LevelTolerance = 0.01;
constexpr double LastTolerance = 0.005;
// Newton steps of a vertex that returns.
constexpr int FirstSteps = 2;
// Larger rings move in sweeps only, so that time stays linear.
constexpr int LargestMovedRing = 32;
} // namespace

MapRefinement::MapRefinement(VertexRings& rings, std::vector<MappedVertex>& vertices)
    : Rings(rings), Vertices(vertices), Waiting(vertices.size(), 0)
{
  this->Present.reserve(vertices.size());
  for (int v = 0; v < rings.Size(); ++v)
  {
    if (rings.Of(v).Count > 0)
    {
      this->Present.push_back(v);
    }
  }
  if (this->Present.size() == 4)
  {
    this->PlaceTetrahedron();
  }
}

void MapRefinement::PlaceTetrahedron()
{
  const std::array<Vector3, 4> corners = {Vector3(1, 1, 1), Vector3(-1, -1, 1), Vector3(-1, 1, -1),
                                          Vector3(1, -1, -1)};
  for (std::size_t i = 0; i < 4; ++i)
  {
    this->Vertices[static_cast<std::size_t>(this->Present[i])].Direction = corners[i].normalized();
  }
  if (!this->Relaxation.IsInside(this->Vertices, this->Present[0],
                                 this->Rings.Of(this->Present[0])))
  {
    for (const int v : this->Present)
    {
      this->Vertices[static_cast<std::size_t>(v)].Direction.z() *= -1.0;
    }
  }
}

bool MapRefinement::Return(const MeshSimplification& simplification,
                           const MeshSimplification::Removal& removal)
{
  const int* const entries = simplification.RingOf(removal);
  std::array<Vector3, MeshSimplification::LargestRing> polygon;
  for (int i = 0; i < removal.Count; ++i)
  {
    polygon[static_cast<std::size_t>(i)] =
        this->Vertices[static_cast<std::size_t>(entries[i])].Direction;
  }
  const int vertex = removal.Vertex;
  this->Rings.Split(vertex, entries, removal.Count);
  this->Vertices[static_cast<std::size_t>(vertex)].Direction =
      KernelDirection(polygon.data(), removal.Count);
  const Ring ring = this->Rings.Of(vertex);
  if (!this->Relaxation.IsInside(this->Vertices, vertex, ring))
  {
    return false;
  }
  for (int i = 0; i < FirstSteps; ++i)
  {
    this->Relaxation.Step(this->Vertices, vertex, ring);
  }
  this->MakeRoom(ring);
  this->Present.push_back(vertex);
  this->Wake(vertex);
  return true;
}

// Many vertices may return next to each other before the next sweep: without room, each would halve
// a triangle again.
void MapRefinement::MakeRoom(Ring ring)
{
  // By index: a mirrored mesh has its rings in reverse.
  std::array<int, MeshSimplification::LargestRing> neighbours;
  const auto end = std::copy(ring.begin(), ring.end(), neighbours.begin());
  std::sort(neighbours.begin(), end);
  for (auto at = neighbours.begin(); at != end; ++at)
  {
    const int neighbour = *at;
    const Ring around = this->Rings.Of(neighbour);
    if (around.Count <= LargestMovedRing)
    {
      this->Relaxation.Step(this->Vertices, neighbour, around);
    }
  }
}

void MapRefinement::Wake(int vertex)
{
  this->Waiting[static_cast<std::size_t>(vertex)] = 1;
  for (const int neighbour : this->Rings.Of(vertex))
  {
    this->Waiting[static_cast<std::size_t>(neighbour)] = 1;
  }
}

void MapRefinement::WakeAll()
{
  // Memory order is faster than the order of return.
  std::sort(this->Present.begin(), this->Present.end());
  std::fill(this->Waiting.begin(), this->Waiting.end(), char{1});
}

bool MapRefinement::Sweep(double tolerance)
{
  bool any = false;
  for (const int vertex : this->Present)
  {
    char& waiting = this->Waiting[static_cast<std::size_t>(vertex)];
    if (waiting == 0)
    {
      continue;
    }
    waiting = 0;
    const double change = this->Relaxation.Step(this->Vertices, vertex, this->Rings.Of(vertex));
    if (change > tolerance)
    {
      any = true;
      this->Wake(vertex);
      // Newton's next step is much shorter than a short one.
      waiting = change > 3.0 * tolerance ? 1 : 0;
    }
  }
  return any;
}

bool MapRefinement::Sweep()
{
  return this->Sweep(LastTolerance);
}

void MapRefinement::SweepLevel()
{
  std::sort(this->Present.begin(), this->Present.end());
  const double share = LevelVisits / static_cast<double>(this->Size());
  const int most = static_cast<int>(std::clamp(share, LeastLevelSweeps, MostLevelSweeps));
  for (int i = 0; i < most && this->Sweep(LevelTolerance); ++i)
  {
  }
}

double MapRefinement::Descend(int mostSteps, double enough)
{
  std::sort(this->Present.begin(), this->Present.end());
  MapDescent descent(this->Rings, this->Present, this->Vertices);
  if (descent.Energy() > enough)
  {
    descent.Run(mostSteps);
  }
  return descent.Energy();
}

bool MapRefinement::ReturnAll(const MeshSimplification& simplification,
                              const KernelProgress& progress)
{
  const std::size_t count = simplification.Removals.size();
  double nextLevel = LevelGrowth * static_cast<double>(this->Size());
  for (std::size_t i = count; i > 0; --i)
  {
    if (!this->Return(simplification, simplification.Removals[i - 1]))
    {
      return false;
    }
    if (static_cast<double>(this->Size()) >= nextLevel)
    {
      nextLevel *= LevelGrowth;
      this->SweepLevel();
    }
    const double done = static_cast<double>(count - i) / static_cast<double>(count);
    if (i % VerticesPerReport == 0 && progress && !progress(done))
    {
      return false;
    }
  }
  return true;
}
} // namespace palpate
