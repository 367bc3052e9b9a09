#pragma once

#include "ShapeField.h"
#include "Status.h"
#include "TopologyReport.h"

namespace palpate
{
struct TopologySettings
{
  double SmallPart = 0.005; ///< parts with less than this fraction of the volume are dropped
  bool BridgeParts = true;  ///< join other parts to the largest one; otherwise they are refused
};

/// Changes a field so that its inside is one part without cavities and handles: its surface by
/// MarchTetrahedra is then a topological sphere. Small parts are dropped, others bridged, cavities
/// filled, and handles cut or filled (RepairHandles). Nodes that change sides get a value between
/// 0.1 and 0.2 spacings on the new side, others keep theirs. The report's volumes are those by
/// which the surface changes, exactly: a wall of one node is a gap of about a third of a spacing.
///
/// This always succeeds with one part, whatever it has to change: judge the report
/// (CheckTopology). Fails if no node is inside, and if there are several parts and `BridgeParts` is
/// off; the report then has what was dropped before.
Status RepairTopology(ShapeField& field, const TopologySettings& settings, TopologyReport& report);
} // namespace palpate
