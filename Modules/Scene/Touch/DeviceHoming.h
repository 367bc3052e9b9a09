#pragma once

#include "DeviceSample.h"
#include "DeviceState.h"
#include "HapticDevice.h"
#include "PalpateSceneModule.h"
#include "PeriodStatistics.h"

#include <functional>
#include <string>

namespace palpate
{
/// State of a device during homing, about twenty times a second.
struct HomingView
{
  DeviceState State = DeviceState::Closed;
  std::string Guidance; ///< what the user should do now; may be empty
  DeviceSample Sample;  ///< newest sample
  double Seconds = 0.0; ///< since the loop started
  double Rate = 0.0;    ///< Hz, mean rate of new samples so far
};

/// Result of homing.
struct HomingReport
{
  DeviceState State = DeviceState::Closed; ///< Ready if it is homed
  std::string Problem;                     ///< message if State is Error
  double Seconds = 0.0;                    ///< duration of the loop
  double HomedAfter = 0.0;                 ///< s; 0 if it is not homed
  std::uint64_t Ticks = 0;
  PeriodStatistics Periods;     ///< from one new sample to the next
  std::string ConnectionReport; ///< as reported by the device
  std::string ThreadAdvice;     ///< why the requested thread priority was not granted
};

/// Reads samples from an open device at its own rate, without force, until it is homed and
/// `leastSeconds` have passed, it fails, or `show` returns false. The loop has its own thread;
/// `show` is called on the caller's.
PALPATESCENE_EXPORT HomingReport HomeDevice(HapticDevice& device, double leastSeconds,
                                            const std::function<bool(const HomingView&)>& show);

/// Makes, opens, homes and closes the device with this name. Throws InputError for an unknown kind
/// of device, std::runtime_error if it cannot be opened.
PALPATESCENE_EXPORT HomingReport HomeDevice(const std::string& name, double leastSeconds,
                                            const std::function<bool(const HomingView&)>& show);
} // namespace palpate
