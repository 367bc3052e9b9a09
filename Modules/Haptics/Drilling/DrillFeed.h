#pragma once

#include "DrillLink.h"
#include "ToolPose.h"
#include "Vector3.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/// Position of a drill in one structure, ahead of the published version: between that version's
/// proxy and the probe. The force is computed from this position, so it changes smoothly while
/// versions arrive in steps. For one servo thread; does not allocate.
///
/// The touching tool is smaller than the cutting tool by a clearance: in a hole of its own size a
/// tool would wedge. So while it cuts, the tool may be that much above the proxy; and that much
/// below, in addition to pending cuts, since a pit smaller than a voxel shows in no version.
///
/// A tool that moves along the surface climbs out of its own pit, over the rim of uncut material: a
/// sphere of radius R, D below the surface, rises by sqrt(2 D / R) times its path.
class DrillFeed
{
public:
  /// Maximum number of orders that are not in a version yet; then the drill stops.
  static constexpr std::size_t MostWaiting = 64;
  /// Ticks between cuts.
  static constexpr int TicksOfCut = 4;

  /// Radius of the cutting tool, and clearance; mm.
  DrillFeed(double radius, double clearance) noexcept : Radius(radius), Clearance(clearance) {}

  /// The current version contains all orders below `number`.
  void Arrive(std::uint64_t number) noexcept;

  /// Once per tick in contact: returns the tool's position as an offset (mm) from the probe, given
  /// the offset from the probe to the proxy. `cuts`: the tool will advance.
  Vector3 Meet(const ToolPose& probe, const Vector3& offset, bool cuts) noexcept;
  /// Advances by up to `path` (mm) towards the probe. Returns the distance.
  double Advance(double path) noexcept;
  /// The tool does not cut in this tick.
  void Rest() noexcept;
  /// Contact has ended.
  void Leave() noexcept;

  /// Whether a cut is due; once per tick. If the tool moved farther than its radius since the last
  /// cut, the cut covers its current place only.
  bool NextCut(CutOrder& order) noexcept;
  /// The cut was ordered, with its number.
  void Ordered(const CutOrder& order) noexcept;

private:
  struct Step
  {
    std::uint64_t Number = 0; // of the order
    double Path = 0.0;        // mm
  };
  double MostAhead() const noexcept;

  double Radius;
  double Clearance;
  std::array<Step, MostWaiting> Waiting;
  std::size_t First = 0; // of the pending ones
  std::size_t Count = 0;
  double Unordered = 0.0;              // mm
  double Play = 0.0;                   // mm of the clearance in use
  ToolPose Probe;                      // of this tick
  Vector3 Remaining = Vector3::Zero(); // mm, from the probe to the tool
  Vector3 Tool = Vector3::Zero();      // mm, world
  PlainPose LastCut;
  int TicksSinceCut = 0;
  bool IsTouching = false;
  bool IsCutting = false;
};
} // namespace palpate
