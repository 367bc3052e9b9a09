#include "VertexRings.h"

#include <algorithm>
#include <limits>

namespace palpate
{
namespace
{
const char* const NotClosed = "The surface must be closed and consistently oriented.";
const char* const NotGenus0 = "The surface must be closed, in one part and without handles.";

// For each vertex the two other corners of its triangles, in the triangles' order.
struct CornersOfVertices
{
  std::vector<std::size_t> Offsets;
  std::vector<std::array<int, 2>> Pairs;
};

Status CheckIndices(const IndexedMesh& mesh)
{
  const std::size_t points = mesh.Points.size();
  if (points > static_cast<std::size_t>(std::numeric_limits<int>::max() / 8) ||
      mesh.Triangles.size() != 2 * points - 4 || points < 4)
  {
    return Status::Failure(NotGenus0);
  }
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    const auto inside = [&](int i) { return i >= 0 && static_cast<std::size_t>(i) < points; };
    if (!inside(t[0]) || !inside(t[1]) || !inside(t[2]) || t[0] == t[1] || t[1] == t[2] ||
        t[2] == t[0])
    {
      return Status::Failure("A triangle of the surface needs three different points of its list.");
    }
  }
  return Status::Success();
}

CornersOfVertices CollectCorners(const IndexedMesh& mesh)
{
  CornersOfVertices corners;
  corners.Offsets.assign(mesh.Points.size() + 1, 0);
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    for (const int v : t)
    {
      ++corners.Offsets[static_cast<std::size_t>(v) + 1];
    }
  }
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    corners.Offsets[v + 1] += corners.Offsets[v];
  }
  corners.Pairs.resize(3 * mesh.Triangles.size());
  std::vector<std::size_t> next(corners.Offsets.begin(), corners.Offsets.end() - 1);
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      corners.Pairs[next[static_cast<std::size_t>(t[i])]++] = {t[(i + 1) % 3], t[(i + 2) % 3]};
    }
  }
  return corners;
}
} // namespace

int Ring::Find(int vertex) const noexcept
{
  return static_cast<int>(std::find(this->begin(), this->end(), vertex) - this->begin());
}

Status VertexRings::From(const IndexedMesh& mesh, VertexRings& rings)
{
  if (Status status = CheckIndices(mesh); !status.IsOk())
  {
    return status;
  }
  const CornersOfVertices corners = CollectCorners(mesh);
  VertexRings result;
  result.Slots.reserve(mesh.Points.size());
  result.Entries.reserve(corners.Pairs.size());
  std::vector<int> successor(mesh.Points.size(), -1);
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    const std::size_t first = corners.Offsets[v];
    const std::size_t last = corners.Offsets[v + 1];
    const int count = static_cast<int>(last - first);
    for (std::size_t i = first; i < last; ++i)
    {
      int& next = successor[static_cast<std::size_t>(corners.Pairs[i][0])];
      if (next >= 0)
      {
        return Status::Failure(NotClosed);
      }
      next = corners.Pairs[i][1];
    }
    result.Slots.push_back({first, count, count});
    int at = count > 0 ? corners.Pairs[first][0] : -1;
    for (int i = 0; i < count && at >= 0; ++i)
    {
      result.Entries.push_back(at);
      int& next = successor[static_cast<std::size_t>(at)];
      at = next;
      next = -1;
    }
    // An open fan ends early; two fans at one vertex close early and leave successors behind.
    if (count < 3 || result.Entries.size() != last || at != result.Entries[first])
    {
      return Status::Failure(NotClosed);
    }
  }
  if (!result.IsConnected())
  {
    return Status::Failure(NotGenus0);
  }
  rings = std::move(result);
  return Status::Success();
}

bool VertexRings::IsConnected() const
{
  std::vector<char> seen(this->Slots.size(), 0);
  std::vector<int> reached = {0};
  seen[0] = 1;
  for (std::size_t i = 0; i < reached.size(); ++i)
  {
    for (const int neighbour : this->Of(reached[i]))
    {
      char& mark = seen[static_cast<std::size_t>(neighbour)];
      if (mark == 0)
      {
        mark = 1;
        reached.push_back(neighbour);
      }
    }
  }
  return reached.size() == this->Slots.size();
}

int VertexRings::CountVertices() const noexcept
{
  return static_cast<int>(std::count_if(this->Slots.begin(), this->Slots.end(),
                                        [](const Slot& slot) { return slot.Count > 0; }));
}

bool VertexRings::AreJoined(int vertex, int other) const noexcept
{
  const Ring a = this->Of(vertex);
  const Ring b = this->Of(other);
  return a.Count <= b.Count ? a.Find(other) < a.Count : b.Find(vertex) < b.Count;
}

bool VertexRings::CanCollapse(int vertex, int target) const noexcept
{
  const Ring ring = this->Of(vertex);
  const int at = ring.Find(target);
  for (int i = 2; i < ring.Count - 1; ++i)
  {
    if (this->AreJoined(target, ring[(at + i) % ring.Count]))
    {
      return false;
    }
  }
  return true;
}

void VertexRings::Reserve(int vertex, int count)
{
  Slot& slot = this->Slots[static_cast<std::size_t>(vertex)];
  if (count <= slot.Capacity)
  {
    return;
  }
  const std::size_t first = this->Entries.size();
  slot.Capacity = 2 * count;
  this->Entries.resize(first + static_cast<std::size_t>(slot.Capacity));
  std::copy_n(this->Entries.begin() + static_cast<std::ptrdiff_t>(slot.First), slot.Count,
              this->Entries.begin() + static_cast<std::ptrdiff_t>(first));
  slot.First = first;
}

// `removed` entries from `position` on, not across the end.
void VertexRings::Replace(int vertex, int position, int removed, const int* added, int count)
{
  Slot& slot = this->Slots[static_cast<std::size_t>(vertex)];
  const int size = slot.Count - removed + count;
  this->Reserve(vertex, size);
  int* const at = this->Begin(vertex) + position;
  const int* const rest = at + removed;
  const std::ptrdiff_t tail = slot.Count - removed - position;
  if (count > removed)
  {
    std::copy_backward(rest, rest + tail, at + count + tail);
  }
  else
  {
    std::copy(rest, rest + tail, at + count);
  }
  std::copy_n(added, count, at);
  slot.Count = size;
}

void VertexRings::Replace(int vertex, int removed, int added) noexcept
{
  this->Begin(vertex)[this->Of(vertex).Find(removed)] = added;
}

void VertexRings::Collapse(int vertex, int target)
{
  const Ring ring = this->Of(vertex);
  const int count = ring.Count;
  const int at = ring.Find(target);
  std::vector<int>& other = this->Others; // from the one after target on
  other.assign(ring.First + at + 1, ring.end());
  other.insert(other.end(), ring.First, ring.First + at);
  this->Slots[static_cast<std::size_t>(vertex)].Count = 0;
  for (int i = 1; i < count - 2; ++i)
  {
    this->Replace(other[static_cast<std::size_t>(i)], vertex, target);
  }
  for (const int side : {other.front(), other.back()})
  {
    this->Replace(side, this->Of(side).Find(vertex), 1, nullptr, 0);
  }
  this->Replace(target, this->Of(target).Find(vertex), 1, other.data() + 1, count - 3);
}

void VertexRings::Split(int vertex, const int* ring, int count)
{
  const int target = ring[0];
  for (int i = 2; i < count - 1; ++i)
  {
    this->Replace(ring[i], target, vertex);
  }
  // After the collapse the two sides are next to the target; the vertex returns between.
  const int left = ring[1];
  const int right = ring[count - 1];
  const auto insert = [&](int side, int position) { this->Replace(side, position, 0, &vertex, 1); };
  insert(left, this->Of(left).Find(target));
  insert(right, this->Of(right).Find(target) + 1);
  int* const first = this->Begin(target);
  Slot& slot = this->Slots[static_cast<std::size_t>(target)];
  std::rotate(first, first + this->Of(target).Find(left), first + slot.Count);
  this->Replace(target, 1, count - 3, &vertex, 1);
  this->Slots[static_cast<std::size_t>(vertex)].Count = count;
  std::copy_n(ring, count, this->Begin(vertex));
}
} // namespace palpate
