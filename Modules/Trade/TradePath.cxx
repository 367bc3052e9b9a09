#include "TradePath.h"

#include "InputError.h"
#include "Progress.h"
#include "SceneTool.h"
#include "SmoothStep.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

namespace palpate
{
namespace
{
constexpr double ApproachStep = 0.05;    // mm per tick: 50 mm/s
constexpr double ApproachDistance = 3.0; // mm
constexpr double LargestStep = 0.2;      // mm per tick: no hand follows a corner faster
constexpr int PressTicks = 80;
constexpr int SlideTicks = 350;

class Random
{
public:
  explicit Random(std::uint64_t seed) : Engine(seed) {}

  double Between(double least, double most)
  {
    // The distributions of standard libraries differ between implementations.
    constexpr double Step = 0x1p-53;
    return least + (most - least) * Step * static_cast<double>(this->Engine() >> 11U);
  }
  Vector3 Direction()
  {
    while (true)
    {
      const double x = this->Between(-1.0, 1.0);
      const double y = this->Between(-1.0, 1.0);
      const Vector3 point(x, y, this->Between(-1.0, 1.0));
      const double length = point.norm();
      if (length <= 1.0 && length > 0.1)
      {
        return point / length;
      }
    }
  }

private:
  std::mt19937_64 Engine;
};

// Depth over the ticks of a stroke: eased in, varying during the slide.
double DepthAt(int tick, double depth)
{
  const double part = std::min(1.0, static_cast<double>(tick) / PressTicks);
  return depth * (SmoothStep(part) - 0.2 * part * (1.0 - std::cos(0.05 * tick)));
}

// A hand guided by the reference's proxy.
class Hand
{
public:
  Hand(TradeReference& reference, double reach, double mostDepth, std::uint64_t seed,
       TradePath& path)
      : Reference(reference), Numbers(seed), Reach(reach), MostDepth(mostDepth), Path(path)
  {
  }

  // False if the approach met no surface.
  bool Stroke()
  {
    const Vector3 inward = -this->Numbers.Direction();
    const double depth = this->MostDepth * this->Numbers.Between(0.3, 1.0);
    const double step = this->Numbers.Between(0.02, 0.1); // mm per tick: 20 to 100 mm/s
    const std::optional<Vector3> touch = this->FirstTouch(inward);
    if (!touch)
    {
      return false;
    }
    this->Path.Strokes.push_back(this->Path.Ticks.size());
    this->Probe = *touch - ApproachDistance * inward;
    this->Reference.Begin(this->Probe);
    this->GoTo(this->Probe);
    const int mostTicks = static_cast<int>(2.0 * ApproachDistance / ApproachStep);
    for (int tick = 0; tick < mostTicks && !this->Truth().IsTouching; ++tick)
    {
      this->GoTo(this->Probe + ApproachStep * inward);
    }
    this->KnowApproach();
    this->Slide(depth, step);
    this->Leave();
    return true;
  }

private:
  const TradePosition& Truth() const { return this->Path.Ticks.back().Truth; }

  // Searches in coarse steps along a line through the centre; returns the last position outside.
  std::optional<Vector3> FirstTouch(const Vector3& inward)
  {
    constexpr double Step = 0.5; // mm
    const Vector3 middle = this->Reference.BoundsWorld().center();
    Vector3 outside = middle - (this->Reach + ApproachDistance) * inward;
    this->Reference.Begin(outside);
    const int steps = static_cast<int>(2.0 * this->Reach / Step);
    for (int n = 0; n < steps; ++n)
    {
      const Vector3 next = outside + Step * inward;
      if (this->Reference.At(next).IsTouching)
      {
        return outside;
      }
      outside = next;
    }
    return std::nullopt;
  }

  void GoTo(const Vector3& target)
  {
    const Vector3 path = target - this->Probe;
    const double length = path.norm();
    this->Probe += length > LargestStep ? Vector3(LargestStep / length * path) : path;
    this->Path.Ticks.push_back({this->Probe, this->Reference.At(this->Probe)});
    if (this->Truth().IsTouching)
    {
      this->Proxy = this->Truth().ProxyWorld;
      this->Normal = this->Truth().NormalWorld;
    }
  }

  // The normal, by which the uncertainty is judged, is known from the first contact on.
  void KnowApproach()
  {
    const double uncertainty = this->Truth().Uncertainty;
    for (std::size_t tick = this->Path.Strokes.back(); tick < this->Path.Ticks.size(); ++tick)
    {
      this->Path.Ticks[tick].Truth.Uncertainty = uncertainty;
    }
  }

  // Slides along the surface with the proxy.
  void Slide(double depth, double step)
  {
    constexpr double Wander = 0.05;
    if (!this->Truth().IsTouching)
    {
      return;
    }
    Vector3 ahead = this->Numbers.Direction();
    for (int tick = 1; tick <= PressTicks + SlideTicks; ++tick)
    {
      ahead += Wander * this->Numbers.Direction();
      ahead -= ahead.dot(this->Normal) * this->Normal;
      ahead = ahead.stableNormalized();
      const double along = tick > PressTicks ? step : 0.0;
      this->GoTo(this->Proxy + along * ahead - DepthAt(tick, depth) * this->Normal);
    }
  }

  void Leave()
  {
    const int mostTicks = static_cast<int>((this->MostDepth + ApproachDistance) / ApproachStep);
    const Vector3 outward = this->Normal;
    for (int tick = 0; tick < mostTicks; ++tick)
    {
      this->GoTo(this->Probe + ApproachStep * outward);
    }
  }

  TradeReference& Reference;
  Random Numbers;
  double Reach; // mm from the centre of the bounds, beyond which there is no contact
  double MostDepth;
  TradePath& Path;
  Vector3 Probe = Vector3::Zero();
  Vector3 Proxy = Vector3::Zero();   // at the last contact
  Vector3 Normal = Vector3::UnitZ(); // there
};
} // namespace

TradePath MakeTradePath(TradeReference& reference, const TouchToolSettings& tool,
                        const TradePathSettings& settings, const ProgressFunction& progress)
{
  constexpr int MostMisses = 1000;      // in a row
  constexpr double MostDepthPart = 0.1; // of the structure's smallest extent
  const Eigen::AlignedBox3d bounds = reference.BoundsWorld();
  TradePath path;
  path.MostDepth = std::min(settings.MostDepth, MostDepthPart * bounds.sizes().minCoeff());
  Hand hand(reference, 0.5 * bounds.diagonal().norm() + MakeTool(tool).BoundingRadius(),
            path.MostDepth, settings.Seed, path);
  const auto wanted = static_cast<std::size_t>(settings.Seconds / TradePath::Period);
  int misses = 0;
  while (path.Ticks.size() < wanted)
  {
    ReportProgress(progress, static_cast<double>(path.Ticks.size()) / static_cast<double>(wanted),
                   "path");
    misses = hand.Stroke() ? 0 : misses + 1;
    if (misses > MostMisses)
    {
      throw InputError("the tool meets no surface from any side; check the structure's size");
    }
  }
  return path;
}
} // namespace palpate
