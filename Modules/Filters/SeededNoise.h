#pragma once

#include "PalpateFiltersModule.h"

#include <cstdint>
#include <random>

namespace palpate
{
/// Independent standard normal numbers, identical on every machine for the same seed and stream.
/// (std::normal_distribution may differ between standard libraries; the Box-Muller transform of
/// std::mt19937_64 does not.)
class PALPATEFILTERS_EXPORT SeededNoise
{
public:
  /// Different streams of one seed are independent, so that rows of an image can be filled in any
  /// order by any thread.
  SeededNoise(std::uint64_t seed, std::uint64_t stream);

  double Next();

private:
  /// In (0, 1].
  double Uniform();

  std::mt19937_64 Engine;
  double Spare = 0.0;
  bool HasSpare = false;
};
} // namespace palpate
