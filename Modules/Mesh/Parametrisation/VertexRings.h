#pragma once

#include "IndexedMesh.h"
#include "Status.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// The neighbours of a vertex, counter-clockwise seen from outside.
struct Ring
{
  const int* First;
  int Count;

  const int* begin() const noexcept { return this->First; }
  const int* end() const noexcept { return this->First + this->Count; }
  int operator[](int i) const noexcept { return this->First[i]; }
  /// Position of `vertex`, or Count.
  int Find(int vertex) const noexcept;
};

/// Triangulation of the sphere as one ring of neighbours per vertex, in one buffer. Collapse
/// removes a vertex, Split puts it back: the connectivity of a progressive mesh (Hoppe 1996).
class VertexRings
{
public:
  /// Fails unless `mesh` is one closed, consistently oriented manifold without handles (genus 0),
  /// which uses every point, with three or more neighbours at each. Looks at indices only.
  static Status From(const IndexedMesh& mesh, VertexRings& rings);

  int Size() const noexcept { return static_cast<int>(this->Slots.size()); }
  /// Empty for a removed vertex. Valid until the next change.
  Ring Of(int vertex) const noexcept
  {
    const Slot& slot = this->Slots[static_cast<std::size_t>(vertex)];
    return {this->Entries.data() + slot.First, slot.Count};
  }
  /// Vertices that are not collapsed; takes time in all.
  int CountVertices() const noexcept;
  /// True if the vertices are neighbours; takes time in the shorter ring.
  bool AreJoined(int vertex, int other) const noexcept;

  /// True if Collapse leaves a triangulation: no neighbour of `vertex` but the two next to `target`
  /// is joined with `target` (link condition). Two or more neighbours of each vertex can be targets
  /// while there are more than four vertices, since chords outside of a ring do not cross.
  bool CanCollapse(int vertex, int target) const noexcept;
  /// Moves `vertex` onto its neighbour `target`. The triangles at their edge vanish.
  void Collapse(int vertex, int target);
  /// Reverses Collapse: `ring` is what `vertex` had then, from `target` on.
  void Split(int vertex, const int* ring, int count);

private:
  struct Slot
  {
    std::size_t First;
    int Count;
    int Capacity;
  };

  bool IsConnected() const;
  int* Begin(int vertex) noexcept
  {
    return this->Entries.data() + this->Slots[static_cast<std::size_t>(vertex)].First;
  }
  void Reserve(int vertex, int count);
  void Replace(int vertex, int position, int removed, const int* added, int count);
  void Replace(int vertex, int removed, int added) noexcept;

  std::vector<Slot> Slots;
  std::vector<int> Entries;
  std::vector<int> Others; // scratch of Collapse
};
} // namespace palpate
