#include "QuietStandardStreams.h"

#include <cstdio>
#include <gtest/gtest.h>
#include <iostream>

namespace palpate::quiet_standard_streams_test
{
namespace
{
TEST(QuietStandardStreams, MutesOnlyDuringLifetime)
{
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  std::cout << "a";
  std::cerr << "b";
  {
    const QuietStandardStreams outer;
    const QuietStandardStreams inner;
    std::cout << "lost";
    std::cerr << "lost";
    std::printf("lost");
  }
  std::cout << "c";
  std::fprintf(stderr, "d");
  std::fflush(stdout);
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "ac");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "bd");
}
} // namespace
} // namespace palpate::quiet_standard_streams_test
