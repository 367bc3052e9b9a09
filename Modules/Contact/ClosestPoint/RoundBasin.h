#pragma once

namespace palpate
{
/// Directions around a closest point of a radial model within which no point is closer than
/// `LowerDistance`.
struct RoundBasin
{
  double Angle = 0.0;         ///< rad; 0 if unknown
  double LowerDistance = 0.0; ///< mm
};
} // namespace palpate
