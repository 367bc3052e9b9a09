#pragma once

#include "DeviceSample.h"
#include "DeviceState.h"
#include "DrillCommand.h"
#include "LoopSchedule.h"
#include "SafetyReport.h"

#include <cstdint>

namespace palpate
{
/// What happened in one tick: for views, which want the newest, and for recordings, which want all.
/// May be copied as bytes.
struct TouchState
{
  TickInfo Tick;
  DeviceState State = DeviceState::Closed;
  bool HasSample = false;
  DeviceSample Sample;
  PlainVector3 ProbeWorld;     ///< where the device is, mm
  PlainVector3 ProxyWorld;     ///< where the tool is drawn, mm: at the deepest contact's proxy
  PlainVector3 ForceDevice;    ///< to be applied, N
  PlainVector3 ForceWorld;     ///< the same, turned
  bool WasTaken = false;       ///< the device took the force
  std::int32_t Structure = -1; ///< of the scene's, the one touched most deeply; -1 without touch
  double Depth = 0.0;          ///< mm, in that one
  std::uint64_t Scene = 0;     ///< counts the scenes taken over; 0 before the first
  bool WasRearmed = false;     ///< a person switched forces on again before this tick
  bool WasContinued = false;   ///< the scene that was taken over went on from the one before
  bool IsDrilling = false;     ///< the drill was to run
  DrillCommand Command = DrillCommand::None; ///< that was taken before this tick
  std::uint64_t DrillVersion = 0;            ///< DrillVersions::Number of what was felt
  std::uint64_t DrillOrders = 0;             ///< given so far, with those of this tick
  SafetyReport Safety;
};
} // namespace palpate
