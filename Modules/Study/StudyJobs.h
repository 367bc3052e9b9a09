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
/// A piece of long work.
struct StudyJob
{
  /// What is to be done with a result, on the owner's thread.
  using Delivery = std::function<void()>;

  /// On a worker thread. Throws Cancelled where `progress` answers false; anything else that it
  /// throws has a sentence for the user.
  std::function<Delivery(const ProgressFunction& progress)> Work;
  /// On the owner's thread, where Work threw.
  std::function<void(const std::string& sentence)> Fail;
  /// Goes before all that only waits.
  bool IsUrgent = false;
};

/// How far a job has come.
struct StudyJobProgress
{
  bool IsRunning = false; ///< else it waits for its turn
  double Fraction = 0.0;
  std::string Stage;
};

/// Runs long work beside the thread that owns it, in the order of being started, what is urgent
/// first. The owner's thread
/// never waits: it asks now and then (Deliver), and whatever a result does to it happens there.
class PALPATESTUDY_EXPORT StudyJobs
{
public:
  using Id = std::uint64_t;

  /// One worker by default: of two cores the other belongs to the views and the servo.
  explicit StudyJobs(int workers = 1);
  StudyJobs(const StudyJobs&) = delete;
  StudyJobs& operator=(const StudyJobs&) = delete;
  /// Ends within a second, whatever the work does (see End).
  ~StudyJobs();

  Id Start(StudyJob job);
  /// Nothing of it is delivered any more. It may still run until it asks.
  void Cancel(Id id);
  /// None for what has ended, was cancelled or never was.
  std::optional<StudyJobProgress> ProgressOf(Id id) const;

  /// Does what results that have come since ask for; returns how many.
  std::size_t Deliver();
  /// Nothing waits, runs, or is to be delivered.
  bool IsIdle() const;
  /// Waits until there is something to deliver, `longest` at most; false where there is nothing. At
  /// once where nothing is on its way. For programs without a window, and tests.
  bool WaitForResult(std::optional<std::chrono::milliseconds> longest = std::nullopt);

  /// Cancels everything and waits for it to end, `longest` at most. False where something does not
  /// ask whether it is wanted any more: it goes on by itself, with what it has, until its end or
  /// the program's. Nothing is delivered or started after this.
  bool End(std::chrono::milliseconds longest);

private:
  struct Desk;
  std::shared_ptr<Desk> Shared; ///< with the workers, which may outlive this
  std::vector<std::thread> Threads;
};
} // namespace palpate
