#include "Interruption.h"

#include "EmergencyStop.h"
#include "EndBeforeExit.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <memory>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

namespace palpate::interruption_test
{
namespace
{
TEST(Interruption, EachSignalRequestsTheEndWithItsCode)
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

TEST(Interruption, SecondRequestStopsForces)
{
  {
    const Interruption interruption;
    std::raise(SIGPIPE);
    std::raise(SIGTERM);
    EXPECT_FALSE(EmergencyStop::IsOrdered());
    std::raise(SIGINT);
    EXPECT_TRUE(EmergencyStop::IsOrdered());
    const Interruption another;
    EXPECT_FALSE(EmergencyStop::IsOrdered());
    std::raise(SIGTERM);
    std::raise(SIGHUP);
  }
  EXPECT_FALSE(EmergencyStop::IsOrdered());
}

TEST(Interruption, RepeatedWritesToAClosedPipeOnlyRequestTheEnd)
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

TEST(InterruptionDeathTest, FourSignalsDoNotEndItWhileADevicePushes)
{
  EXPECT_EXIT(
      {
        const Interruption interruption;
        const EndBeforeExit end([] { std::fputs("0 N", stderr); });
        for (int n = 0; n < 4; ++n)
        {
          std::raise(SIGINT);
        }
        std::exit(Interruption::ExitCode());
      },
      testing::ExitedWithCode(130), "0 N");
}

// If the thread that would end it hangs.
TEST(InterruptionDeathTest, TheFifthSignalEndsItEvenWhileADevicePushes)
{
  EXPECT_EXIT(
      {
        const Interruption interruption;
        const EndBeforeExit end([] { std::fputs("0 N", stderr); });
        for (int n = 0; n < 5; ++n)
        {
          std::fprintf(stderr, "%d", n);
          std::raise(n == 4 ? SIGTERM : SIGINT);
        }
        std::exit(Interruption::ExitCode());
      },
      testing::ExitedWithCode(143), "^01234$");
}

class InterruptionByTerminal : public testing::TestWithParam<int>
{
};

TEST_P(InterruptionByTerminal, StopsTheProgramUnlessADevicePushes)
{
  for (const bool pushes : {false, true})
  {
    const pid_t child = fork();
    if (child == 0)
    {
      const Interruption interruption;
      const auto end = pushes ? std::make_unique<EndBeforeExit>([] {}) : nullptr;
      std::raise(GetParam());
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

INSTANTIATE_TEST_SUITE_P(All, InterruptionByTerminal, testing::Values(SIGTSTP, SIGTTIN, SIGTTOU),
                         [](const auto& chosen)
                         { return std::string("Signal") + std::to_string(chosen.param); });

// ThreadSanitizer runs a handler only after the system call, and the terminal repeats the call
// until the handler has run.
#ifndef __SANITIZE_THREAD__
// Exit status of a program in the background of a terminal to which it may not write, while a
// device pushes.
template <typename Program>
int InBackground(const Program& runs)
{
  const int master = posix_openpt(O_RDWR | O_NOCTTY);
  EXPECT_EQ(grantpt(master), 0);
  EXPECT_EQ(unlockpt(master), 0);
  const pid_t shell = fork();
  if (shell == 0)
  {
    setsid();
    const int terminal = open(ptsname(master), O_RDWR); // now its controlling terminal
    termios settings = {};
    tcgetattr(terminal, &settings);
    settings.c_lflag |= TOSTOP;
    tcsetattr(terminal, TCSANOW, &settings);
    const pid_t job = fork();
    if (job == 0)
    {
      setpgid(0, 0);
      alarm(60); // ends a program that retries forever
      const Interruption interruption;
      const EndBeforeExit end([] {});
      _exit(runs(terminal));
    }
    int status = 0;
    waitpid(job, &status, 0);
    _exit(WIFEXITED(status) ? WEXITSTATUS(status) : 1);
  }
  int status = 0;
  EXPECT_EQ(waitpid(shell, &status, 0), shell);
  close(master);
  return WEXITSTATUS(status);
}

TEST(Interruption, BackgroundWritesSucceedWhileADevicePushes)
{
  EXPECT_EQ(InBackground([](int terminal) { return write(terminal, "x", 1) == 1 ? 7 : 1; }), 7);
}

TEST(Interruption, BackgroundReadsFailWhileADevicePushes)
{
  EXPECT_EQ(InBackground(
                [](int terminal)
                {
                  char letter = 0;
                  return read(terminal, &letter, 1) == -1 && errno == EIO ? 7 : 1;
                }),
            7);
}
#endif

TEST(InterruptionDeathTest, RestoresSignalHandlers)
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
} // namespace palpate::interruption_test
