#include "ElasticTracker.h"

#include "ElasticHold.h"
#include "SurfaceCurvature.h"

#include <algorithm>
#include <array>
#include <utility>

namespace palpate
{
namespace
{
// Of the ball's radius: how far walls are looked for, so that a wall is known before the ball is
// pressed into it.
constexpr double Ahead = 0.5;
} // namespace

ElasticTracker::ElasticTracker(std::shared_ptr<const TouchableRadialModel> surface,
                               std::shared_ptr<const ComplianceAtlas> atlas, double toolRadius,
                               const SurfaceFriction& friction)
    : Rigid(surface, toolRadius, SurfaceFriction(), Ahead * toolRadius),
      Surface(std::move(surface)), Atlas(std::move(atlas)), ToolRadius(toolRadius),
      Friction(friction)
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
  this->PressedCount = 0;
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

// How much the walls are places of their own: 1 in a notch; 0 in a round hollow, which the ball
// touches all round, so that walls are found anywhere on a circle.
double ElasticTracker::Distinctness(const Vector3& probe) const noexcept
{
  constexpr double Round = 0.1;
  constexpr double Distinct = 0.4;
  constexpr double Before = 0.1; // of the depth: a wall counts before the ball touches it
  const Vector3 push = this->Felt.ProxyWorld - probe;
  double least = 1.0;
  for (std::size_t i = 0; i < this->Rigid.WallCount(); ++i)
  {
    const ClosestPoint& wall = this->Rigid.Walls()[i];
    const double depth = push.dot(wall.Normal) - this->GapTo(wall);
    const double weight = std::clamp(1.0 + depth / (Before * this->Felt.Depth), 0.0, 1.0);
    const SurfaceCurvature shape = CurvatureAt(wall.SampleDirection, wall.Sample);
    least = std::min(least, 1.0 + weight * this->ToolRadius * shape.Principal[1]);
  }
  return std::clamp((least - Round) / (Distinct - Round), 0.0, 1.0);
}

void ElasticTracker::Press(const Vector3& probe) noexcept
{
  if (this->Rigid.WallCount() < 2)
  {
    this->PressOne(probe);
    return;
  }
  this->PressedCount = 0;
  const double part = this->Distinctness(probe);
  if (part < 1.0)
  {
    this->PressOne(probe);
    this->Pressed[0].Force *= 1.0 - part;
  }
  if (part > 0.0)
  {
    const ElasticForce one = this->Push;
    ElasticForce& force = this->Push;
    force = this->PressWalls(probe, part);
    force.ForceWorld = part * force.ForceWorld + (1.0 - part) * one.ForceWorld;
    force.Energy = part * force.Energy + (1.0 - part) * one.Energy;
    force.Slope = part * force.Slope + (1.0 - part) * one.Slope;
    force.IsValid = force.IsValid && part == 1.0;
  }
}

// The places get this part of their forces.
ElasticForce ElasticTracker::PressWalls(const Vector3& probe, double part) noexcept
{
  const ElasticHold hold(*this->Surface, this->ToolRadius, this->Rigid.Walls(),
                         this->Rigid.WallCount(), probe, this->Felt.ProxyWorld);
  std::array<CoupledPatches::Wall, CoupledPatches::MostWalls> walls;
  std::size_t count = 0;
  for (std::size_t i = 0; i < hold.WallCount(); ++i)
  {
    const ClosestPoint& wall = hold.Walls()[i];
    if (hold.DepthIn(wall) > 0.0)
    {
      walls[count++] = {wall.Direction, hold.DepthIn(wall), hold.GapTo(wall)};
    }
  }
  PressedPlace* const places = this->Pressed.data() + this->PressedCount;
  const ElasticForce force =
      CoupledPatches::Of(*this->Atlas, this->Surface->Model(), walls.data(), count,
                         this->ToolRadius, {hold.CenterWorld() - probe, hold.Motion()}, places);
  for (std::size_t i = 0; i < count; ++i)
  {
    places[i].Force *= part;
  }
  this->PressedCount += count;
  return force;
}

// Between the ball at the proxy and a wall (mm): 0 if it touches, or if the wall is tracked at the
// probe.
double ElasticTracker::GapTo(const ClosestPoint& wall) const noexcept
{
  return std::max(0.0, wall.SignedDistance - this->ToolRadius);
}

// At the wall that the push presses most; if that does not hold the proxy alone, with the size of
// its force along the push.
void ElasticTracker::PressOne(const Vector3& probe) noexcept
{
  constexpr double Alone = 1e-6; // of the depth
  const Vector3 push = this->Felt.ProxyWorld - probe;
  const auto pressedBy = [&](const ClosestPoint& wall)
  { return push.dot(wall.Normal) - this->GapTo(wall); };
  const ClosestPoint* const walls = this->Rigid.Walls();
  const ClosestPoint& wall = *std::max_element(walls, walls + this->Rigid.WallCount(),
                                               [&](const ClosestPoint& a, const ClosestPoint& b)
                                               { return pressedBy(a) < pressedBy(b); });
  const double along = push.dot(wall.Normal);
  ElasticForce& force = this->Push;
  this->PressedCount = 0;
  if (!(pressedBy(wall) > 0.0))
  {
    return;
  }
  const double depth = this->Felt.Depth * pressedBy(wall) / along;
  force = ElasticForce::Of(*this->Atlas, this->Surface->Model(), wall.Direction, depth,
                           this->ToolRadius, this->PatchRadius);
  this->PatchRadius = force.PatchRadius;
  this->Pressed[0] = {wall.Direction, force.ForceWorld.dot(wall.Normal), force.PatchRadius};
  this->PressedCount = 1;
  if (along < (1.0 - Alone) * this->Felt.Depth)
  {
    force.ForceWorld = force.ForceWorld.dot(wall.Normal) / this->Felt.Depth * push;
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
