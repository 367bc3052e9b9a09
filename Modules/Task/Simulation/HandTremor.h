#pragma once

#include "PalpateTaskModule.h"
#include "Vector3.h"

#include <random>

namespace palpate
{
/// Physiological tremor: noise with a peak near 9 Hz, of unit RMS along each axis. An
/// autoregressive process of second order, one step a tick.
class PALPATETASK_EXPORT HandTremor
{
public:
  explicit HandTremor(double rate);

  Vector3 Next(std::mt19937_64& random);

private:
  double First; // weights of the last two values
  double Second;
  double Gain; // of the noise
  Vector3 Last = Vector3::Zero();
  Vector3 Before = Vector3::Zero();
  std::normal_distribution<double> Normal;
};
} // namespace palpate
