#pragma once

#include "PalpateSessionModule.h"
#include "StudyPipeline.h"
#include "StudyState.h"

#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// How the dial has a structure felt, and what was measured of that.
struct StudyDialLine
{
  int Label = 0;
  std::string Title;
  std::string Settings;                    ///< "harmonics of degree 8"
  std::optional<double> TickMicroseconds;  ///< mean, of its model alone
  std::optional<double> ErrorMillimeters;  ///< of the surface, mean
  std::string Rungs;                       ///< what each would cost, a line each; empty without
  std::optional<double> MeasuringFraction; ///< while it is being measured
  std::string Problem;                     ///< why it could not be; empty without
};

/// For each structure that can be touched.
PALPATESESSION_EXPORT std::vector<StudyDialLine> DialLinesOf(const StudyState& state,
                                                             const StudyPipeline& pipeline);

/// "label 1: harmonics of degree 8, 0.31 µs, 0.12 mm".
PALPATESESSION_EXPORT std::string TextOf(const StudyDialLine& line);

/// One sentence of numbers for the whole scene: the slowest tick and the largest error that are
/// expected, beside the tick that is measured now (µs, of all a servo does; 0: nothing is touched),
/// and how many structures are still to be measured.
PALPATESESSION_EXPORT std::string DialNumbersText(const std::vector<StudyDialLine>& lines,
                                                  double measuredMicroseconds);
} // namespace palpate
