#pragma once

#include "Clock.h"
#include "PalpateSessionModule.h"
#include "Progress.h"
#include "StudyState.h"
#include "TradeRow.h"
#include "TradeSource.h"

#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// What each of the dial's rungs costs at one structure, and how true it is there.
struct StudyTrade
{
  std::vector<TradeRow> Rungs;   ///< in the order of AllStudyRungs, degrees as far as supported
  double VoxelMillimeters = 0.0; ///< the mask's largest spacing
};

/// Short strokes over a structure of a mask by each rung, timed on `clock`. Throws InputError where
/// the tool cannot touch it at all, FilterError and Cancelled.
PALPATESESSION_EXPORT StudyTrade MeasureStudyTrade(const TradeSource& source,
                                                   const TouchToolSettings& tool,
                                                   const Clock& clock,
                                                   const ProgressFunction& progress);

/// The fastest rung whose ticks fit into a third of a period at `rate` (Hz) and that is true
/// enough: its surface lies as near to the truth as the mask's voxels tell it (on average a
/// spacing / sqrt 12, as for anything that is rounded), or its force is no more than a just
/// noticeable difference off. Without one the truest that fits, or the fastest. -1 where none was
/// measured.
PALPATESESSION_EXPORT int ChosenRung(const StudyTrade& trade, double rate);

/// The row of a rung, or of the sub-voxel field that takes the place of harmonics that a structure
/// refuses. Null where neither was measured.
PALPATESESSION_EXPORT const TradeRow* RowOf(const StudyTrade& trade, int rung);

/// How a structure is felt.
struct StudyFeel
{
  TouchRepresentation Representation = TouchRepresentation::Automatic;
  int Degree = 12;
  FieldInterpolation Interpolation = FieldInterpolation::Trilinear;
  int Rung = -1; ///< of the dial; -1 where that does not say
};

/// By the state's dial. `trade` is what was measured of the structure, null where nothing was yet:
/// until then an automatic dial stands at harmonics of degree 12.
PALPATESESSION_EXPORT StudyFeel FeelOf(const StudyState& state, const StudyStructure& structure,
                                       const StudyTrade* trade);

/// "harmonics of degree 8" of a structure felt so, "facets", "sub-voxel, cubic".
PALPATESESSION_EXPORT std::string Describe(const StudyFeel& feel);
} // namespace palpate
