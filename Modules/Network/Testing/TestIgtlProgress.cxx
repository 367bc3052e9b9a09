#include "IgtlProgress.h"

#include <gtest/gtest.h>

namespace palpate::igtl_progress_test
{
namespace
{
TEST(IgtlProgress, PeerThatConfirmsInTimeIsNotBehind)
{
  IgtlProgress progress(10);
  for (std::int64_t now = 0; now < 1000; ++now)
  {
    progress.Update(now % 9 * 4, now);
    EXPECT_FALSE(progress.IsBehind()) << now;
    progress.Sent(4, now);
  }
}

TEST(IgtlProgress, PeerIsBehindUntilItConfirmsWhatWasSentLaterInTime)
{
  IgtlProgress progress(10);
  progress.Sent(3, 0);
  progress.Update(3, 10);
  EXPECT_FALSE(progress.IsBehind());
  progress.Update(1, 11);
  EXPECT_TRUE(progress.IsBehind()) << "a part is not enough";
  progress.Update(0, 12);
  EXPECT_TRUE(progress.IsBehind()) << "it came too late";
  progress.Sent(2, 20);
  progress.Update(2, 29);
  EXPECT_TRUE(progress.IsBehind());
  progress.Update(0, 30);
  EXPECT_FALSE(progress.IsBehind());
}

TEST(IgtlProgress, NothingSentIsNeverLate)
{
  IgtlProgress progress(10);
  progress.Update(0, 1000);
  EXPECT_FALSE(progress.IsBehind());
}
} // namespace
} // namespace palpate::igtl_progress_test
