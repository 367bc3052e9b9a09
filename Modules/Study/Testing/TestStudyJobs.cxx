#include "StudyJobs.h"

#include "Progress.h"

#include <atomic>
#include <chrono>
#include <future>
#include <gtest/gtest.h>
#include <memory>
#include <new>
#include <stdexcept>
#include <thread>
#include <vector>

namespace palpate::study_jobs_test
{
namespace
{
StudyJob Delivering(std::function<void()> delivery)
{
  StudyJob job;
  job.Work = [delivery = std::move(delivery)](const ProgressFunction&) { return delivery; };
  return job;
}

void DeliverAll(StudyJobs& jobs)
{
  while (jobs.WaitForResult())
  {
    jobs.Deliver();
  }
}

// Runs until it is cancelled, and signals its start.
struct Endless
{
  std::promise<void> Begun;
  std::shared_ptr<std::atomic<bool>> HasEnded = std::make_shared<std::atomic<bool>>(false);

  StudyJob Job()
  {
    StudyJob job;
    job.Work = [this,
                ended = this->HasEnded](const ProgressFunction& progress) -> StudyJob::Delivery
    {
      this->Begun.set_value();
      while (progress(0.5, "endless"))
      {
        std::this_thread::yield();
      }
      *ended = true;
      throw Cancelled();
    };
    return job;
  }
};

TEST(StudyJobs, DeliversOnTheCallersThreadInStartOrder)
{
  StudyJobs jobs;
  std::vector<int> delivered;
  const auto owner = std::this_thread::get_id();
  for (int n = 0; n < 20; ++n)
  {
    jobs.Start(Delivering(
        [&delivered, n, owner]
        {
          EXPECT_EQ(std::this_thread::get_id(), owner);
          delivered.push_back(n);
        }));
  }
  DeliverAll(jobs);
  ASSERT_EQ(delivered.size(), 20U);
  for (int n = 0; n < 20; ++n)
  {
    EXPECT_EQ(delivered[static_cast<std::size_t>(n)], n);
  }
  EXPECT_FALSE(jobs.WaitForResult()) << "no job is left";
}

TEST(StudyJobs, UrgentJobsRunFirst)
{
  StudyJobs jobs;
  Endless endless;
  const StudyJobs::Id running = jobs.Start(endless.Job());
  endless.Begun.get_future().wait();
  std::string order;
  jobs.Start(Delivering([&] { order += "waiting"; }));
  StudyJob urgent = Delivering([&] { order += "urgent "; });
  urgent.IsUrgent = true;
  jobs.Start(std::move(urgent));
  jobs.Cancel(running);
  DeliverAll(jobs);
  EXPECT_EQ(order, "urgent waiting");
}

TEST(StudyJobs, DeliveryMayStartJobs)
{
  StudyJobs jobs;
  int count = 0;
  std::function<void()> again = [&]
  {
    if (++count < 5)
    {
      jobs.Start(Delivering(again));
    }
  };
  jobs.Start(Delivering(again));
  DeliverAll(jobs);
  EXPECT_EQ(count, 5);
}

TEST(StudyJobs, ReportsExceptionsAsMessages)
{
  StudyJobs jobs;
  std::vector<std::string> messages;
  const auto start = [&](std::function<StudyJob::Delivery(const ProgressFunction&)> work)
  {
    jobs.Start({std::move(work), [&](const std::string& message) { messages.push_back(message); }});
  };
  start([](const ProgressFunction&) -> StudyJob::Delivery
        { throw std::runtime_error("mask.nii.gz is missing"); });
  start([](const ProgressFunction&) -> StudyJob::Delivery { throw std::bad_alloc(); });
  start([](const ProgressFunction&) -> StudyJob::Delivery
        { throw std::out_of_range("vector::_M_range_check"); });
  DeliverAll(jobs);
  ASSERT_EQ(messages.size(), 3U);
  EXPECT_EQ(messages[0], "mask.nii.gz is missing");
  EXPECT_NE(messages[1].find("memory"), std::string::npos);
  EXPECT_EQ(messages[2].find("vector"), std::string::npos) << "text of a library";
}

TEST(StudyJobs, CancelledJobStopsAndDeliversNothing)
{
  StudyJobs jobs;
  Endless endless;
  const StudyJobs::Id id = jobs.Start(endless.Job());
  endless.Begun.get_future().wait();
  ASSERT_TRUE(jobs.ProgressOf(id).has_value());
  EXPECT_TRUE(jobs.ProgressOf(id)->IsRunning);
  jobs.Cancel(id);
  EXPECT_FALSE(jobs.ProgressOf(id).has_value());
  bool isDelivered = false;
  jobs.Start(Delivering([&] { isDelivered = true; }));
  DeliverAll(jobs);
  EXPECT_TRUE(*endless.HasEnded) << "its worker is free for the next job";
  EXPECT_TRUE(isDelivered);
}

TEST(StudyJobs, WaitingAndFinishedJobsCanBeCancelled)
{
  StudyJobs jobs;
  int delivered = 0;
  const StudyJobs::Id done = jobs.Start(Delivering([&] { ++delivered; }));
  ASSERT_TRUE(jobs.WaitForResult());
  Endless endless;
  const StudyJobs::Id running = jobs.Start(endless.Job());
  endless.Begun.get_future().wait();
  const StudyJobs::Id waiting = jobs.Start(Delivering([&] { ++delivered; }));
  EXPECT_FALSE(jobs.ProgressOf(waiting)->IsRunning);
  for (const StudyJobs::Id id : {done, waiting, running})
  {
    jobs.Cancel(id);
  }
  DeliverAll(jobs);
  EXPECT_EQ(delivered, 0);
}

TEST(StudyJobs, EndCancelsRunningJobs)
{
  Endless endless;
  StudyJobs jobs;
  jobs.Start(endless.Job());
  endless.Begun.get_future().wait();
  EXPECT_TRUE(jobs.End(std::chrono::minutes(1)));
  EXPECT_TRUE(*endless.HasEnded);
  EXPECT_EQ(jobs.Deliver(), 0U);
  bool isDelivered = false;
  jobs.Start(Delivering([&] { isDelivered = true; }));
  EXPECT_FALSE(jobs.WaitForResult());
  EXPECT_FALSE(isDelivered);
}

// A job that never checks for cancellation keeps running, with the data that it needs.
TEST(StudyJobs, UnresponsiveJobDoesNotDelayEnd)
{
  const auto release = std::make_shared<std::promise<void>>();
  const auto ended = std::make_shared<std::promise<void>>();
  std::promise<void> begun;
  {
    StudyJobs jobs;
    StudyJob job;
    job.Work = [release, ended, &begun](const ProgressFunction& progress) -> StudyJob::Delivery
    {
      begun.set_value();
      release->get_future().wait();
      EXPECT_FALSE(progress(1.0, "deaf"));
      ended->set_value();
      return {};
    };
    jobs.Start(std::move(job));
    begun.get_future().wait();
    EXPECT_FALSE(jobs.End(std::chrono::milliseconds(1)));
  }
  release->set_value();
  ended->get_future().wait();
}

TEST(StudyJobs, SeveralWorkersRunEachJobOnce)
{
  StudyJobs jobs(4);
  std::atomic<int> worked{0};
  int delivered = 0;
  for (int n = 0; n < 200; ++n)
  {
    StudyJob job;
    job.Work = [&](const ProgressFunction& progress)
    {
      progress(0.5, "work");
      ++worked;
      return StudyJob::Delivery([&] { ++delivered; });
    };
    jobs.Start(std::move(job));
  }
  DeliverAll(jobs);
  EXPECT_EQ(worked, 200);
  EXPECT_EQ(delivered, 200);
}
} // namespace
} // namespace palpate::study_jobs_test
