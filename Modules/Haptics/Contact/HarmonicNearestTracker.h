#pragma once

#include "ContactTracker.h"
#include "FrictionCone.h"
#include "HarmonicSurface.h"
#include "HarmonicWedge.h"

#include <memory>

namespace palpate
{
/// Follows a spherical tool with the nearest point of a star-shaped surface.
///
/// Free, the probe's path is followed through balls in which nothing is touched: they are as large
/// as the proven distance to the nearest point, so no wall is passed unnoticed, and most ticks do
/// nothing. Touching, the minimum of the distance that the tool met is continued by Newton's
/// method, also where another part of the surface becomes nearer; long ticks are followed in short
/// steps. Where the minimum ends, as in the centre of a sphere, the proxy goes on along the
/// surface, so much a tick and no more. It lets go where the tool is a radius or more outside, by
/// that minimum first and then by the whole surface.
///
/// The tool is put at the nearest point plus radius times normal; one that is too large for some
/// hollow of the surface is kept out of all walls by HarmonicWedge. Friction holds it where it was,
/// until the pull leaves the cone; then it slips towards the nearest point until it resists again.
class HarmonicNearestTracker final : public ContactTracker
{
public:
  HarmonicNearestTracker(std::shared_ptr<const HarmonicSurface> surface, double toolRadius,
                         const SurfaceFriction& friction);

  const Contact& Follow(const ToolPose& pose) noexcept override;
  void Release() noexcept override { this->Known = State::Nothing; }
  std::size_t Bytes() const noexcept override
  {
    return sizeof(*this) + (this->Wedge ? sizeof(*this->Wedge) : 0);
  }

private:
  enum class State
  {
    Nothing, ///< of where the tool was
    Free,
    Touching
  };

  void Advance(const Vector3& probe) noexcept;
  bool MoveFree(const Vector3& probe) noexcept;
  void Slide(const Vector3& probe) noexcept;
  bool Press(const Vector3& probe, double motion) noexcept;
  void Settle(const Vector3& probe) noexcept;
  void Touch(const ClosestPoint& nearest) noexcept;
  void LetGo(const ClosestPoint& nearest) noexcept;
  ClosestPoint Continued(const Vector3& probe) noexcept;
  int EvaluationsOfNextSearch() const noexcept;
  ClosestPoint NearestTo(const Vector3& probe) noexcept;
  void Measure(const Vector3& probe) noexcept;
  void Drag(const Vector3& probe) noexcept;
  void DragWedge(const Vector3& probe) noexcept;
  void LeaveWedge(const Vector3& probe) noexcept;
  HarmonicSurface::Place Slip(const Vector3& probe,
                              const HarmonicSurface::Place& end) const noexcept;
  FrictionCone::Pull PullOf(const Vector3& probe,
                            const HarmonicSurface::Place& place) const noexcept;
  void Report(const Vector3& probe) noexcept;

  std::shared_ptr<const HarmonicSurface> Surface;
  double ToolRadius; // mm
  FrictionCone Friction;
  double TouchingGap; // mm; what is closer is taken as touched
  double Stride;      // mm; the longest step of the probe that keeps to its minimum

  int EvaluationsLeft = 0; // in this tick, of searches of the whole surface
  State Known = State::Nothing;
  Vector3 ProbeWorld = Vector3::Zero(); // up to where its path has been followed
  // Free: the tool touches nothing while its centre is in this ball.
  Vector3 ClearCenterWorld = Vector3::Zero();
  double ClearRadius = 0.0;
  // Touching: the minimum that is followed, and where friction holds the tool.
  ClosestPoint Closest{};
  HarmonicSurface::Place Held{};
  std::unique_ptr<HarmonicWedge> Wedge; // that holds it instead, where it does not fit everywhere
  Contact Felt;
};
} // namespace palpate
