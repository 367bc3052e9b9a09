#include "HomingWatch.h"

#include <gtest/gtest.h>

namespace palpate::homing_watch_test
{
namespace
{
using Verdict = HomingWatch::Verdict;

Verdict After(HomingWatch& watch, unsigned homedBits, int replies)
{
  Verdict verdict = Verdict::Waiting;
  for (int n = 0; n < replies; ++n)
  {
    verdict = watch.Take(homedBits);
  }
  return verdict;
}

TEST(HomingWatch, HomedAfterTwentyRepliesOfAllLegs)
{
  HomingWatch watch;
  for (unsigned bits = 0; bits < FalconReply::AllHomed; ++bits)
  {
    EXPECT_EQ(After(watch, bits, 100), Verdict::Waiting) << bits;
  }
  EXPECT_EQ(After(watch, 7, 19), Verdict::Waiting);
  EXPECT_EQ(After(watch, 7, 1), Verdict::Homed);
}

TEST(HomingWatch, WrongReplyRestartsSettling)
{
  HomingWatch watch;
  EXPECT_EQ(After(watch, 7, 15), Verdict::Waiting);
  EXPECT_EQ(After(watch, 3, 1), Verdict::Waiting);
  EXPECT_EQ(After(watch, 7, 19), Verdict::Waiting);
  EXPECT_EQ(After(watch, 7, 1), Verdict::Homed);
}

TEST(HomingWatch, LosesHomingAfterThreeWrongReplies)
{
  HomingWatch watch;
  EXPECT_EQ(After(watch, 7, 20), Verdict::Homed);
  EXPECT_EQ(After(watch, 0, 2), Verdict::Homed);
  EXPECT_EQ(After(watch, 7, 1), Verdict::Homed);
  EXPECT_EQ(After(watch, 6, 2), Verdict::Homed);
  EXPECT_EQ(After(watch, 6, 1), Verdict::Lost);
}
} // namespace
} // namespace palpate::homing_watch_test
