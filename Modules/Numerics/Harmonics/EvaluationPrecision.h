#pragma once

namespace palpate
{
/// Precision in which the sum over the harmonics is computed.
enum class EvaluationPrecision
{
  Double,
  Float ///< half the memory and about two thirds of the time; errors of about 1e-5 mm on organs
};
} // namespace palpate
