#pragma once

#include "ContactTracker.h"
#include "FieldSolid.h"
#include "FrictionCone.h"
#include "HalfSpaces.h"
#include "ToolShell.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace palpate
{
/// Tracks a shell of points: the proxy is the place nearest to the probe where no point is inside a
/// solid, which also holds with many contacts, as in clefts.
///
/// By sequential quadratic programming (see the folder's README), whose result lies on the field's
/// own surface, not on a plane. A sphere is detected before it touches between its points, so
/// contact begins at its own surface. Steps are shorter than half a voxel, so the proxy stays on
/// its side of walls that are a voxel thick; without contact, rays of all points along the path
/// find walls however thin.
class FieldProxyTracker final : public ContactTracker
{
public:
  FieldProxyTracker(std::shared_ptr<const FieldSolid> solid, const ToolShape& tool,
                    const SurfaceFriction& friction);

  const Contact& Follow(const ToolPose& pose) noexcept override;
  void Release() noexcept override { this->Known = State::Nothing; }
  std::size_t Bytes() const noexcept override;

  bool CanBeDrilled() const noexcept override { return true; }
  void UseSolid(const FieldSolid& solid) noexcept override
  {
    this->Solid = {std::shared_ptr<const FieldSolid>(),
                   &solid}; // aliasing constructor: does not own `solid`
  }
  double SurfaceTolerance() const noexcept override { return 0.5 * this->Solid->VoxelSize(); }
  bool IsFreeAt(const ToolPose& pose) noexcept override
  {
    if (!pose.IsUsable())
    {
      return false;
    }
    this->Shell.Turn(pose.Orientation);
    return this->Shell.CountInside(*this->Solid, pose.PositionWorld) == 0;
  }

private:
  enum class State
  {
    Nothing, ///< about the tool's last place
    Free,
    Touching
  };

  // A contact point of the tool on the surface.
  struct Foot
  {
    Vector3 Offset;    // from the tool's origin, mm
    Vector3 Normal;    // of the surface there
    std::size_t Point; // of the shell, from which it started
    bool HasMoved;     // away from the shell point
  };

  void Advance(const Vector3& probe) noexcept;
  bool MoveFree(const Vector3& probe) noexcept;
  bool TouchesBetweenPoints(const Vector3& probe) noexcept;
  void Slide(const Vector3& probe) noexcept;
  bool Press(const Vector3& goal) noexcept;
  bool Solve(const Vector3& goal) noexcept;
  void Settle(const Vector3& probe) noexcept;
  void Surface() noexcept;
  void Escape(const Vector3& probe) noexcept;
  void ForgetFeet() noexcept;
  void MoveFeet() noexcept;
  void MoveOnSphere(Foot& foot) noexcept;
  void AddFeet() noexcept;
  void LiftFoot(std::size_t foot) noexcept;
  void GatherPlanes() noexcept;
  void Report(const Vector3& probe) noexcept;

  std::shared_ptr<const FieldSolid> Solid;
  ToolShell Shell;
  /// For a sphere, points outside of it, at such a height that the sphere touches no wall before
  /// one of them does.
  std::optional<ToolShell> Halo;
  FrictionCone Friction;
  double Reach;        // mm; of tool points from the origin
  double SphereRadius; // mm; 0 for other tools and points

  State Known = State::Nothing;
  bool IsTurned = false;                // changed orientation in this tick
  bool IsLost = false;                  // inside, with no known exit
  Vector3 ProbeWorld = Vector3::Zero(); // end of the probe's path that has been followed
  Vector3 ToolWorld = Vector3::Zero();  // the proxy
  Vector3 NormalWorld = Vector3::UnitZ();
  std::vector<Foot> Feet;
  std::size_t FootCount = 0;
  std::vector<unsigned char> HasFoot; // for each point of the shell
  std::vector<HalfSpace> Planes;      // constraints on the tool's origin, one per contact point
  double Deepest = 0.0;               // mm; of the contact points, by their planes
  Contact Felt;
};
} // namespace palpate
