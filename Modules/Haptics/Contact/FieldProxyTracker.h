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
/// Follows a tool's shell of points with the place nearest to the probe where none of them is
/// inside a solid, which is also right where many touch, as in clefts.
///
/// Each point that touches gives a plane, by value over gradient of the field. On a sphere it then
/// moves to where the sphere is deepest in that plane, so that a sphere is felt as one, however far
/// apart its points are. The proxy goes to
/// the nearest place that all planes allow, asks the field again there, and so on until nothing
/// changes: sequential quadratic programming, whose end lies on the field's own surface, not on a
/// plane. A sphere is noticed before it touches between its points, so contact begins at its own
/// surface. Its steps are shorter than half a voxel, so it stays on its side of walls that are a
/// voxel thick; without touch, rays of all points along the way find walls however thin. What a
/// tick has no time for is left to the next.
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
    this->Solid = {std::shared_ptr<const FieldSolid>(), &solid}; // owns nothing, so frees nothing
  }
  double SurfaceTolerance() const noexcept override { return 0.5 * this->Solid->VoxelSize(); }
  bool IsFreeAt(const ToolPose& pose) noexcept override
  {
    this->Shell.Turn(pose.Orientation);
    return this->Shell.CountInside(*this->Solid, pose.PositionWorld) == 0;
  }

private:
  enum class State
  {
    Nothing, ///< of where the tool was
    Free,
    Touching
  };

  // Where the tool stands on the surface.
  struct Foot
  {
    Vector3 Offset;    // from the tool's origin, mm
    Vector3 Normal;    // of the surface there
    std::size_t Point; // of the shell, where it began
    bool HasMoved;     // from there
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
  /// Of a sphere, points outside of it, so high that it touches no wall before one of them does.
  std::optional<ToolShell> Halo;
  FrictionCone Friction;
  double Reach;        // mm; of tool points from the origin
  double SphereRadius; // mm; 0 for other tools and points

  State Known = State::Nothing;
  bool IsTurned = false;                // in this tick
  bool IsLost = false;                  // inside, and no way out is known
  Vector3 ProbeWorld = Vector3::Zero(); // up to where its path has been followed
  Vector3 ToolWorld = Vector3::Zero();  // the proxy
  Vector3 NormalWorld = Vector3::UnitZ();
  std::vector<Foot> Feet;
  std::size_t FootCount = 0;
  std::vector<unsigned char> HasFoot; // for each point of the shell
  std::vector<HalfSpace> Planes;      // of places of the tool's origin, one for each foot
  double Deepest = 0.0;               // mm; of the feet, by their planes
  Contact Felt;
};
} // namespace palpate
