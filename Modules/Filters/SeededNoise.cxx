#include "SeededNoise.h"

#include <cmath>

namespace palpate
{
namespace
{
std::mt19937_64 MakeEngine(std::uint64_t seed, std::uint64_t stream)
{
  const auto low = [](std::uint64_t v) { return static_cast<std::uint32_t>(v); };
  const auto high = [](std::uint64_t v) { return static_cast<std::uint32_t>(v >> 32U); };
  std::seed_seq sequence{low(seed), high(seed), low(stream), high(stream)};
  return std::mt19937_64(sequence);
}
} // namespace

SeededNoise::SeededNoise(std::uint64_t seed, std::uint64_t stream)
    : Engine(MakeEngine(seed, stream))
{
}

double SeededNoise::Uniform()
{
  return (static_cast<double>(this->Engine() >> 11U) + 1.0) * 0x1p-53;
}

double SeededNoise::Next()
{
  if (this->HasSpare)
  {
    this->HasSpare = false;
    return this->Spare;
  }
  const double length = std::sqrt(-2.0 * std::log(this->Uniform()));
  const double angle = 2.0 * M_PI * this->Uniform();
  this->Spare = length * std::sin(angle);
  this->HasSpare = true;
  return length * std::cos(angle);
}
} // namespace palpate
