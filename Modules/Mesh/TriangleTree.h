#pragma once

#include "IndexedMesh.h"
#include "Status.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace palpate
{
/// An axis-aligned box in single precision, rounded outwards.
struct FloatBox
{
  std::array<float, 3> Low;
  std::array<float, 3> High;

  bool Overlaps(const FloatBox& other) const noexcept
  {
    return this->Low[0] <= other.High[0] && other.Low[0] <= this->High[0] &&
           this->Low[1] <= other.High[1] && other.Low[1] <= this->High[1] &&
           this->Low[2] <= other.High[2] && other.Low[2] <= this->High[2];
  }
  void Extend(const FloatBox& other) noexcept
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->Low[axis] = std::min(this->Low[axis], other.Low[axis]);
      this->High[axis] = std::max(this->High[axis], other.High[axis]);
    }
  }
};

/// A bounding-volume hierarchy of a mesh's triangles, split in the middle of the longest side, or
/// by numbers where that leaves less than a third on one side. Immutable; its queries do not change
/// it. 36 bytes per triangle, 24 more for its box if that is kept, and 16 during construction,
/// which takes some 0.15 us per triangle.
class TriangleTree
{
public:
  /// In depth-first order: a node's first child follows it.
  struct Node
  {
    FloatBox Box;
    std::int32_t Second; ///< the other child; of a leaf, its first place in Order()
    std::int32_t Count;  ///< of a leaf, its number of triangles; else 0
  };
  /// A stack of this size suffices to visit one child and keep the other.
  static constexpr int MostPending = 64;
  static constexpr int LeafSize = 4;
  enum class TriangleBoxes
  {
    Dropped,
    Kept
  };

  TriangleTree() = default;
  /// Fails for a mesh without triangles, indices out of range, coordinates that are not finite or
  /// beyond 1e30 mm, and more than 700 million triangles.
  static Status Make(const IndexedMesh& mesh, TriangleTree& tree,
                     TriangleBoxes boxes = TriangleBoxes::Dropped);

  /// The first is the root.
  const std::vector<Node>& Nodes() const noexcept { return this->Tree; }
  /// Takes them away, from a tree of which only Order() is still needed.
  std::vector<Node> TakeNodes() && noexcept { return std::move(this->Tree); }
  /// The triangles, leaf by leaf.
  const std::vector<int>& Order() const noexcept { return this->Numbers; }
  /// Their boxes, in this order, if they are kept.
  const std::vector<FloatBox>& Boxes() const noexcept { return this->BoxOfPlace; }

  /// Calls visit(i, j), i < j, for all pairs of places in Order() with overlapping boxes, until it
  /// returns false. Needs Boxes().
  template <typename Visit>
  void ForEachOverlap(const Visit& visit) const;

private:
  struct Center
  {
    std::array<float, 3> At;
    std::int32_t Triangle;
  };

  void Build(std::vector<Center>& centers, std::size_t begin, std::size_t end);
  static std::size_t Split(std::vector<Center>& centers, std::size_t begin, std::size_t end);
  template <typename Visit>
  bool VisitLeaves(const Node& one, const Node& other, const Visit& visit) const;

  std::vector<Node> Tree;
  std::vector<int> Numbers;
  std::vector<FloatBox> BoxOfPlace;
};

template <typename Visit>
bool TriangleTree::VisitLeaves(const Node& one, const Node& other, const Visit& visit) const
{
  for (int i = one.Second; i < one.Second + one.Count; ++i)
  {
    const int first = &one == &other ? i + 1 : other.Second;
    for (int j = first; j < other.Second + other.Count; ++j)
    {
      if (this->BoxOfPlace[i].Overlaps(this->BoxOfPlace[j]) && !visit(i, j))
      {
        return false;
      }
    }
  }
  return true;
}

template <typename Visit>
void TriangleTree::ForEachOverlap(const Visit& visit) const
{
  std::vector<std::pair<int, int>> pending{{0, 0}};
  while (!pending.empty())
  {
    const auto [i, j] = pending.back();
    pending.pop_back();
    const Node& one = this->Tree[i];
    const Node& other = this->Tree[j];
    if (i == j && one.Count == 0)
    {
      pending.insert(pending.end(),
                     {{one.Second, one.Second}, {i + 1, one.Second}, {i + 1, i + 1}});
    }
    else if (i != j && !one.Box.Overlaps(other.Box))
    {
      continue;
    }
    else if (one.Count != 0 && other.Count != 0)
    {
      if (!this->VisitLeaves(one, other, visit))
      {
        return;
      }
    }
    else if (other.Count != 0) // the smaller node's index is larger: it is split last
    {
      pending.insert(pending.end(), {{one.Second, j}, {i + 1, j}});
    }
    else if (one.Count != 0)
    {
      pending.insert(pending.end(), {{i, other.Second}, {i, j + 1}});
    }
    else
    {
      pending.insert(
          pending.end(),
          {{one.Second, other.Second}, {one.Second, j + 1}, {i + 1, other.Second}, {i + 1, j + 1}});
    }
  }
}
} // namespace palpate
