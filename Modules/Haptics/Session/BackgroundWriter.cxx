#include "BackgroundWriter.h"

#include <condition_variable>
#include <mutex>
#include <utility>

namespace palpate
{
struct BackgroundWriter::Shared
{
  void Run();
  bool WriteNext(std::string& bytes, Status& status);

  Target To;
  Limits Bounds;
  std::mutex Lock;
  std::condition_variable Changed;
  std::string Waiting;
  std::uint64_t Written = 0;
  Status Outcome = Status::Success();
  bool IsEnding = false;
  bool HasEnded = false;
};

// Body of the thread.
void BackgroundWriter::Shared::Run()
{
  auto synced = std::chrono::steady_clock::now();
  std::unique_lock<std::mutex> lock(this->Lock);
  while (this->Outcome.IsOk() && !(this->IsEnding && this->Waiting.empty()))
  {
    this->Changed.wait(lock, [this] { return this->IsEnding || !this->Waiting.empty(); });
    const std::string bytes = std::exchange(this->Waiting, {});
    lock.unlock();
    const Status status = bytes.empty() ? Status::Success() : this->To.Write(bytes);
    if (const auto now = std::chrono::steady_clock::now();
        status.IsOk() && now - synced >= this->Bounds.SyncInterval)
    {
      this->To.Sync();
      synced = now;
    }
    lock.lock();
    this->Written += status.IsOk() ? bytes.size() : 0;
    this->Outcome = status;
    this->Changed.notify_all();
  }
  const bool isWhole = this->Outcome.IsOk();
  lock.unlock();
  if (isWhole)
  {
    this->To.Sync();
  }
  lock.lock();
  this->HasEnded = true;
  this->Changed.notify_all();
}

BackgroundWriter::BackgroundWriter(Target target, Limits limits) : State(std::make_shared<Shared>())
{
  this->State->To = std::move(target);
  this->State->Bounds = limits;
  this->Thread = std::thread([state = this->State] { state->Run(); });
}

BackgroundWriter::~BackgroundWriter()
{
  static_cast<void>(this->Finish());
}

// Waits until a condition is met, as long as the thread makes progress.
template <typename Condition>
bool BackgroundWriter::WaitFor(std::unique_lock<std::mutex>& lock,
                               std::chrono::milliseconds patience, Condition isMet)
{
  const Shared& state = *this->State;
  bool hasProgress = true;
  while (!isMet() && hasProgress)
  {
    const std::uint64_t before = state.Written;
    this->State->Changed.wait_for(lock, patience,
                                  [&] { return isMet() || state.Written != before; });
    hasProgress = isMet() || state.Written != before;
  }
  return hasProgress;
}

Status BackgroundWriter::Stall()
{
  this->IsStalled = true;
  this->State->IsEnding = true;
  this->State->Waiting.clear();
  if (this->Thread.joinable())
  {
    this->Thread.detach();
  }
  return Status::Failure("the disk has stalled");
}

Status BackgroundWriter::Append(std::string_view bytes)
{
  Shared& state = *this->State;
  std::unique_lock<std::mutex> lock(state.Lock);
  const auto hasRoom = [&]
  { return !state.Outcome.IsOk() || state.Waiting.size() < state.Bounds.MostWaiting; };
  if (this->IsStalled || !this->WaitFor(lock, state.Bounds.Patience, hasRoom))
  {
    return this->Stall();
  }
  state.Waiting.append(bytes);
  state.Changed.notify_all();
  return state.Outcome;
}

Status BackgroundWriter::Finish()
{
  Shared& state = *this->State;
  {
    std::unique_lock<std::mutex> lock(state.Lock);
    state.IsEnding = true;
    state.Changed.notify_all();
    if (this->IsStalled ||
        !this->WaitFor(lock, state.Bounds.EndPatience, [&] { return state.HasEnded; }))
    {
      return this->Stall();
    }
  }
  if (this->Thread.joinable())
  {
    this->Thread.join();
  }
  return state.Outcome;
}

std::uint64_t BackgroundWriter::WrittenBytes() const
{
  const std::lock_guard<std::mutex> lock(this->State->Lock);
  return this->State->Written;
}
} // namespace palpate
