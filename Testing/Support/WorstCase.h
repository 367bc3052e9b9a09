#pragma once

#include <cmath>

namespace palpate::test
{
/// Largest magnitude of its inputs. After NaN it stays NaN, so that no comparison with a tolerance
/// succeeds; std::max would lose it.
class WorstCase
{
public:
  void Add(double difference)
  {
    const double size = std::abs(difference);
    if (!std::isnan(this->Largest) && !(size <= this->Largest))
    {
      this->Largest = size;
    }
  }
  double Value() const { return this->Largest; }

private:
  double Largest = 0.0;
};
} // namespace palpate::test
