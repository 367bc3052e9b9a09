#include "RealtimeThread.h"

#include <gtest/gtest.h>

#include <atomic>

#include <pthread.h>

namespace palpate::realtime_thread_test
{
namespace
{
TEST(RealtimeThread, ReportsGrantedPriority)
{
  int policy = -1;
  sched_param parameters{};
  RealtimeThread thread;
  RealtimeRequest request;
  request.Priority = 1;
  const Status status =
      thread.Start(request, [&] { pthread_getschedparam(pthread_self(), &policy, &parameters); });
  ASSERT_TRUE(status.IsOk()) << status.Message();
  thread.Join();
  EXPECT_EQ(thread.Grant().HasPriority, policy == SCHED_FIFO && parameters.sched_priority == 1);
  EXPECT_EQ(thread.Grant().HasPriority, thread.Grant().Advice.empty());
}

TEST(RealtimeThread, RunsAndExplainsInvalidPriority)
{
  std::atomic<bool> hasRun{false};
  RealtimeThread thread;
  RealtimeRequest request;
  request.Priority = 1000;
  ASSERT_TRUE(thread.Start(request, [&] { hasRun = true; }).IsOk());
  thread.Join();
  EXPECT_TRUE(hasRun);
  EXPECT_FALSE(thread.Grant().HasPriority);
  EXPECT_NE(thread.Grant().Advice.find("1000 was refused"), std::string::npos);
}

TEST(RealtimeThread, RequestsNothingUnasked)
{
  RealtimeThread thread;
  RealtimeRequest request;
  request.Priority = 0;
  ASSERT_TRUE(thread.Start(request, [] {}).IsOk());
  EXPECT_FALSE(thread.Grant().HasPriority);
  EXPECT_TRUE(thread.Grant().Advice.empty());
}

TEST(RealtimeThread, RejectsStartUntilJoined)
{
  std::atomic<bool> isStopped{false};
  RealtimeThread thread;
  RealtimeRequest request;
  request.Priority = 0; // it spins
  ASSERT_TRUE(thread
                  .Start(request,
                         [&]
                         {
                           while (!isStopped)
                           {
                             std::this_thread::yield();
                           }
                         })
                  .IsOk());
  EXPECT_FALSE(thread.Start(request, [] {}).IsOk());
  isStopped = true;
  thread.Join();
  EXPECT_TRUE(thread.Start(request, [] {}).IsOk());
}

TEST(RealtimeThread, DestructorWaitsForBody)
{
  std::atomic<int> steps{0};
  {
    RealtimeThread thread;
    ASSERT_TRUE(thread
                    .Start({},
                           [&]
                           {
                             for (int i = 0; i < 100; ++i)
                             {
                               std::this_thread::yield();
                               ++steps;
                             }
                           })
                    .IsOk());
  }
  EXPECT_EQ(steps, 100);
}
} // namespace
} // namespace palpate::realtime_thread_test
