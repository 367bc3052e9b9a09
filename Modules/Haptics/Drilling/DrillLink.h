#pragma once

#include "DrillCommand.h"
#include "FieldSolid.h"
#include "PlainVector3.h"
#include "RingBuffer.h"
#include "SnapshotSlot.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace palpate
{
/// A frame of a tool in the world, to be copied as bytes.
struct PlainPose
{
  PlainVector3 PositionWorld; ///< mm
  /// x, y, z, w of the unit quaternion.
  std::array<double, 4> Orientation{0.0, 0.0, 0.0, 1.0};
};

/// What the servo wants to be done to the fields that it drills.
struct CutOrder
{
  std::uint64_t Number = 0; ///< from 0, without a gap
  DrillCommand Command = DrillCommand::None;
  std::int32_t Site = -1; ///< which field a cut is for; none of a command
  std::int32_t Tool = 0;  ///< of the editor's
  PlainPose From;
  PlainPose To;
};

/// The fields as they are once all orders below a number are done.
struct DrillVersions
{
  std::uint64_t Number = 0;
  std::uint64_t GrownAt = 0; ///< of the last order after which there was more material; 0: none
  /// One for each site, with the bounds of the undrilled one.
  std::vector<std::shared_ptr<const FieldSolid>> Solids;
};

/// Between a servo that drills and who edits the fields. Neither waits for the other.
struct DrillLink
{
  /// More than a servo gives before it waits for versions (DrillFeed::MostWaiting of each
  /// structure), and commands.
  static constexpr std::size_t OrdersAtOnce = 4096;

  RingBuffer<CutOrder> Orders{OrdersAtOnce}; ///< from the servo
  SnapshotSlot<DrillVersions> Versions;      ///< to it
};
} // namespace palpate
