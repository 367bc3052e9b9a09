#include "SurfaceTouch.h"

#include "OrganContact.h"
#include "SurfaceModelPath.h"
#include "WanderingDirection.h"
#include "WanderingHand.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <stdexcept>
#include <vector>

namespace palpate::bench
{
namespace
{
using TickClock = std::chrono::steady_clock;

struct Touched
{
  std::shared_ptr<const TouchableSurfaceModel> Surface;
  std::unique_ptr<ContactTracker> Tracker;
};

Touched MakeTouched(const SurfaceModel& surface, double toolRadius)
{
  Touched touched;
  std::shared_ptr<const ContactModel> model;
  Status status = TouchableSurfaceModel::Make(surface, touched.Surface);
  if (status.IsOk())
  {
    status = MakeOrganContact(surface, model);
  }
  if (status.IsOk())
  {
    status = model->MakeTracker(ToolShape::Sphere(toolRadius), {}, touched.Tracker);
  }
  if (!status.IsOk())
  {
    throw std::runtime_error(status.Message());
  }
  return touched;
}

ToolPose PoseAt(const Vector3& place)
{
  return {place, Eigen::Quaterniond::Identity()};
}

// A tool that was pressed through a thin wall is rightly held far from the probe; one that could
// move nearer is not.
class LagWatch
{
public:
  LagWatch(const TouchableSurfaceModel& surface, double radius) : Surface(surface), Radius(radius)
  {
  }

  void Watch(const Vector3& probe, const Contact& contact, TouchedTicks& counts)
  {
    constexpr double Far = 2.0; // mm
    // Nearer than this none is far, so that the search is rarely needed.
    const bool isFar = contact.IsTouching && contact.Depth > Far &&
                       contact.Depth > Far + this->Radius - this->NearestTo(probe).SignedDistance;
    const bool isLag = isFar && this->CanMove(contact.ProxyWorld, probe);
    counts.Lags += isLag ? 1 : 0;
    this->Held = isLag ? this->Held + 1 : 0;
    counts.LongestLag = std::max(counts.LongestLag, this->Held);
  }

private:
  TouchableSurfaceModel::ClosestPoint NearestTo(const Vector3& place) const
  {
    return this->Surface.SeenFrom(place, this->Surface.Search().Nearest(place, 5000));
  }
  // Along the wall towards the probe, or off the wall.
  bool CanMove(const Vector3& proxy, const Vector3& probe) const
  {
    constexpr double Step = 0.05; // mm
    const Vector3 normal = this->NearestTo(proxy).Normal;
    const Vector3 way = probe - proxy;
    const Vector3 along = way - std::min(0.0, way.dot(normal)) * normal;
    const Vector3 place =
        proxy + Step * along.normalized() + (this->Surface.Margin() + 0.1 * Step) * normal;
    return along.norm() > 0.1 * way.norm() && (probe - place).norm() < way.norm() &&
           this->NearestTo(place).SignedDistance > this->Radius;
  }

  const TouchableSurfaceModel& Surface;
  double Radius;
  long Held = 0;
};

// A path for times: without jumps.
std::vector<Vector3> StrokeOver(const SurfaceModel& surface, double toolRadius, long ticks)
{
  test::Random random(9203);
  std::uniform_real_distribution<double> step(0.02, 0.1); // mm
  test::WanderingDirection wandering(random);
  Vector3 last = surface.Point(wandering.Current());
  double angle = 0.002; // about a step
  std::vector<Vector3> path;
  for (long tick = 0; tick < ticks; ++tick)
  {
    const Vector3& parameter = wandering.Next(angle);
    const Vector3 point = surface.Point(parameter);
    const double moved = (point - last).norm();
    angle = std::clamp(angle * step(random) / std::max(moved, 1e-6), 0.25 * angle, 4.0 * angle);
    angle = std::clamp(angle, 1e-4, 0.02);
    last = point;
    const double height = -0.75 + 1.5 * std::sin(0.02 * static_cast<double>(tick));
    path.push_back(point + (toolRadius + height) * surface.Normal(parameter));
  }
  return path;
}
} // namespace

TouchedPaths TouchPaths(const SurfaceModel& surface, double toolRadius, long paths)
{
  const Touched touched = MakeTouched(surface, toolRadius);
  test::SurfaceTouchTruth truth(touched.Surface, toolRadius);
  test::Random random(9201);
  TouchedPaths result;
  for (long path = 0; path < paths; ++path)
  {
    touched.Tracker->Release();
    bool isFirst = true;
    bool isFree = false;
    test::FollowSurfacePath(surface, toolRadius, random,
                            [&](const Vector3& probe)
                            {
                              const Contact& contact = touched.Tracker->Follow(PoseAt(probe));
                              isFree = isFirst ? truth.Begin(probe) : isFree;
                              if (isFree)
                              {
                                truth.Judge(probe, contact, result.Counts);
                              }
                              isFirst = false;
                            });
    result.Paths += isFree ? 1 : 0;
  }
  return result;
}

TouchedTicks TouchByHand(const SurfaceModel& surface, double toolRadius, long ticks)
{
  const Touched touched = MakeTouched(surface, toolRadius);
  test::Random random(9202);
  test::WanderingHand hand(surface, toolRadius, random);
  LagWatch watch(*touched.Surface, toolRadius);
  TouchedTicks result;
  Vector3 last = Vector3::Zero();
  for (; result.Ticks < ticks; ++result.Ticks)
  {
    const Vector3 probe = hand.Next();
    const Contact& contact = touched.Tracker->Follow(PoseAt(probe));
    const Vector3 force = test::SurfaceTouchTruth::Stiffness * (contact.ProxyWorld - probe);
    result.Touching += contact.IsTouching ? 1 : 0;
    result.NotFinite += contact.IsValid && force.allFinite() ? 0 : 1;
    result.Jumps += !hand.IsJumping() && (force - last).norm() > 1.0 ? 1 : 0;
    last = force;
    watch.Watch(probe, contact, result);
  }
  return result;
}

std::vector<float> TimeTouch(const SurfaceModel& surface, double toolRadius, long ticks)
{
  constexpr int Runs = 5;
  const std::vector<Vector3> path = StrokeOver(surface, toolRadius, ticks);
  std::vector<float> times(path.size(), std::numeric_limits<float>::infinity());
  const Touched touched = MakeTouched(surface, toolRadius);
  for (int run = 0; run < Runs; ++run)
  {
    touched.Tracker->Release();
    for (std::size_t tick = 0; tick < path.size(); ++tick)
    {
      const TickClock::time_point start = TickClock::now();
      touched.Tracker->Follow(PoseAt(path[tick]));
      const float time = std::chrono::duration<float, std::micro>(TickClock::now() - start).count();
      times[tick] = std::min(times[tick], time);
    }
  }
  return times;
}
} // namespace palpate::bench
