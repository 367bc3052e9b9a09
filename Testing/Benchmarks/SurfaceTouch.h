#pragma once

#include "SurfaceModel.h"
#include "SurfaceTouchTruth.h"

#include <vector>

namespace palpate::bench
{
/// Short random paths of a sphere (radius in mm; 0 is a point) over a surface, each tick next to a
/// search of the whole surface.
struct TouchedPaths
{
  long Paths = 0; ///< begun where the tool is free
  test::SurfaceTouchTruth::Counts Counts;
};
TouchedPaths TouchPaths(const SurfaceModel& surface, double toolRadius, long paths);

/// A random hand in and out of a surface.
struct TouchedTicks
{
  long Ticks = 0;
  long Touching = 0;
  long NotFinite = 0;
  /// Ticks when the tool is held 2 mm farther than it has to be to be free, and could move nearer;
  /// the longest such time.
  long Lags = 0;
  long LongestLag = 0;
  long Jumps = 0; ///< of the force by more than 1 N while the hand does not jump
};
TouchedTicks TouchByHand(const SurfaceModel& surface, double toolRadius, long ticks);

/// Times of ticks (us), each the shortest of five runs of the same path: 0.02 to 0.1 mm a tick over
/// the surface, from 0.75 mm above to 2.25 mm below it.
std::vector<float> TimeTouch(const SurfaceModel& surface, double toolRadius, long ticks);
} // namespace palpate::bench
