#include "RealtimeLimit.h"

#include "RealtimeThread.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>

#include <csignal>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

// The limit is a property of the process, so each test runs in a child process.
namespace palpate::realtime_limit_test
{
namespace
{
rlimit LimitNow()
{
  rlimit limit{};
  EXPECT_EQ(getrlimit(RLIMIT_RTTIME, &limit), 0);
  return limit;
}

bool IsDefault(int signal)
{
  struct sigaction action = {};
  return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_DFL;
}

// Exit code of `body` in a child process; -1 if a signal ended it.
template <typename Body>
int InChild(Body body)
{
  const pid_t child = fork();
  if (child == 0)
  {
    _exit(body());
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(RealtimeLimit, SetOnlyWithGrantedPriority)
{
  EXPECT_EQ(InChild(
                []
                {
                  const rlim_t before = LimitNow().rlim_cur;
                  rlim_t within = 0;
                  RealtimeThread thread;
                  RealtimeRequest request;
                  request.Priority = 1;
                  const bool isStarted =
                      thread.Start(request, [&] { within = LimitNow().rlim_cur; }).IsOk();
                  thread.Join();
                  const rlim_t wanted = thread.Grant().HasPriority
                                            ? std::min<rlim_t>(before, RealtimeLimit::LongestRun)
                                            : before;
                  const bool isHandled = !IsDefault(SIGXCPU);
                  return isStarted && within == wanted && LimitNow().rlim_cur == wanted &&
                                 isHandled == thread.Grant().HasPriority
                             ? 0
                             : 1;
                }),
            0);
}

TEST(RealtimeLimit, RefusedPriorityChangesNothing)
{
  EXPECT_EQ(InChild(
                []
                {
                  const rlimit before = LimitNow();
                  RealtimeThread thread;
                  RealtimeRequest request;
                  request.Priority = 1000; // does not exist
                  const bool isStarted = thread.Start(request, [] {}).IsOk();
                  thread.Join();
                  const rlimit after = LimitNow();
                  return isStarted && after.rlim_cur == before.rlim_cur &&
                                 after.rlim_max == before.rlim_max && IsDefault(SIGXCPU)
                             ? 0
                             : 1;
                }),
            0);
}

TEST(RealtimeLimit, KeepsLowerLimit)
{
  EXPECT_EQ(InChild(
                []
                {
                  rlimit lower = LimitNow();
                  lower.rlim_cur = 50'000;
                  setrlimit(RLIMIT_RTTIME, &lower);
                  RealtimeLimit limit;
                  limit.Keep();
                  return LimitNow().rlim_cur == 50'000 ? 0 : 1;
                }),
            0);
}

TEST(RealtimeLimit, KeepsExistingHandler)
{
  EXPECT_EQ(InChild(
                []
                {
                  std::signal(SIGXCPU, SIG_IGN);
                  RealtimeLimit limit;
                  limit.Keep();
                  struct sigaction action = {};
                  sigaction(SIGXCPU, nullptr, &action);
                  return action.sa_handler == SIG_IGN ? 0 : 1;
                }),
            0);
}

// Where no priority is granted the thread never was real-time; either way it ends as an ordinary
// one. Without the limit it would spin until the deadline, without the handler SIGXCPU would end
// the process.
TEST(RealtimeLimit, SpinningThreadLosesOnlyItsPriority)
{
  EXPECT_EQ(InChild(
                []
                {
                  std::atomic<int> policy{-1};
                  RealtimeThread thread;
                  RealtimeRequest request;
                  request.Priority = 1;
                  const bool isStarted =
                      thread
                          .Start(request,
                                 [&]
                                 {
                                   const auto end =
                                       std::chrono::steady_clock::now() + std::chrono::seconds(10);
                                   do
                                   {
                                     policy =
                                         sched_getscheduler(0); // pthread returns a cached value
                                   } while (policy != SCHED_OTHER &&
                                            std::chrono::steady_clock::now() < end);
                                 })
                          .IsOk();
                  thread.Join();
                  return isStarted && policy == SCHED_OTHER ? 0 : 1;
                }),
            0);
}
} // namespace
} // namespace palpate::realtime_limit_test
