#pragma once

#include "TouchCues.h"

#include <cstddef>
#include <cstdint>

namespace palpate
{
/// A touch as a sound: a tone whose pitch and loudness follow the force (two octaves), a rustle for
/// texture, and a click when a contact begins, the brighter the harder the material. Silence
/// without a force. Every change is spread over some milliseconds, so that none of them clicks by
/// itself. One thread; does not allocate.
class TouchTone
{
public:
  static constexpr int Rate = 48000;           ///< samples a second
  static constexpr double LowestPitch = 220.0; ///< Hz, of the least force
  static constexpr double Octaves = 2.0;       ///< to that of the full force
  static constexpr float Loudest = 0.6F;       ///< of the samples

  /// The next samples, from -1 to 1.
  void Render(const TouchCue& cue, float* samples, std::size_t count) noexcept;

private:
  double Noise() noexcept;

  double Phase = 0.0; // of a turn
  double Pitch = LowestPitch;
  double Loudness = 0.0;
  double Rustle = 0.0;
  double Click = 0.0;
  double Smoothed = 0.0; // noise
  std::uint32_t Seed = 1;
};
} // namespace palpate
