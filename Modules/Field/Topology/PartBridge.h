#pragma once

#include "HomotopicGrowth.h"
#include "ShapeField.h"

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

/// The cheapest bridge from the nodes with mark 2 to any node with mark 1; 0 marks the outside.
/// Dijkstra's algorithm over the 14 neighbours, where a step costs its length times 1 + distance
/// outside / spacing, so that the bridge stays near the object; the path is widened to a radius of
/// 1.8 spacings. The grid's outermost layer is not used. Returns no nodes if parts touch or there
/// is no node with mark 1.
PartBridge FindBridge(const ShapeField& field, const std::vector<unsigned char>& marks);
} // namespace palpate
