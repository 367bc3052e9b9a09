#pragma once

#include "DeviceSample.h"
#include "DeviceState.h"
#include "LatestValue.h"

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>

namespace palpate
{
/// What the servo's thread and that of the connection hand each other.
struct Inverse3Exchange
{
  struct Command
  {
    PlainVector3 Force;       ///< N
    std::uint64_t Number = 0; ///< of the call of Apply; 0: none yet
    std::int64_t Time = 0;    ///< ns
  };

  LatestValue<DeviceSample> Newest; ///< to the servo
  LatestValue<Command> Wanted;      ///< from the servo
  std::atomic<DeviceState> Life{DeviceState::Closed};
  std::atomic<bool> IsBehind{false};         ///< a reply is overdue
  std::atomic<std::int64_t> LongestReply{0}; ///< ns
  std::atomic<std::int64_t> SumOfReplies{0}; ///< ns
  std::atomic<std::uint64_t> Replies{0};
  std::atomic<double> LargestDifference{0.0}; ///< N, of the displayed force from the one sent

  /// Of an Error, for the owner's thread.
  std::string Problem() const
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    return this->Reason;
  }
  void SetProblem(const std::string& reason)
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Reason = reason;
  }

private:
  mutable std::mutex Guard; // never the servo's thread
  std::string Reason;
};
} // namespace palpate
