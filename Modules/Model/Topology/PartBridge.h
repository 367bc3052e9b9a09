#pragma once

#include "HomotopicGrowth.h"
#include "KuhnNeighborhood.h"
#include "ShapeField.h"

#include <array>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace palpate
{
/// A path from one part of an object to another.
struct PartBridge
{
  NodeList Nodes;       ///< outside nodes that join the parts
  std::size_t From = 0; ///< the node of the first part where the bridge begins
  std::size_t To = 0;   ///< the node of another part where it ends
};

/// Finds bridges from the nodes with mark 2 to nodes with mark 1, one after the other, the cheapest
/// first; 0 marks the outside.
///
/// Dijkstra's algorithm over the 14 neighbours, where a step costs its length times 1 + distance
/// outside / spacing, so that the bridge stays near the object, and more where less of the object
/// is around (MassAround): where two faces are parallel, noise decides where they are nearest. The
/// path is widened to a radius of 1.8 spacings. The grid's outermost layer is not used. A search
/// goes on where the one before it ended, so that many bridges take little longer than one. Takes
/// 17 bytes a node.
class BridgeSearch
{
public:
  /// `field` and `marks` must outlive the object.
  BridgeSearch(const ShapeField& field, const std::vector<unsigned char>& marks);

  /// The next bridge. The caller has to set the bridge's nodes and the part that it leads to to 2
  /// before the next call. Returns no nodes if parts touch or there is no node with mark 1.
  PartBridge Next();

private:
  using Entry = std::pair<float, std::size_t>;

  void AddStarts();
  void Spread(std::size_t node);
  std::size_t FindOther();
  PartBridge PathTo(std::size_t last) const;
  void AddSphere(std::size_t node, NodeList& nodes) const;

  const ShapeField* Field;
  const std::vector<unsigned char>* Marks;
  ShapeField Mass;
  KuhnOffsets Steps;
  std::array<float, KuhnNeighbors> Lengths{};
  std::vector<unsigned char> IsBlocked; // the grid's outermost layer
  std::vector<float> Costs;             // 0 for nodes from which the search has started
  std::vector<std::size_t> Parents;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> Queue;
};
} // namespace palpate
