#pragma once

#include "PalpateStudyModule.h"
#include "SurfaceTouch.h"

#include <cstddef>
#include <vector>

namespace palpate
{
struct TouchRecording;

/// Observations of an organ that a recorded touch has: the structure that was touched longest, at
/// places that are some millimetres apart, so that a hand that rests does not count a thousand
/// times.
struct RecordedTouchSettings
{
  double ToolRadius = 0.0; ///< mm, of the sphere that touched, which a recording does not have
  double Deviation = 1.0;  ///< mm, of each of them
  double Spacing = 5.0;    ///< mm, at least; larger where there are more than Most
  std::size_t Most = 100;  ///< with normals they take what a drawing holds (MostDrawnRows)
};

/// A point where the tool touched, and the normal there, of each place in the order of time. Ticks
/// while the clutch is held, inside of a structure that is silent, and in tissue that yields are
/// left out. Empty if there are no others. Allocates; each tick meets the places so far.
PALPATESTUDY_EXPORT std::vector<SurfaceTouch> TouchesOf(const TouchRecording& recording,
                                                        const RecordedTouchSettings& settings);
} // namespace palpate
