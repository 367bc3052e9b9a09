#pragma once

#include "ContactTracker.h"
#include "FacetTree.h"
#include "FrictionCone.h"
#include "HalfSpaces.h"

#include <array>
#include <cstddef>
#include <memory>

namespace palpate
{
/// The god-object (Zilles and Salisbury, IROS 1995), with a radius (Ruspini, Kolarov and Khatib,
/// SIGGRAPH 1997): the proxy moves straight to the probe until it touches a facet, then to the
/// nearest place on that plane, and so on with up to three planes. Each move is swept, so that it
/// passes through nothing, however fast the probe.
class FacetTracker final : public ContactTracker
{
public:
  FacetTracker(std::shared_ptr<const FacetTree> tree, double toolRadius,
               const SurfaceFriction& friction);

  const Contact& Follow(const ToolPose& pose) noexcept override;
  void Release() noexcept override { this->IsKnown = false; }
  bool IsFreeAt(const ToolPose& pose) noexcept override;
  double SurfaceTolerance() const noexcept override { return this->Skin; }
  std::size_t Bytes() const noexcept override { return sizeof(*this); }

private:
  void Settle(const Vector3& probe) noexcept;
  void Advance(const Vector3& probe) noexcept;
  bool Slide(const Vector3& goal, const Vector3& probe, double slack) noexcept;
  void SlideOverNoise(const Vector3& goal, const Vector3& probe) noexcept;
  std::size_t MoveTo(const Vector3& goal, std::size_t mostPlanes, double slack) noexcept;
  bool IsInReach() const noexcept;

  std::shared_ptr<const FacetTree> Tree;
  double ToolRadius; // mm
  double Skin;       // mm; kept between tool and facets, as a margin for rounding
  FrictionCone Friction;
  bool IsKnown = false; // of the proxy
  bool IsTouching = false;
  Vector3 ProxyWorld = Vector3::Zero();
  Vector3 NormalWorld = Vector3::UnitZ();
  Contact Felt;
};
} // namespace palpate
