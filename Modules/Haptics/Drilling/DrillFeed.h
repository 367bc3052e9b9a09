#pragma once

#include "DrillLink.h"
#include "ToolPose.h"
#include "Vector3.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/// Where a drill has come to in one structure, beyond what the version that is felt shows: between
/// that one's proxy and the probe. The hand feels the tool there, so what it feels goes on evenly
/// while versions come in steps. Of one servo thread; allocates nothing.
///
/// The tool that touches is smaller than the one that cuts by a clearance: in a hole of its own
/// size a tool would wedge. So while it cuts, the tool may be as far above the proxy; and as far
/// below beside what waits, since a pit that is smaller than a voxel shows in no version.
///
/// A tool that moves along the surface comes out of its own pit again, over the rim of what is not
/// cut yet: a ball of radius R, D below the surface, rises by sqrt(2 D / R) of its way.
class DrillFeed
{
public:
  /// Cuts that were ordered and are not in a version yet; with so many the drill waits.
  static constexpr std::size_t MostWaiting = 64;
  /// Ticks from one cut to the next.
  static constexpr int TicksOfCut = 4;

  /// Radius of what cuts, and clearance; mm.
  DrillFeed(double radius, double clearance) noexcept : Radius(radius), Clearance(clearance) {}

  /// The version that is felt has all orders below `number`.
  void Arrive(std::uint64_t number) noexcept;

  /// Once a tick, at a surface that is touched: where the tool is now, as an offset (mm) from the
  /// probe, by the offset from the probe to the proxy. `cuts`: it is going to be fed.
  Vector3 Meet(const ToolPose& probe, const Vector3& offset, bool cuts) noexcept;
  /// Feeds by `way` (mm) from there towards the probe, as far as that. How far it went.
  double Advance(double way) noexcept;
  /// The tool does not cut in this tick.
  void Rest() noexcept;
  /// It does not touch any more.
  void Leave() noexcept;

  /// Whether a cut is to be ordered now; once a tick. Where the tool went farther than its radius
  /// since the last one, it is cut only where it is.
  bool NextCut(CutOrder& order) noexcept;
  /// It was, under that number.
  void Ordered(const CutOrder& order) noexcept;

private:
  struct Step
  {
    std::uint64_t Number = 0; // of the order
    double Way = 0.0;         // mm
  };
  double MostAhead() const noexcept;

  double Radius;
  double Clearance;
  std::array<Step, MostWaiting> Waiting;
  std::size_t First = 0; // of those that wait
  std::size_t Count = 0;
  double Unordered = 0.0;              // mm
  double Play = 0.0;                   // mm of the clearance that are used now
  ToolPose Probe;                      // of this tick
  Vector3 Remaining = Vector3::Zero(); // mm, from there to the tool
  Vector3 Tool = Vector3::Zero();      // mm, world
  PlainPose LastCut;
  int TicksSinceCut = 0;
  bool IsTouching = false;
  bool IsCutting = false;
};
} // namespace palpate
