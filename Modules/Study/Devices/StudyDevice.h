#pragma once

#include "Clock.h"
#include "HapticDevice.h"
#include "PalpateStudyModule.h"
#include "StudyJobs.h"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace palpate
{
/// Opens the device of a touch in the background, and opens it again after it was lost. Owner
/// thread only; nothing waits.
class PALPATESTUDY_EXPORT StudyDevice
{
public:
  /// Gets an open device, or null and why.
  using Outcome =
      std::function<void(std::unique_ptr<HapticDevice> device, const std::string& problem)>;

  /// Keeps the addresses, and calls `outcome` from StudyJobs::Deliver.
  StudyDevice(Clock& clock, StudyJobs& jobs, Outcome outcome);

  /// By its name in DeviceRegistry; one that is heard sounds too (SoundingDevice).
  void Open(const std::string& name, bool isHeard);
  /// After the open device was closed because it failed: it is tried again about once a second,
  /// until it opens or Cancel.
  void Await(const std::string& problem);
  /// It is in use again.
  void Found() { this->IsLost = false; }
  /// Call regularly.
  void TryAgain();
  void Cancel();

  /// Of the last Open or Await; empty after Cancel.
  const std::string& Name() const { return this->Wanted; }
  /// Whether it is being opened for the first time.
  bool IsOpening() const { return this->Job.has_value() && !this->IsLost; }
  /// Whether it was lost and is not back.
  bool IsAwaited() const { return this->IsLost; }
  /// Why it was lost, and that it is awaited; one line, empty if it is not.
  std::string Notice() const;

private:
  void Start();

  Clock& Time;
  StudyJobs& Jobs;
  Outcome Done;
  std::string Wanted;
  bool IsHeard = false;
  bool IsLost = false;
  std::string Loss;
  std::optional<StudyJobs::Id> Job;
  std::chrono::steady_clock::time_point Tried;
};
} // namespace palpate
