#pragma once

#include "FieldSamples.h"
#include "Status.h"

#include <limits>

namespace palpate
{
/// Statistics over all samples of a channel.
struct ChannelSurvey
{
  double Lowest = std::numeric_limits<double>::infinity();
  double Highest = -std::numeric_limits<double>::infinity();
  ScalarType Exact = ScalarType::Float64; ///< the smallest storage type without loss (for 64-bit
                                          ///< integers, beyond that of double)
};

/// Fails if samples are missing, lie outside the grid or are not finite.
Status Survey(const FieldSamples& samples, const FieldGrid& grid, ChannelSurvey& survey);
} // namespace palpate
