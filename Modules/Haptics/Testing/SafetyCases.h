#pragma once

#include "SafetyChain.h"

#include "RandomShapes.h"

#include <cmath>
#include <limits>
#include <vector>

namespace palpate::test
{
inline constexpr std::int64_t TickPeriod = 1'000'000; // ns
inline constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
inline constexpr double Infinite = std::numeric_limits<double>::infinity();

/// Extreme and invalid numbers, mixed with ordinary ones.
inline double HostileNumber(Random& random)
{
  static const double numbers[] = {0.0,     -0.0,  1.0,    -3.0,       1e-320,   1e300,
                                   -1e300,  1e9,   1e-9,   NotANumber, Infinite, -Infinite,
                                   1.7e308, -1e10, 1000.0, -0.1};
  std::uniform_int_distribution<std::size_t> which(0, std::size(numbers) - 1);
  return numbers[which(random)];
}

inline Vector3 HostileVector(Random& random)
{
  return {HostileNumber(random), HostileNumber(random), HostileNumber(random)};
}

/// A vector of any length from 1e-6 to 1e6.
inline Vector3 VectorOfAnyLength(Random& random)
{
  std::uniform_real_distribution<double> exponent(-6.0, 6.0);
  return std::pow(10.0, exponent(random)) * RandomDirection(random);
}

/// Tick n of a ready device at 1 kHz with a new sample at every tick.
inline TickObservation HealthyTick(std::uint64_t n, const Vector3& position = Vector3::Zero())
{
  TickObservation tick;
  tick.Tick.Number = n;
  tick.Tick.Scheduled = static_cast<std::int64_t>(n) * TickPeriod;
  tick.Tick.Started = tick.Tick.Scheduled;
  tick.State = DeviceState::Ready;
  tick.HasSample = true;
  tick.Sample.Position = position;
  tick.Sample.Sequence = n + 1;
  tick.Sample.Time = tick.Tick.Started;
  return tick;
}

/// The same with a contact that pushes.
inline SafetyInput Pushing(std::uint64_t n, const Vector3& force)
{
  SafetyInput input;
  input.Observed = HealthyTick(n);
  input.IsTouching = true;
  input.ContactForce = force;
  return input;
}
} // namespace palpate::test
