#pragma once

#include "FieldContactCases.h"

#include <memory>

namespace palpate::test
{
/// A hand's motion on short paths: 1 kHz, lengths in mm.
struct TouchPath
{
  static constexpr double Start = 0.2; ///< above the surface
  static constexpr double Depth = 1.5;
  static constexpr int ApproachTicks = 17; ///< at 100 mm/s
  static constexpr int SlideTicks = 12;
  static constexpr double Slide = 0.05; ///< per tick: 50 mm/s
  static constexpr int Ticks = ApproachTicks + SlideTicks;
};

/// Walks over a radial model, along a great circle of directions.
class RadialWalk
{
public:
  RadialWalk(const RadialModel& model, Random& random)
      : Model(model), Place(RandomDirection(random)),
        Axis(Place.cross(RandomDirection(random)).normalized())
  {
  }
  Vector3 PointWorld() const { return this->Model.PointWorld(this->Place); }
  Vector3 Normal() const { return this->Model.Normal(this->Place); }
  void Step(double length)
  {
    const double angle = length / this->Model.Radius(this->Place);
    this->Place = (Eigen::AngleAxisd(angle, this->Axis) * this->Place).normalized();
  }

private:
  const RadialModel& Model;
  Vector3 Place;
  Vector3 Axis;
};

/// Walks over the surface of a field, from its point nearest to `near`.
class FieldWalk
{
public:
  FieldWalk(const FieldSampler& sampler, const Vector3& near, Random& random)
      : Sampler(sampler), Place(near), Path(RandomDirection(random))
  {
    this->Settle();
  }
  const Vector3& PointWorld() const { return this->Place; }
  const Vector3& Normal() const { return this->Outward; }
  void Step(double length)
  {
    this->Path = (this->Path - this->Path.dot(this->Outward) * this->Outward).normalized();
    this->Place += length * this->Path;
    this->Settle();
  }

private:
  void Settle()
  {
    for (int step = 0; step < 8; ++step)
    {
      const FieldGradientSample sample = this->Sampler.ValueAndGradientWorld(0, this->Place);
      this->Outward = -sample.Gradient.normalized();
      this->Place += sample.Value / sample.Gradient.norm() * this->Outward;
    }
  }

  const FieldSampler& Sampler;
  Vector3 Place;
  Vector3 Path;
  Vector3 Outward;
};

/// Approaches a surface, presses and slides: calls visit(probe) for each tick of one path of a tool
/// with this radius.
template <typename Walk, typename Visit>
void FollowTouchPath(Walk walk, double toolRadius, const Visit& visit)
{
  for (int tick = 0; tick < TouchPath::Ticks; ++tick)
  {
    const double part = std::min(1.0, 1.0 * tick / (TouchPath::ApproachTicks - 1));
    const double height = (1.0 - part) * TouchPath::Start - part * TouchPath::Depth;
    visit(Vector3(walk.PointWorld() + (toolRadius + height) * walk.Normal()));
    if (tick + 1 >= TouchPath::ApproachTicks)
    {
      walk.Step(TouchPath::Slide);
    }
  }
}
} // namespace palpate::test
