#pragma once

#include "ClearMotion.h"
#include "ContactTracker.h"
#include "ContactWedge.h"
#include "FrictionCone.h"
#include "TouchableRadialModel.h"
#include "TouchableSurfaceModel.h"
#include "WedgePlaces.h"

#include <memory>

namespace palpate
{
/// Tracks a spherical tool by the nearest point of a radial or surface model.
///
/// Without contact, the probe's path is followed through spheres that are proven free: their radius
/// is the proven distance to the nearest point, so no wall is passed undetected, and most ticks
/// need no evaluation. In contact, the local minimum of the distance that the tool met is continued
/// by Newton's method, even if another part of the surface becomes nearer; long ticks are divided
/// into short steps. Where the minimum ends, as at the centre of a sphere, the proxy moves on along
/// the surface by a limited amount per tick. Contact ends where the tool is a radius or more
/// outside, checked by that minimum first and then by the whole surface.
///
/// The tool is placed at the nearest point plus radius times normal; ContactWedge keeps a tool
/// that is too large for a hollow of the surface out of all walls. Friction holds the tool in place
/// until the pull leaves the friction cone; then it slips towards the nearest point until it sticks
/// again.
///
/// A surface model may wrap round anything and may cross itself, where the nearest point does
/// not tell inside from outside. The tool's own path does: it starts outside (or is moved out), and
/// each contact keeps to the side of the surface from which it began. It ends where a straight path
/// leads from the proxy to the probe through spheres that are proven free. Where the surface was
/// found to cross itself, ContactWedge moves every tool, a point too as a small sphere; there and
/// in hollows only (WedgePlaces).
template <typename Surface>
class NearestPointTrackerOf final : public ContactTracker
{
public:
  using ClosestPoint = typename Surface::ClosestPoint;
  using Place = typename Surface::Place;

  /// `wallsAhead` (mm): see ContactWedge.
  NearestPointTrackerOf(std::shared_ptr<const Surface> surface, double toolRadius,
                        const SurfaceFriction& friction, double wallsAhead = 0.0);

  const Contact& Follow(const ToolPose& pose) noexcept override;
  void Release() noexcept override { this->Known = State::Nothing; }
  bool IsFreeAt(const ToolPose& pose) noexcept override;
  /// With the margin of a surface that crosses itself.
  double SurfaceTolerance() const noexcept override
  {
    return 4.0 * this->TouchingGap + this->Touched->Margin();
  }
  /// In contact: the walls that hold the tool, or are near where several may, at its proxy.
  const ClosestPoint* Walls() const noexcept
  {
    return this->IsWedging ? this->Wedge->Walls() : &this->Closest;
  }
  std::size_t WallCount() const noexcept { return this->IsWedging ? this->Wedge->WallCount() : 1; }
  std::size_t Bytes() const noexcept override
  {
    return sizeof(*this) + (this->Wedge ? this->Wedge->Bytes() : 0) +
           (this->Motion ? this->Motion->Bytes() : 0) +
           (this->Places ? sizeof(*this->Places) + this->Places->Bytes() : 0);
  }

private:
  enum class State
  {
    Nothing, ///< about the tool's last place
    Free,
    Touching
  };

  void Advance(const Vector3& probe) noexcept;
  bool MoveFree(const Vector3& probe) noexcept;
  void Slide(const Vector3& probe) noexcept;
  ProvenBall RoomOfOneWall() const noexcept;
  bool Press(const Vector3& probe, double motion) noexcept;
  void Settle(const Vector3& probe) noexcept;
  void Touch(const ClosestPoint& nearest, const ProvenBall& known = {}) noexcept;
  void LetGo(const ClosestPoint& nearest) noexcept;
  // Of the tool at this place of the surface: where the wedge moves it, with the surface's margin.
  double RadiusAt(const Vector3& direction) const noexcept
  {
    return this->ToolRadius + (this->NeedsWedge(direction) ? this->Touched->Margin() : 0.0);
  }
  // Whether Closest is a place from which a search may begin.
  bool IsNearKnown() const noexcept
  {
    return Surface::MayCrossItself && this->Closest.State != ClosestPoint::Outcome::BadInput;
  }
  double EndOfContact() const noexcept
  {
    return Surface::MayCrossItself ? this->ToolRadius + this->TouchingGap : this->ToolRadius;
  }
  void Leave(const ClosestPoint& next, const Vector3& probe) noexcept;
  void LetGoOutside(const ClosestPoint& nearest, const Vector3& probe) noexcept;
  ClosestPoint Tracked(const Vector3& start, const Vector3& probe) noexcept;
  bool IsContinued(const ClosestPoint& last, const ClosestPoint& next,
                   double motion) const noexcept;
  ClosestPoint Continued(const Vector3& start, const Vector3& probe) noexcept;
  int EvaluationsOfNextSearch() const noexcept;
  ClosestPoint NearestTo(const Vector3& probe) noexcept;
  void Measure(const Vector3& probe) noexcept;
  void Drag(const Vector3& probe) noexcept;
  // Whether the wedge is to move a tool that touches there.
  bool NeedsWedge(const Vector3& direction) const noexcept
  {
    return this->Wedge && (!this->Places || this->Places->Contains(direction));
  }
  void EndWedge(const Vector3& probe) noexcept;
  void DragWedge(const Vector3& probe) noexcept;
  void LeaveWedge(const Vector3& probe) noexcept;
  bool IsBesideWall(const Vector3& probe) const noexcept;
  Place Slip(const Vector3& probe, const Place& end) const noexcept;
  FrictionCone::Pull PullOf(const Vector3& probe, const Place& place) const noexcept
  {
    return {probe - (place.PointWorld + this->ToolRadius * place.Normal), place.Normal};
  }
  void Report(const Vector3& probe) noexcept;
  void WithoutMargin(const Vector3& probe) noexcept;

  std::shared_ptr<const Surface> Touched;
  double ToolRadius; // mm
  FrictionCone Friction;
  double TouchingGap; // mm; smaller distances count as contact
  double Stride;      // mm; the longest step of the probe that stays with its minimum

  int EvaluationsLeft = 0; // in this tick
  State Known = State::Nothing;
  Vector3 ProbeWorld = Vector3::Zero(); // end of the probe's path that has been followed
  // Without contact at a radial model: the tool is free while its centre is in this sphere.
  Vector3 ClearCenterWorld = Vector3::Zero();
  double ClearRadius = 0.0;
  // In contact: the minimum that is tracked, and where friction holds the tool.
  ClosestPoint Closest{};
  Place Held{};
  // Used instead where the tool does not fit: at these places of a surface model, else
  // anywhere.
  std::unique_ptr<ContactWedgeOf<Surface>> Wedge;
  std::shared_ptr<const WedgePlaces> Places;
  bool IsWedging = false;
  // At a surface model, without contact.
  std::unique_ptr<ClearMotion> Motion;
  // Whether the wedge moves a tool that no wall holds, since one is near.
  bool IsHovering = false;
  Contact Felt;
};
using NearestPointTracker = NearestPointTrackerOf<TouchableRadialModel>;
using SurfaceTracker = NearestPointTrackerOf<TouchableSurfaceModel>;
} // namespace palpate
