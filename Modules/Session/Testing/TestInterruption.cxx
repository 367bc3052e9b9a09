#include "Interruption.h"

#include "EndBeforeExit.h"

#include <array>
#include <csignal>
#include <cstdlib>
#include <gtest/gtest.h>
#include <memory>
#include <sys/wait.h>
#include <unistd.h>

namespace palpate
{
namespace
{
TEST(Interruption, EachSignalAsksAndHasItsCode)
{
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
  {
    const Interruption interruption;
    EXPECT_FALSE(Interruption::WasAsked());
    EXPECT_EQ(Interruption::ExitCode(), 0);
    std::raise(signal);
    EXPECT_TRUE(Interruption::WasAsked());
    EXPECT_EQ(Interruption::ExitCode(), 128 + signal);
  }
}

TEST(Interruption, TheFirstSignalCounts)
{
  const Interruption interruption;
  std::raise(SIGTERM);
  std::raise(SIGINT);
  EXPECT_EQ(Interruption::ExitCode(), 143);
}

TEST(Interruption, WritingToAPipeThatNobodyReadsAsksHoweverOften)
{
  const Interruption interruption;
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  close(ends[0]);
  for (int n = 0; n < 10; ++n)
  {
    EXPECT_EQ(write(ends[1], "", 1), -1);
  }
  close(ends[1]);
  EXPECT_EQ(Interruption::ExitCode(), 141);
}

TEST(InterruptionDeathTest, TheThirdSignalEndsTheProgram)
{
  EXPECT_EXIT(
      {
        const Interruption interruption;
        std::raise(SIGINT);
        std::raise(SIGTERM);
        std::fputs("still here", stderr);
        std::raise(SIGINT);
        std::exit(0);
      },
      testing::ExitedWithCode(130), "still here");
}

TEST(InterruptionDeathTest, NoNumberOfSignalsEndsItWhileADevicePushes)
{
  EXPECT_EXIT(
      {
        const Interruption interruption;
        const EndBeforeExit end([] { std::fputs("0 N", stderr); });
        for (int n = 0; n < 10; ++n)
        {
          std::raise(SIGINT);
        }
        std::exit(Interruption::ExitCode());
      },
      testing::ExitedWithCode(130), "0 N");
}

TEST(Interruption, CtrlZStopsTheProgramUnlessADevicePushes)
{
  for (const bool pushes : {false, true})
  {
    const pid_t child = fork();
    if (child == 0)
    {
      const Interruption interruption;
      const auto end = pushes ? std::make_unique<EndBeforeExit>([] {}) : nullptr;
      std::raise(SIGTSTP);
      _exit(7);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, WUNTRACED), child);
    EXPECT_EQ(WIFSTOPPED(status), !pushes);
    if (WIFSTOPPED(status))
    {
      kill(child, SIGCONT);
      ASSERT_EQ(waitpid(child, &status, 0), child);
    }
    EXPECT_EQ(WEXITSTATUS(status), 7);
  }
}

TEST(InterruptionDeathTest, AfterItSignalsDoWhatTheyDidBefore)
{
  EXPECT_EXIT(
      {
        {
          const Interruption interruption;
        }
        std::raise(SIGTERM);
      },
      testing::KilledBySignal(SIGTERM), "");
  EXPECT_EXIT(
      {
        std::signal(SIGHUP, SIG_IGN);
        const Interruption interruption;
        std::raise(SIGHUP);
        std::exit(Interruption::ExitCode());
      },
      testing::ExitedWithCode(0), "");
}
} // namespace
} // namespace palpate
