#pragma once

namespace palpate
{
/// Fades forces in after a start or a change of scene, when the hand may be deep inside.
class RampIn
{
public:
  /// `duration` in s; not positive means no fading.
  explicit RampIn(double duration) noexcept : Duration(duration) {}

  /// The factor in [0, 1] of this tick, `period` (s) after the last one; starts at 0 and rises
  /// linearly.
  double Advance(double period) noexcept;
  bool IsRamping() const noexcept { return this->Elapsed < this->Duration; }
  void Restart() noexcept
  {
    this->Elapsed = 0.0;
    this->IsFirst = true;
  }

private:
  double Duration; // s
  double Elapsed = 0.0;
  bool IsFirst = true;
};
} // namespace palpate
