#pragma once

#include "ComplianceAtlas.h"
#include "ContactTracker.h"
#include "CoupledPatches.h"
#include "ElasticForce.h"
#include "NearestPointTracker.h"
#include "PressedPlace.h"

#include <array>
#include <cstddef>
#include <memory>

namespace palpate
{
/// Tracks a ball at a structure that yields. The nearest point is that of the rigid surface, and
/// depth and patch follow from it. Where the ball does not fit into a hollow of the surface, each
/// wall that the ball is pressed into has a patch (CoupledPatches), also one that the rigid proxy
/// does not touch yet; ElasticHold tells where. The force is minus the gradient of one energy of
/// the ball's place there too, and does not jump where another wall takes hold. In a hollow that is
/// so round that the ball touches it all round, the force is that of one patch in the proxy's
/// direction, and said to be invalid.
///
/// Friction is a spring along the surface, as stiff as the patch (Mindlin, J. Appl. Mech. 16,
/// 1949), whose force Coulomb's law limits. It follows the ball from tick to tick, and shrinks with
/// the patch, so that unloading gives no energy out.
class ElasticTracker final : public ContactTracker
{
public:
  ElasticTracker(std::shared_ptr<const TouchableRadialModel> surface,
                 std::shared_ptr<const ComplianceAtlas> atlas, double toolRadius,
                 const SurfaceFriction& friction);

  const Contact& Follow(const ToolPose& pose) noexcept override;
  void Release() noexcept override;
  bool IsFreeAt(const ToolPose& pose) noexcept override { return this->Rigid.IsFreeAt(pose); }
  double SurfaceTolerance() const noexcept override { return this->Rigid.SurfaceTolerance(); }
  /// Where the ball presses the organ since the last tick, for pictures of its dent.
  const PressedPlace* Places() const noexcept { return this->Pressed.data(); }
  std::size_t PlaceCount() const noexcept { return this->PressedCount; }
  std::size_t Bytes() const noexcept override { return sizeof(*this) + this->Rigid.Bytes(); }

private:
  void Press(const Vector3& probe) noexcept;
  void PressOne(const Vector3& probe) noexcept;
  double Distinctness(const Vector3& probe) const noexcept;
  ElasticForce PressWalls(const Vector3& probe, double part) noexcept;
  double GapTo(const ClosestPoint& wall) const noexcept;
  void Rub(const Vector3& probe) noexcept;
  void LetGo() noexcept;

  NearestPointTracker Rigid;
  std::shared_ptr<const TouchableRadialModel> Surface;
  std::shared_ptr<const ComplianceAtlas> Atlas;
  double ToolRadius; // mm
  SurfaceFriction Friction;

  Contact Felt;
  ElasticForce Push;
  std::array<PressedPlace, CoupledPatches::MostWalls + 1> Pressed;
  std::size_t PressedCount = 0;
  double PatchRadius = 0.0;        // mm, of the last tick
  Vector3 Shear = Vector3::Zero(); // friction, N
  double ShearStiffness = 0.0;     // N/mm; 0 without contact
  bool IsSlipping = false;
  Vector3 LastProbe = Vector3::Zero();
};
} // namespace palpate
