#pragma once

#include "KuhnNeighborhood.h"
#include "ShapeField.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// Offsets of nodes in a grid.
using NodeList = std::vector<std::size_t>;

/// Grows a set of nodes one simple node at a time, so that its topology never changes: a set that
/// begins as a single node stays a ball. What it may not take without changing topology remains:
/// walls of one node across handles, at the lowest priority.
class HomotopicGrowth
{
public:
  /// A set that is empty and may take no node. Nodes with a higher `sign` * value come first.
  HomotopicGrowth(const ShapeField& field, float sign);

  /// Puts a node into the set, whatever that does to the topology.
  void Put(std::size_t node) { this->State[node] = InSet; }
  /// Lets the set take a node; not one of the grid's outermost layer.
  void Allow(std::size_t node) { this->State[node] |= Allowed; }

  bool Contains(std::size_t node) const { return (this->State[node] & InSet) != 0; }
  /// Whether a node was allowed and not taken.
  bool IsLeft(std::size_t node) const { return (this->State[node] & (Allowed | InSet)) == Allowed; }

  /// All nodes that are left.
  NodeList Left() const;

  /// Takes allowed nodes, beginning at `first`, until no allowed neighbour of the set is simple.
  /// In order of priority, rounded to 1,024 levels; equal ones first come, first served, so that
  /// fronts advance evenly.
  void Grow(const NodeList& first);

  /// Allows `extra` nodes and grows by them and by what is left; returns the nodes taken, in order.
  /// For a few nodes: in exact order of priority.
  NodeList Try(const NodeList& extra);
  /// Undoes the last Try, which allowed `extra` and took `taken`.
  void Undo(const NodeList& extra, const NodeList& taken);
  /// Withdraws the permission of nodes that were not taken.
  void Forbid(const NodeList& nodes);

private:
  static constexpr unsigned char InSet = 1;
  static constexpr unsigned char Allowed = 2;
  static constexpr unsigned char Queued = 4;

  unsigned NeighborsInSet(std::size_t node) const;
  template <typename Queue>
  bool Take(std::size_t node, Queue& queue);
  template <typename Queue>
  void Enqueue(std::size_t node, Queue& queue);

  const ShapeField* Field;
  float Sign;
  KuhnOffsets Steps;
  const SimpleNodes* Simple;
  std::vector<unsigned char> State;
};
} // namespace palpate
