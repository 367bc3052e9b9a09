#pragma once

#include "Status.h"
#include "Vector3.h"

#include <array>
#include <string>

namespace palpate
{
/// Changes of one kind. Places are in the frame of the field's grid (ShapeGrid), lengths in mm.
struct TopologyChange
{
  int Count = 0;                          ///< places
  double Volume = 0.0;                    ///< mm^3, of all places
  double LargestVolume = 0.0;             ///< mm^3, of the largest place
  Vector3 LargestCentre{Vector3::Zero()}; ///< of the largest place; of bridges, the widest gap's
  double LargestExtent = 0.0; ///< diagonal of the largest place's box; of a bridge the gap's width
};

/// What the repair of an object's topology has changed.
struct TopologyReport
{
  double ObjectVolume = 0.0;   ///< mm^3, before the repair
  TopologyChange DroppedParts; ///< parts that were too small to keep
  TopologyChange Bridges;      ///< joints between parts
  TopologyChange FilledCavities;
  TopologyChange CutHandles;
  TopologyChange FilledHandles;

  /// Parts that were dropped before, which the object's volume did not have.
  void Add(const TopologyChange& dropped);
  double ChangedVolume() const;  ///< mm^3, added or removed
  double AddedVolume() const;    ///< mm^3, added minus removed
  double ChangedPercent() const; ///< of the object's volume
};

/// "1 handle cut and 1 cavity filled, 27 % of the volume"; empty without changes.
std::string ChangeText(const TopologyReport& report);

/// When a repair is to be refused, or confirmed by the user. A body with holes of a few voxels or
/// slices that do not overlap passes; two bodies or a hollow one are refused.
struct TopologyLimits
{
  double ChangedPercent = 2.0; ///< of the object's volume, all changes together
  double CavityDiameter = 5.0; ///< mm, of the sphere that has the largest cavity's volume
  double BridgedGap = 5.0;     ///< mm between parts, and
  double GapShare = 0.25;      ///< of the diameter of the sphere that has the object's volume
};

/// How much of a limit a repair takes up.
struct TopologyLimitUse
{
  double Share = 0.0; ///< above 1 beyond the limit
  std::string Excess; ///< what is refused beyond it, as a predicate of the structure
  std::string Amount; ///< "changes of 1.9 % of the volume (limit 2 %)"
};

/// The largest cavity, the widest gap, and all changes together.
std::array<TopologyLimitUse, 3> UseOfLimits(const TopologyReport& report,
                                            const TopologyLimits& limits);

/// Fails with a message that names the first limit that is exceeded, a predicate of the structure.
Status CheckTopology(const TopologyReport& report, const TopologyLimits& limits);
} // namespace palpate
