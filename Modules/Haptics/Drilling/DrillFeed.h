#pragma once

#include "DrillLink.h"
#include "ToolPose.h"
#include "Vector3.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/// How far a drill has eaten into one structure beyond what the version that is felt shows. The
/// hand feels the tool where it has come to, so what it feels goes on evenly while versions come in
/// steps. Of one servo thread; allocates nothing.
class DrillFeed
{
public:
  /// Cuts that were ordered and are not in a version yet; with so many the drill waits.
  static constexpr std::size_t MostWaiting = 64;
  /// Ticks from one cut to the next.
  static constexpr int TicksOfCut = 4;

  /// The version that is felt has all orders below `number`.
  void Arrive(std::uint64_t number) noexcept;

  /// How far (mm) the drill is ahead of the proxy.
  double Ahead() const noexcept;
  /// What is left (mm) of the offset from the probe to the proxy, since the drill is ahead.
  Vector3 Remaining(const Vector3& offset) const noexcept;

  /// Feeds by `way` (mm) towards the probe, as far as that: from where `remaining` is the offset
  /// from the probe to the tool. How far it went.
  double Advance(const ToolPose& probe, const Vector3& remaining, double way) noexcept;
  /// The tool does not cut in this tick.
  void Lift() noexcept
  {
    this->IsCutting = false;
    this->Unordered = 0.0;
  }

  /// Whether a cut is to be ordered now; once a tick. Where the tool went farther than `apart` (mm)
  /// since the last one, it is cut only where it is.
  bool NextCut(double apart, CutOrder& order) noexcept;
  /// It was, under that number.
  void Ordered(const CutOrder& order) noexcept;

private:
  struct Step
  {
    std::uint64_t Number = 0; // of the order
    double Way = 0.0;         // mm
  };
  std::array<Step, MostWaiting> Waiting;
  std::size_t First = 0; // of those that wait
  std::size_t Count = 0;
  double Unordered = 0.0; // mm
  PlainPose Tool;
  PlainPose LastCut;
  int TicksSinceCut = 0;
  bool IsCutting = false;
};
} // namespace palpate
