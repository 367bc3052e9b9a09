#include "MeshSimplification.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace palpate
{
namespace
{
constexpr int ReportInterval = 1024; // vertices

// Keeps 16 bits of the mantissa.
double RoundCost(double cost)
{
  int exponent = 0;
  const double mantissa = std::frexp(cost, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(mantissa, 16)), exponent - 16);
}

// Six neighbours are ideal.
double ValencePenalty(int valence)
{
  const int excess = std::max(0, valence - 6);
  return 1.0 + 0.25 * excess * excess;
}

struct Candidate
{
  double Cost;
  int Vertex;
  int Target;
  int Version; ///< how often the vertex's ring has changed

  bool operator<(const Candidate& other) const noexcept
  {
    if (this->Cost != other.Cost)
    {
      return this->Cost > other.Cost;
    }
    return this->Version != other.Version ? this->Version > other.Version
                                          : this->Vertex > other.Vertex;
  }
};

// Best collapse of each vertex in a heap; entries of older versions are skipped.
class CollapseQueue
{
public:
  CollapseQueue(const std::vector<MappedVertex>& vertices, const VertexRings& rings,
                double changePenalty)
      : Vertices(vertices), Rings(rings), ChangePenalty(changePenalty), Versions(vertices.size(), 0)
  {
    std::vector<Candidate> all;
    all.reserve(2 * vertices.size());
    this->Heap = std::priority_queue<Candidate>(std::less<Candidate>(), std::move(all));
    for (int v = 0; v < rings.Size(); ++v)
    {
      this->Update(v);
    }
  }

  Candidate Pop()
  {
    for (;;)
    {
      const Candidate best = this->Heap.top();
      this->Heap.pop();
      if (best.Version != this->Versions[static_cast<std::size_t>(best.Vertex)])
      {
        continue;
      }
      // Chords far from the vertex may have come since.
      if (this->Rings.CanCollapse(best.Vertex, best.Target))
      {
        return best;
      }
      this->Update(best.Vertex);
    }
  }

  void Remove(int vertex) { ++this->Versions[static_cast<std::size_t>(vertex)]; }

  void Update(int vertex)
  {
    const Ring ring = this->Rings.Of(vertex);
    Candidate best{std::numeric_limits<double>::infinity(), vertex, -1,
                   ++this->Versions[static_cast<std::size_t>(vertex)]};
    if (ring.Count > MeshSimplification::LargestRing)
    {
      return;
    }
    for (const int target : ring)
    {
      const double cost = RoundCost(this->Cost(vertex, target, ring.Count) *
                                    (1.0 + this->ChangePenalty * best.Version));
      if ((cost < best.Cost || (cost == best.Cost && target < best.Target)) &&
          this->Rings.CanCollapse(vertex, target))
      {
        best.Cost = cost;
        best.Target = target;
      }
    }
    if (best.Target >= 0)
    {
      this->Heap.push(best);
    }
  }

private:
  double Cost(int vertex, int target, int valence) const
  {
    const Vector3& a = this->Vertices[static_cast<std::size_t>(vertex)].Point;
    const Vector3& b = this->Vertices[static_cast<std::size_t>(target)].Point;
    return (a - b).squaredNorm() * ValencePenalty(this->Rings.Of(target).Count + valence - 4);
  }

  const std::vector<MappedVertex>& Vertices;
  const VertexRings& Rings;
  double ChangePenalty; // spreads the collapses
  std::vector<int> Versions;
  std::priority_queue<Candidate> Heap;
};
} // namespace

bool Simplify(const std::vector<MappedVertex>& vertices, const SimplificationSettings& settings,
              const KernelProgress& progress, VertexRings& rings, MeshSimplification& result)
{
  result = {};
  result.Removals.reserve(vertices.size());
  result.RingEntries.reserve(6 * vertices.size());
  CollapseQueue queue(vertices, rings, settings.ChangePenalty);
  const int present = rings.CountVertices();
  for (int left = present; left > settings.Vertices; --left)
  {
    const Candidate best = queue.Pop();
    const Ring ring = rings.Of(best.Vertex);
    const std::size_t first = result.RingEntries.size();
    const int at = ring.Find(best.Target);
    result.Removals.push_back({best.Vertex, ring.Count, first});
    result.RingEntries.insert(result.RingEntries.end(), ring.First + at, ring.end());
    result.RingEntries.insert(result.RingEntries.end(), ring.First, ring.First + at);
    rings.Collapse(best.Vertex, best.Target);
    queue.Remove(best.Vertex);
    for (std::size_t i = first; i < result.RingEntries.size(); ++i)
    {
      queue.Update(result.RingEntries[i]);
    }
    const double done = 1.0 - static_cast<double>(left) / static_cast<double>(present);
    if (left % ReportInterval == 0 && progress && !progress(done))
    {
      return false;
    }
  }
  return true;
}
} // namespace palpate
