#include "TouchTone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace palpate::touch_tone_test
{
namespace
{
std::vector<float> Seconds(TouchTone& tone, const TouchCue& cue, double duration)
{
  std::vector<float> samples(static_cast<std::size_t>(duration * TouchTone::Rate));
  tone.Render(cue, samples.data(), samples.size());
  return samples;
}

double Rms(const std::vector<float>& samples)
{
  double sum = 0.0;
  for (const float sample : samples)
  {
    sum += static_cast<double>(sample) * sample;
  }
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

// Of a pure tone: upward crossings of zero a second.
double PitchOf(const std::vector<float>& samples)
{
  int crossings = 0;
  for (std::size_t n = 1; n < samples.size(); ++n)
  {
    crossings += samples[n - 1] < 0.0F && samples[n] >= 0.0F ? 1 : 0;
  }
  return crossings * static_cast<double>(TouchTone::Rate) / static_cast<double>(samples.size());
}

TouchCue Pushed(double push)
{
  TouchCue cue;
  cue.Push = push;
  return cue;
}

TEST(TouchTone, NothingTouchedIsSilence)
{
  TouchTone tone;
  EXPECT_EQ(Rms(Seconds(tone, {}, 0.2)), 0.0);
}

TEST(TouchTone, PitchAndLoudnessFollowTheForce)
{
  double last = 0.0;
  for (const double push : {0.1, 0.5, 1.0})
  {
    TouchTone tone;
    Seconds(tone, Pushed(push), 0.2);
    const std::vector<float> steady = Seconds(tone, Pushed(push), 1.0);
    EXPECT_NEAR(PitchOf(steady), 220.0 * std::exp2(2.0 * push), 2.0);
    EXPECT_GT(Rms(steady), last);
    last = Rms(steady);
  }
}

TEST(TouchTone, TextureAndKnocksAreNoise)
{
  TouchCue rough = Pushed(0.3);
  rough.Texture = 1.0;
  TouchCue knocked = Pushed(0.3);
  knocked.Knock = 1.0;
  TouchTone plain, rustling, clicking;
  const double smooth = Rms(Seconds(plain, Pushed(0.3), 0.5));
  EXPECT_GT(Rms(Seconds(rustling, rough, 0.5)), 1.05 * smooth);
  EXPECT_GT(Rms(Seconds(clicking, knocked, 0.5)), 1.05 * smooth);
}

TEST(TouchTone, NoChangeJumps)
{
  TouchTone tone;
  std::vector<float> samples = Seconds(tone, Pushed(1.0), 0.1);
  const std::vector<float> after = Seconds(tone, {}, 0.1);
  samples.insert(samples.end(), after.begin(), after.end());
  // The steepest full tone: 2 pi 880 Hz / 48 kHz of its amplitude.
  const double steepest = 0.12 * TouchTone::Loudest;
  for (std::size_t n = 1; n < samples.size(); ++n)
  {
    ASSERT_LT(std::abs(samples[n] - samples[n - 1]), steepest);
  }
  EXPECT_LT(std::abs(samples.back()), 1e-4) << "silent after a tenth of a second";
}

TEST(TouchTone, AnyCueStaysWithinItsLimits)
{
  TouchTone tone;
  const double odd[] = {-1.0, 0.0, 0.5, 1.0, 7.0, 1e300, std::nan("")};
  for (const double push : odd)
  {
    for (const double other : odd)
    {
      TouchCue cue;
      cue.Push = std::isnan(push) ? 0.0 : push;
      cue.Texture = cue.Knock = std::isnan(other) ? 0.0 : other;
      cue.Hardness = cue.Texture;
      for (const float sample : Seconds(tone, cue, 0.01))
      {
        ASSERT_LE(std::abs(sample), TouchTone::Loudest);
      }
    }
  }
}
} // namespace
} // namespace palpate::touch_tone_test
