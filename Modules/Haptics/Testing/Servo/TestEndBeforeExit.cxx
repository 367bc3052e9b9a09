#include "EndBeforeExit.h"

#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>
#include <memory>

namespace palpate::end_before_exit_test
{
namespace
{
TEST(EndBeforeExitDeathTest, ExitCallsTheNewestFirst)
{
  EXPECT_EXIT(
      {
        const EndBeforeExit outer([] { std::fputs("outer", stderr); });
        const EndBeforeExit inner([] { std::fputs("inner, ", stderr); });
        std::exit(3);
      },
      testing::ExitedWithCode(3), "inner, outer");
}

TEST(EndBeforeExitDeathTest, CallsNothingThatHasEnded)
{
  EXPECT_EXIT(
      {
        auto one = std::make_unique<EndBeforeExit>([] { std::fputs("one", stderr); });
        one.reset();
        std::fputs("none", stderr);
        std::exit(3);
      },
      testing::ExitedWithCode(3), "^none$");
}

TEST(EndBeforeExitDeathTest, FunctionMayEndItselfAndOthers)
{
  EXPECT_EXIT(
      {
        auto other = std::make_unique<EndBeforeExit>([] { std::fputs("other", stderr); });
        std::unique_ptr<EndBeforeExit> one;
        one = std::make_unique<EndBeforeExit>(
            [&]
            {
              one.reset();
              other.reset();
              std::fputs("one", stderr);
            });
        std::exit(3);
      },
      testing::ExitedWithCode(3), "^one$");
}

TEST(EndBeforeExit, IsInForceWhileOneExists)
{
  EXPECT_FALSE(EndBeforeExit::IsInForce());
  {
    const EndBeforeExit one([] {});
    const EndBeforeExit other([] {});
    EXPECT_TRUE(EndBeforeExit::IsInForce());
  }
  EXPECT_FALSE(EndBeforeExit::IsInForce());
}
} // namespace
} // namespace palpate::end_before_exit_test
