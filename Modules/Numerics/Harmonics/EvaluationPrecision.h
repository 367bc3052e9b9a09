#pragma once

namespace palpate
{
/// In what numbers the sum over the harmonics is computed.
enum class EvaluationPrecision
{
  Double,
  Float ///< half the memory and some two thirds of the time, for errors of some 1e-5 mm on organs
};
} // namespace palpate
