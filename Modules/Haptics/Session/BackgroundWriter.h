#pragma once

#include "Status.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace palpate
{
/// Writes bytes on a thread of its own, so that a slow or stalled disk does not delay the calling
/// thread. For one calling thread.
class BackgroundWriter
{
public:
  struct Target
  {
    /// Writes all bytes. A failure message is a clause and ends the writing.
    std::function<Status(std::string_view)> Write;
    std::function<void()> Sync; ///< waits until written data is on the disk
  };
  struct Limits
  {
    std::size_t MostWaiting = 16U << 20U; ///< bytes not written yet
    /// Time without progress after which the disk counts as stalled, in Append and Finish.
    std::chrono::milliseconds Patience{1000};
    std::chrono::milliseconds EndPatience{10000};
    std::chrono::milliseconds SyncInterval{2000};
  };

  /// Starts the thread. If the disk stalls, `target` is used beyond the writer's lifetime.
  BackgroundWriter(Target target, Limits limits);
  BackgroundWriter(const BackgroundWriter&) = delete;
  BackgroundWriter& operator=(const BackgroundWriter&) = delete;
  /// Same as Finish.
  ~BackgroundWriter();

  /// Passes bytes to the thread. Waits only if too many are waiting. After a failure, whose message
  /// is a clause, nothing more is written.
  Status Append(std::string_view bytes);
  /// Waits until all data is on the disk, or failed; the thread has then ended, unless the disk has
  /// stalled.
  Status Finish();
  bool HasStalled() const noexcept { return this->IsStalled; }
  std::uint64_t WrittenBytes() const;

private:
  struct Shared;

  template <typename Condition>
  bool WaitFor(std::unique_lock<std::mutex>& lock, std::chrono::milliseconds patience,
               Condition isMet);
  Status Stall();

  std::shared_ptr<Shared> State;
  std::thread Thread;
  bool IsStalled = false;
};
} // namespace palpate
