#pragma once

#include "PalpateStudyModule.h"
#include "Progress.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace palpate
{
/// A long-running job.
struct StudyJob
{
  /// Handles the result, on the owner's thread.
  using Delivery = std::function<void()>;

  /// Runs on a worker thread. Throws Cancelled if `progress` returns false; any other exception's
  /// message is shown to the user.
  std::function<Delivery(const ProgressFunction& progress)> Work;
  /// Called on the owner's thread if Work threw.
  std::function<void(const std::string& message)> Fail;
  /// Runs before waiting jobs that are not urgent.
  bool IsUrgent = false;
};

/// Progress of a job.
struct StudyJobProgress
{
  bool IsRunning = false; ///< otherwise waiting
  double Fraction = 0.0;
  std::string Stage;
};

/// Runs long jobs in the background, in order of their start, urgent ones first. The owner's thread
/// never blocks: it calls Deliver regularly, which handles the results.
class PALPATESTUDY_EXPORT StudyJobs
{
public:
  using Id = std::uint64_t;

  /// One worker by default: on two cores the other is for the views and the servo.
  explicit StudyJobs(int workers = 1);
  StudyJobs(const StudyJobs&) = delete;
  StudyJobs& operator=(const StudyJobs&) = delete;
  /// Returns within a second, whatever the jobs do (see End).
  ~StudyJobs();

  Id Start(StudyJob job);
  /// Cancels a job: its result is not delivered. It runs until its next progress call.
  void Cancel(Id id);
  /// None if the job has ended, was cancelled or never existed.
  std::optional<StudyJobProgress> ProgressOf(Id id) const;

  /// Handles the results since the last call; returns their number.
  std::size_t Deliver();
  /// Whether no job is waiting, running, or to be delivered.
  bool IsIdle() const;
  /// Waits for at most `longest` until there is a result to deliver; false if there is none.
  /// Returns immediately if no job is left. For programs without a window, and tests.
  bool WaitForResult(std::optional<std::chrono::milliseconds> longest = std::nullopt);

  /// Cancels all jobs and waits for at most `longest`. Returns false if a job does not respond to
  /// cancellation: it keeps running, with the data it holds, until its end or the program's. No job
  /// is delivered or started after this.
  bool End(std::chrono::milliseconds longest);

private:
  struct Desk;
  std::shared_ptr<Desk> Shared; ///< shared with the workers, which may outlive this object
  std::vector<std::thread> Threads;
};
} // namespace palpate
