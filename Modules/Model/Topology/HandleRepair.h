#pragma once

#include "HomotopicGrowth.h"
#include "ShapeField.h"

#include <vector>

namespace palpate
{
/// Parts of a list of nodes that are connected by the 14 neighbours, each in the order of a search
/// from its first node in the list. `marks` has a byte for each node of the grid, all 0 before and
/// after; nodes of the grid's outermost layer must not be in the list.
std::vector<NodeList> ConnectedParts(const NodeList& nodes, const KuhnOffsets& steps,
                                     std::vector<unsigned char>& marks);

/// Nodes whose side changes so that an object has no handles.
struct HandleRepair
{
  NodeList Cut;    ///< inside before
  NodeList Filled; ///< outside before
};

/// Cuts or fills the handles of an object, whichever changes less; fills where both change about
/// as much.
///
/// The object is one part without cavities (1 in `inside`). First all handles are cut: a ball grows
/// through simple nodes in the order of falling mass, the part of a node's neighbourhood that is
/// inside, and of rising distance from the object's centre. That leaves walls of one node about
/// where the cross-section is least and far from the centre: depth would find where a handle is
/// thinnest, however wide it is there, and noise moves that place. The outside grows towards the
/// object by depth, which leaves membranes of one node across the handles' holes. Each membrane in
/// turn, the cheapest first, is added to the ball, which then may grow through the walls; that is
/// kept unless it costs much more. The cost of a changed node is |field| + spacing / 4. Every step
/// adds simple nodes only, so the result is a ball whatever the input is. After Kriegeskorte and
/// Goebel, NeuroImage 14 (2001).
HandleRepair RepairHandles(const ShapeField& field, const std::vector<unsigned char>& inside);
} // namespace palpate
