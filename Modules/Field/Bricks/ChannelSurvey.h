#pragma once

#include "FieldSamples.h"
#include "Status.h"

#include <limits>

namespace palpate
{
/// What is known of a channel once all its samples were seen.
struct ChannelSurvey
{
  double Lowest = std::numeric_limits<double>::infinity();
  double Highest = -std::numeric_limits<double>::infinity();
  ScalarType Exact = ScalarType::Float64; ///< the smallest type for storage that loses nothing (of
                                          ///< 64-bit integers, what a double loses)
};

/// Refuses samples that are absent, lie outside the grid or are not finite.
Status Survey(const FieldSamples& samples, const FieldGrid& grid, ChannelSurvey& survey);
} // namespace palpate
