#include "StudyJobs.h"

#include "ExceptionMessage.h"
#include "Progress.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <utility>

namespace palpate
{
// Shared by owner and workers.
struct StudyJobs::Desk
{
  struct Entry
  {
    Id Number = 0;
    StudyJob Job;
    std::atomic<bool> IsCancelled{false};
    // Guarded by the desk's lock.
    StudyJobProgress Progress;
    StudyJob::Delivery Delivery; ///< after it has ended
  };
  using EntryPointer = std::shared_ptr<Entry>;

  std::mutex Lock;
  std::condition_variable News; ///< a job was started, has ended, or was cancelled
  std::deque<EntryPointer> Waiting;
  std::deque<EntryPointer> Running;
  std::deque<EntryPointer> Done;
  Id LastId = 0;
  int Workers = 0; ///< running threads
  bool IsEnding = false;

  EntryPointer Take();
  StudyJob::Delivery Do(Entry& entry);
  void Work();
  void Drop(Id id);
  bool HasWork() const;
  static StudyJob::Delivery FailWith(const Entry& entry, const std::string& message);
};

StudyJob::Delivery StudyJobs::Desk::FailWith(const Entry& entry, const std::string& message)
{
  return [fail = entry.Job.Fail, message]
  {
    if (fail)
    {
      fail(message);
    }
  };
}

// Waits for a job; null when ending.
StudyJobs::Desk::EntryPointer StudyJobs::Desk::Take()
{
  std::unique_lock<std::mutex> hold(this->Lock);
  this->News.wait(hold, [this] { return this->IsEnding || !this->Waiting.empty(); });
  if (this->IsEnding)
  {
    return nullptr;
  }
  EntryPointer entry = this->Waiting.front();
  this->Waiting.pop_front();
  this->Running.push_back(entry);
  entry->Progress.IsRunning = true;
  return entry;
}

StudyJob::Delivery StudyJobs::Desk::Do(Entry& entry)
{
  const auto progress = [this, &entry](double fraction, const std::string& stage)
  {
    const std::lock_guard<std::mutex> hold(this->Lock);
    entry.Progress.Fraction = fraction;
    entry.Progress.Stage = stage;
    return !entry.IsCancelled;
  };
  try
  {
    return entry.Job.Work(progress);
  }
  catch (const Cancelled& cancelled)
  {
    return FailWith(entry, cancelled.what()); // dropped if the owner cancelled
  }
  catch (const std::exception& error)
  {
    return FailWith(entry, MessageOf(error));
  }
}

void StudyJobs::Desk::Work()
{
  while (EntryPointer entry = this->Take())
  {
    StudyJob::Delivery delivery = this->Do(*entry);
    const std::lock_guard<std::mutex> hold(this->Lock);
    this->Running.erase(std::remove(this->Running.begin(), this->Running.end(), entry),
                        this->Running.end());
    if (!entry->IsCancelled)
    {
      entry->Delivery = std::move(delivery);
      this->Done.push_back(entry);
    }
    this->News.notify_all();
  }
  const std::lock_guard<std::mutex> hold(this->Lock);
  --this->Workers;
  this->News.notify_all();
}

// Call with the lock held.
void StudyJobs::Desk::Drop(Id id)
{
  const auto isIt = [id](const EntryPointer& entry) { return entry->Number == id; };
  for (std::deque<EntryPointer>* entries : {&this->Waiting, &this->Done})
  {
    entries->erase(std::remove_if(entries->begin(), entries->end(), isIt), entries->end());
  }
  for (const EntryPointer& entry : this->Running)
  {
    entry->IsCancelled = entry->IsCancelled || isIt(entry);
  }
  this->News.notify_all();
}

// Call with the lock held: whether a result that is not cancelled is still to come.
bool StudyJobs::Desk::HasWork() const
{
  return !this->Waiting.empty() ||
         std::any_of(this->Running.begin(), this->Running.end(),
                     [](const EntryPointer& entry) { return !entry->IsCancelled; });
}

StudyJobs::StudyJobs(int workers) : Shared(std::make_shared<Desk>())
{
  this->Shared->Workers = workers;
  for (int worker = 0; worker < workers; ++worker)
  {
    this->Threads.emplace_back([desk = this->Shared] { desk->Work(); });
  }
}

StudyJobs::~StudyJobs()
{
  this->End(std::chrono::milliseconds(800));
}

StudyJobs::Id StudyJobs::Start(StudyJob job)
{
  auto entry = std::make_shared<Desk::Entry>();
  entry->Job = std::move(job);
  const std::lock_guard<std::mutex> hold(this->Shared->Lock);
  entry->Number = ++this->Shared->LastId;
  if (!this->Shared->IsEnding)
  {
    std::deque<Desk::EntryPointer>& waiting = this->Shared->Waiting;
    waiting.insert(entry->Job.IsUrgent ? waiting.begin() : waiting.end(), entry);
    this->Shared->News.notify_all();
  }
  return entry->Number;
}

void StudyJobs::Cancel(Id id)
{
  const std::lock_guard<std::mutex> hold(this->Shared->Lock);
  this->Shared->Drop(id);
}

std::optional<StudyJobProgress> StudyJobs::ProgressOf(Id id) const
{
  const std::lock_guard<std::mutex> hold(this->Shared->Lock);
  for (const std::deque<Desk::EntryPointer>* entries :
       {&this->Shared->Running, &this->Shared->Waiting})
  {
    for (const Desk::EntryPointer& entry : *entries)
    {
      if (entry->Number == id && !entry->IsCancelled)
      {
        return entry->Progress;
      }
    }
  }
  return std::nullopt;
}

std::size_t StudyJobs::Deliver()
{
  std::size_t count = 0;
  while (true)
  {
    Desk::EntryPointer entry;
    {
      const std::lock_guard<std::mutex> hold(this->Shared->Lock);
      if (this->Shared->Done.empty())
      {
        return count;
      }
      entry = this->Shared->Done.front();
      this->Shared->Done.pop_front();
    }
    // Unlocked, since a delivery may start more jobs.
    if (entry->Delivery)
    {
      entry->Delivery();
    }
    ++count;
  }
}

bool StudyJobs::IsIdle() const
{
  const std::lock_guard<std::mutex> hold(this->Shared->Lock);
  return this->Shared->Done.empty() && !this->Shared->HasWork();
}

bool StudyJobs::WaitForResult(std::optional<std::chrono::milliseconds> longest)
{
  Desk& desk = *this->Shared;
  std::unique_lock<std::mutex> hold(desk.Lock);
  const auto isOver = [&desk] { return !desk.Done.empty() || !desk.HasWork(); };
  if (longest)
  {
    desk.News.wait_for(hold, *longest, isOver);
  }
  else
  {
    desk.News.wait(hold, isOver);
  }
  return !desk.Done.empty();
}

bool StudyJobs::End(std::chrono::milliseconds longest)
{
  Desk& desk = *this->Shared;
  std::unique_lock<std::mutex> hold(desk.Lock);
  desk.IsEnding = true;
  desk.Waiting.clear();
  desk.Done.clear();
  for (const Desk::EntryPointer& entry : desk.Running)
  {
    entry->IsCancelled = true;
  }
  desk.News.notify_all();
  const auto isEmpty = [&desk] { return desk.Workers == 0; };
  const bool hasEnded =
      this->Threads.empty() ? isEmpty() : desk.News.wait_for(hold, longest, isEmpty);
  hold.unlock();
  for (std::thread& thread : this->Threads)
  {
    // A job that does not end in time must not delay closing the window; it keeps the desk alive.
    hasEnded ? thread.join() : thread.detach();
  }
  this->Threads.clear();
  return hasEnded;
}
} // namespace palpate
