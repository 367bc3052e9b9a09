#include "TouchTone.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double ChangeTime = 0.008; // s, of loudness and pitch

double Part(double cue) noexcept
{
  return std::clamp(cue, 0.0, 1.0);
}
} // namespace

// From -1 to 1; a generator of its own, so that the same cues give the same samples.
double TouchTone::Noise() noexcept
{
  this->Seed = this->Seed * 1664525U + 1013904223U;
  return static_cast<double>(this->Seed >> 8U) / 8388608.0 - 1.0;
}

void TouchTone::Render(const TouchCue& cue, float* samples, std::size_t count) noexcept
{
  const double step = 1.0 - std::exp(-1.0 / (ChangeTime * Rate));
  const double push = Part(cue.Push);
  const double pitch = LowestPitch * std::exp2(Octaves * push);
  const double loudness = push > 0.0 ? 0.15 + 0.55 * push : 0.0;
  const double bright = 0.15 + 0.85 * Part(cue.Hardness);
  for (std::size_t n = 0; n < count; ++n)
  {
    this->Pitch += step * (pitch - this->Pitch);
    this->Loudness += step * (loudness - this->Loudness);
    this->Rustle += step * (0.5 * Part(cue.Texture) - this->Rustle);
    this->Click += step * (0.6 * Part(cue.Knock) - this->Click);
    this->Phase += this->Pitch / Rate;
    this->Phase -= std::floor(this->Phase);
    this->Smoothed += bright * (this->Noise() - this->Smoothed);
    const double sum = this->Loudness * std::sin(2.0 * Pi * this->Phase) +
                       (this->Rustle + this->Click) * this->Smoothed;
    samples[n] = Loudest * static_cast<float>(std::clamp(sum, -1.0, 1.0));
  }
}
} // namespace palpate
