#pragma once

#include "DeviceSample.h"
#include "DeviceState.h"
#include "DrillCommand.h"
#include "LoopSchedule.h"
#include "SafetyReport.h"

#include <array>
#include <cstdint>

namespace palpate
{
/// Result of one tick: for views, which read the newest, and for recordings, which read all. Can be
/// copied as bytes.
struct TouchState
{
  TickInfo Tick;
  DeviceState State = DeviceState::Closed;
  bool HasSample = false;
  DeviceSample Sample;
  PlainVector3 ProbeWorld;   ///< device position, mm
  PlainVector3 ProxyWorld;   ///< displayed tool position, mm: the deepest contact's proxy
  PlainVector3 ForceDevice;  ///< to be applied, N
  PlainVector3 ForceWorld;   ///< the same, rotated
  PlainVector3 TorqueDevice; ///< to be applied, N mm
  /// Of the tool at the hand and as displayed, to the world: x, y, z, w of a unit quaternion. They
  /// differ for tools of several balls.
  std::array<double, 4> ProbeOrientation{0.0, 0.0, 0.0, 1.0};
  std::array<double, 4> ProxyOrientation{0.0, 0.0, 0.0, 1.0};
  /// Of tools of several balls, the point of the surface that the displayed tool touches, mm; not
  /// recorded.
  bool HasFoot = false;
  PlainVector3 FootWorld;
  bool WasTaken = false;       ///< the device accepted the force
  std::int32_t Structure = -1; ///< the one touched most deeply; -1 without contact
  double Depth = 0.0;          ///< mm, in that structure
  /// If that structure yields, as ElasticForce has them; else 0 and false.
  double PatchRadius = 0.0;    ///< mm
  double ElasticEnergy = 0.0;  ///< N mm
  bool IsBeyondLinear = false; ///< linear elasticity does not hold there
  std::uint64_t Scene = 0;     ///< number of scenes adopted; 0 before the first
  bool WasRearmed = false;     ///< the user switched forces on again before this tick
  bool WasContinued = false;   ///< the adopted scene continued the previous one
  bool IsBuried = false;       ///< a structure around the tool is silent until it left
  bool IsBehind = false;       ///< the work of the tick ended before a proxy reached its place
  bool IsClutched = false;     ///< the clutch is held: nothing is felt
  bool IsDrilling = false;     ///< the drill was requested to run
  DrillCommand Command = DrillCommand::None; ///< consumed before this tick
  std::uint64_t DrillVersion = 0;            ///< DrillVersions::Number of the version in use
  std::uint64_t DrillOrders = 0;             ///< number given so far, including this tick
  SafetyReport Safety;
};
} // namespace palpate
