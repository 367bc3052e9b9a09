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
/// A device while it is homed, some twenty times a second.
struct HomingView
{
  DeviceState State = DeviceState::Closed;
  std::string Guidance; ///< what the person should do now; empty where nothing
  DeviceSample Sample;  ///< the newest
  double Seconds = 0.0; ///< since the loop started
  double Rate = 0.0;    ///< Hz, new samples so far
};

/// How it went.
struct HomingReport
{
  DeviceState State = DeviceState::Closed; ///< Ready where it is homed
  std::string Problem;                     ///< of an Error
  double Seconds = 0.0;                    ///< that the loop ran
  double HomedAfter = 0.0;                 ///< s; 0 where it is not
  std::uint64_t Ticks = 0;
  PeriodStatistics Periods;     ///< from one new sample to the next
  std::string ConnectionReport; ///< as the device says it
  std::string ThreadAdvice;     ///< why the loop has not the urgency that it asked for
};

/// Asks an open device for samples at its own rate, without force, until it is homed and
/// `leastSeconds` have passed, it fails, or `show` answers false. Its loop has a thread of its own;
/// `show` is called on this one.
PALPATESCENE_EXPORT HomingReport HomeDevice(HapticDevice& device, double leastSeconds,
                                            const std::function<bool(const HomingView&)>& show);

/// Makes, opens, homes and closes the device of a name. Throws InputError where there is no such
/// kind of device, std::runtime_error where it does not open.
PALPATESCENE_EXPORT HomingReport HomeDevice(const std::string& name, double leastSeconds,
                                            const std::function<bool(const HomingView&)>& show);
} // namespace palpate
