#pragma once

#include "CheckedMask.h"
#include "MaskStatistics.h"

#include <functional>
#include <string>
#include <vector>

namespace palpate
{
/// A structure of a case, measured.
struct CheckedOrgan
{
  std::string Name;
  bool IsWhole = false; ///< all structures of the case as one
  MeasuredMask Measured;
};

/// The structures of one patient.
struct CheckedCase
{
  std::vector<CheckedOrgan> Organs;
  bool IsOriented = true; ///< the file states the patient's axes

  /// The name under which all structures together are an organ.
  static constexpr const char* WholeName = "all structures";
};

/// Appends to each organ that has a side in its name "side" (1: its centroid lies on the other side
/// of its partner's, or without a partner of the midline; which side is left says the majority of
/// pairs, or of less than three the patient's axes if the file states them), and to organs of pairs
/// "pair": how far the left one is from the mirror image of the right one, and how different their
/// volumes are: the larger of the distance over the mean radius of their balls, minus that of the
/// median pair, and of |ln(volume ratio)|. The midline is the median over the pairs.
void MeasureSides(CheckedCase& patient);

/// The part of a name that is its side, and the rest: "Putamen_L", "kidney_left", "left lung",
/// "LeftKidney".
struct NameSide
{
  int Side = 0;     ///< 1 left, -1 right, 0 none
  std::string Rest; ///< equal for the two of a pair
};
NameSide SideOfName(const std::string& name);
} // namespace palpate
