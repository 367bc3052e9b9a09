#pragma once

#include "TouchState.h"

namespace palpate
{
/// A tick in three numbers from 0 to 1, for senses that cannot display a force: rumble, sound. All
/// are 0 without a force at the device.
struct TouchCue
{
  double Push = 0.0;     ///< the force
  double Texture = 0.0;  ///< how much the force trembles
  double Knock = 0.0;    ///< a contact has begun; the harder the faster, fading
  double Hardness = 0.0; ///< force for depth
};

/// Follows a touch. One for each thread; does not allocate.
class TouchCues
{
public:
  static constexpr double FullForce = 5.0;    ///< N
  static constexpr double FullTremble = 0.3;  ///< N, mean deviation from the smoothed force
  static constexpr double FullSpeed = 150.0;  ///< mm/s, at the beginning of a contact
  static constexpr double FullHardness = 2.0; ///< N/mm

  /// Every tick, in order.
  const TouchCue& Update(const TouchState& state) noexcept;
  const TouchCue& Newest() const noexcept { return this->Now; }

private:
  TouchCue Now;
  double SmoothForce = 0.0; // N
  double Tremble = 0.0;     // N
  bool WasTouching = false;
  bool HasLast = false;
  std::int64_t LastTime = 0; // ns
  Vector3 LastProbe = Vector3::Zero();
};
} // namespace palpate
