#include "ElasticTracker.h"

#include <algorithm>
#include <array>
#include <utility>

namespace palpate
{
ElasticTracker::ElasticTracker(std::shared_ptr<const HarmonicSurface> surface,
                               std::shared_ptr<const ComplianceAtlas> atlas, double toolRadius,
                               const SurfaceFriction& friction)
    : Rigid(surface, toolRadius, SurfaceFriction()), Surface(std::move(surface)),
      Atlas(std::move(atlas)), ToolRadius(toolRadius), Friction(friction)
{
}

void ElasticTracker::Release() noexcept
{
  this->Rigid.Release();
  this->LetGo();
}

void ElasticTracker::LetGo() noexcept
{
  this->PatchRadius = 0.0;
  this->Shear.setZero();
  this->ShearStiffness = 0.0;
  this->IsSlipping = false;
}

const Contact& ElasticTracker::Follow(const ToolPose& pose) noexcept
{
  this->Felt = this->Rigid.Follow(pose);
  this->Push = ElasticForce();
  this->Felt.Elastic = &this->Push;
  if (!this->Felt.IsValid)
  {
    return this->Felt;
  }
  if (this->Felt.IsTouching)
  {
    this->Press(pose.PositionWorld);
    this->Rub(pose.PositionWorld);
  }
  else
  {
    this->LetGo();
  }
  this->LastProbe = pose.PositionWorld;
  return this->Felt;
}

// The walls that the ball is pressed into at the probe: minima of the distance to it, continued
// from those that are known at the proxy.
std::size_t ElasticTracker::WallsAt(const Vector3& probe,
                                    CoupledPatches::Wall* walls) const noexcept
{
  constexpr double Apart = 1e-3; // rad; closer ones are the same
  std::size_t count = 0;
  for (std::size_t i = 0; i < this->Rigid.WallCount() && count < CoupledPatches::MostWalls; ++i)
  {
    const ClosestPoint foot = this->Surface->Search().Track(probe, this->Rigid.Walls()[i]);
    const bool isNew =
        std::none_of(walls, walls + count,
                     [&foot](const CoupledPatches::Wall& wall)
                     { return (wall.Direction - foot.Direction).squaredNorm() < Apart * Apart; });
    const double depth = this->ToolRadius - foot.SignedDistance;
    // Deeper than its radius, a ball's centre is inside, where minima are of the other side too.
    if (foot.Converged() && isNew && depth > 0.0 && depth < this->ToolRadius)
    {
      walls[count++] = {foot.Direction, depth};
    }
  }
  return count;
}

void ElasticTracker::Press(const Vector3& probe) noexcept
{
  std::array<CoupledPatches::Wall, CoupledPatches::MostWalls> walls;
  const std::size_t count = this->Rigid.WallCount() > 1 ? this->WallsAt(probe, walls.data()) : 0;
  if (count == 0)
  {
    this->PressOne(probe);
    return;
  }
  this->Push = CoupledPatches::Of(*this->Atlas, this->Surface->Model(), walls.data(), count,
                                  this->ToolRadius);
  this->PatchRadius = 0.0; // starts anew if one wall is left
}

void ElasticTracker::PressOne(const Vector3& probe) noexcept
{
  constexpr double OnSurface = 1e-6; // of the radius
  const SphericalHarmonicModel& model = this->Surface->Model();
  const Vector3 foot = this->Felt.ProxyWorld - this->ToolRadius * this->Felt.NormalWorld;
  const Vector3 fromCenter = foot - model.CenterWorld();
  const double distance = fromCenter.norm();
  const Vector3 direction = fromCenter / distance;
  ElasticForce& force = this->Push;
  force = ElasticForce::Of(*this->Atlas, model, direction, this->Felt.Depth, this->ToolRadius,
                           this->PatchRadius);
  this->PatchRadius = force.PatchRadius;
  if (!(std::abs(distance - model.Radius(direction)) <= OnSurface * distance))
  {
    const Vector3 push = this->Felt.ProxyWorld - probe;
    force.ForceWorld = force.ForceWorld.dot(model.Normal(direction)) / this->Felt.Depth * push;
    force.IsValid = false;
  }
}

void ElasticTracker::Rub(const Vector3& probe) noexcept
{
  ElasticForce& force = this->Push;
  const double nu = this->Atlas->PoissonRatio();
  const double stiffness = force.Slope * (1.0 - nu) / (1.0 - 0.5 * nu);
  const Vector3& normal = this->Felt.NormalWorld;
  if (this->Friction.Static > 0.0 && this->ShearStiffness > 0.0)
  {
    const auto along = [&](const Vector3& v) { return Vector3(v - v.dot(normal) * normal); };
    const double kept = std::min(1.0, stiffness / this->ShearStiffness);
    this->Shear = along(kept * this->Shear - stiffness * (probe - this->LastProbe));
    const double push = std::max(0.0, force.ForceWorld.dot(normal));
    const double size = this->Shear.norm();
    const double most = (this->IsSlipping ? this->Friction.Dynamic : this->Friction.Static) * push;
    this->IsSlipping = size > most;
    if (this->IsSlipping)
    {
      this->Shear *= this->Friction.Dynamic * push / size;
    }
    force.ForceWorld += this->Shear;
  }
  this->ShearStiffness = stiffness;
}
} // namespace palpate
