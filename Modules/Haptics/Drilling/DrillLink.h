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
/// A pose of a tool in the world that can be copied as bytes.
struct PlainPose
{
  PlainVector3 PositionWorld; ///< mm
  /// x, y, z, w of the unit quaternion.
  std::array<double, 4> Orientation{0.0, 0.0, 0.0, 1.0};
};

/// A servo's order to cut or to execute a command.
struct CutOrder
{
  std::uint64_t Number = 0; ///< from 0, consecutive
  DrillCommand Command = DrillCommand::None;
  std::int32_t Site = -1; ///< which field a cut is for; -1 for a command
  std::int32_t Tool = 0;  ///< number in the DrillEditor
  PlainPose From;
  PlainPose To;
};

/// The fields after all orders below a number.
struct DrillVersions
{
  std::uint64_t Number = 0;
  std::uint64_t GrownAt = 0; ///< number of the last order that added material; 0: none
  /// One for each site, with the bounds of the initial field.
  std::vector<std::shared_ptr<const FieldSolid>> Solids;
};

/// Exchange between a servo that drills and the editor of the fields. Neither waits for the other.
struct DrillLink
{
  /// More than a servo orders before it waits for versions (DrillFeed::MostWaiting for each
  /// structure), plus commands.
  static constexpr std::size_t OrdersAtOnce = 4096;

  RingBuffer<CutOrder> Orders{OrdersAtOnce}; ///< from the servo
  SnapshotSlot<DrillVersions> Versions;      ///< to it
};
} // namespace palpate
