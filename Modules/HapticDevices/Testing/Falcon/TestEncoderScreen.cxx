#include "EncoderScreen.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace palpate::encoder_screen_test
{
namespace
{
constexpr std::int64_t Period = 1'000'000; // ns

// The fastest motion of a hand: 40 mm to and fro four times a second, 1 m/s.
FalconNumbers Swinging(int tick)
{
  const double phase = 2.0 * M_PI * 4.0 * 1e-3 * tick;
  const auto at = [phase](double shift)
  { return static_cast<std::int16_t>(std::lround(950.0 * std::sin(phase + shift))); };
  return {at(0.0), at(2.0), at(4.0)};
}

TEST(EncoderScreen, AcceptsHandMotionFromSecondReply)
{
  EncoderScreen screen;
  EXPECT_FALSE(screen.Believes(Swinging(0), 0));
  for (int tick = 1; tick < 2000; ++tick)
  {
    ASSERT_TRUE(screen.Believes(Swinging(tick), tick * Period)) << tick;
  }
}

TEST(EncoderScreen, AcceptsCountsAfterGap)
{
  std::mt19937_64 random(41);
  EncoderScreen screen;
  EXPECT_FALSE(screen.Believes(Swinging(0), 0));
  EXPECT_TRUE(screen.Believes(Swinging(1), Period));
  for (int tick = 2; tick < 4000; tick += 1 + static_cast<int>(random() % 9))
  {
    ASSERT_TRUE(screen.Believes(Swinging(tick), tick * Period)) << tick;
  }
}

TEST(EncoderScreen, RejectsOnlyTheWrongReply)
{
  std::mt19937_64 random(42);
  EncoderScreen screen;
  EXPECT_FALSE(screen.Believes(Swinging(0), 0));
  for (int tick = 1; tick < 4000; ++tick)
  {
    FalconNumbers counts = Swinging(tick);
    const bool isWrong = tick % 3 == 0;
    if (isWrong)
    {
      // A bit of one of the three upper nibbles: at least 16 counts. Deviations of twelve pass, and
      // the line is off by up to one count of acceleration and one of rounding.
      std::int16_t& count = counts[random() % 3];
      count = static_cast<std::int16_t>(count ^ (1 << (4 + random() % 12)));
    }
    ASSERT_EQ(screen.Believes(counts, tick * Period), !isWrong) << tick;
  }
}

TEST(EncoderScreen, AcceptsRealJumpOneReplyLate)
{
  EncoderScreen screen;
  EXPECT_FALSE(screen.Believes({0, 0, 0}, 0));
  EXPECT_TRUE(screen.Believes({0, 0, 0}, Period));
  EXPECT_FALSE(screen.Believes({5000, -300, 40}, 2 * Period));
  EXPECT_TRUE(screen.Believes({5000, -300, 40}, 3 * Period));
  EXPECT_TRUE(screen.Believes({5001, -301, 40}, 4 * Period));
}

TEST(EncoderScreen, AcceptsWrappedCounters)
{
  EncoderScreen screen;
  EXPECT_FALSE(screen.Believes({32760, -32760, 0}, 0));
  EXPECT_TRUE(screen.Believes({32766, -32766, 0}, Period));
  EXPECT_TRUE(screen.Believes({-32764, 32764, 0}, 2 * Period));
}
} // namespace
} // namespace palpate::encoder_screen_test
