#include "StructureScene.h"

#include "HarmonicContactModel.h"
#include "ManyStructures.h"
#include "RandomShapes.h"

#include <algorithm>
#include <chrono>
#include <malloc.h>
#include <stdexcept>

namespace palpate::bench
{
namespace
{
using BenchClock = std::chrono::steady_clock;

constexpr double Apart = 60.0;             // mm
constexpr double Step = 0.05;              // mm a tick: 50 mm/s at 1 kHz
constexpr double Depth = 1.5;              // mm
constexpr std::int64_t Period = 1'000'000; // ns

SphericalHarmonicModel OrganAtOrigin()
{
  test::Random random(12);
  const SphericalHarmonicModel organ = test::RandomOrgan(random, 12);
  return {organ.Degree(), organ.Coefficients(), Vector3::Zero()};
}

std::vector<Vector3> StrokeOver(const SphericalHarmonicModel& organ, double toolRadius)
{
  std::vector<Vector3> path;
  Vector3 u = Vector3::UnitX();
  const Eigen::AngleAxisd turn(Step / 20.0, Vector3(0.2, 0.3, 1.0).normalized());
  while (path.size() < StructureScene::Ticks)
  {
    path.push_back(organ.PointWorld(u) + (toolRadius - Depth) * organ.Normal(u));
    u = (turn * u).normalized();
  }
  return path;
}

std::shared_ptr<const TouchScene> SceneOf(int count)
{
  auto scene = std::make_shared<TouchScene>(test::ManyStructures(count, Apart));
  const auto organ = std::make_shared<const SphericalHarmonicModel>(OrganAtOrigin());
  const Status status = HarmonicContactModel::Make(organ, HarmonicContactMode::Nearest,
                                                   scene->Structures.front().Model);
  if (!status.IsOk())
  {
    throw std::runtime_error(status.Message());
  }
  return scene;
}

double BytesInUse()
{
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<double>(heap.uordblks + heap.hblkhd);
}
} // namespace

StructureScene::StructureScene(int count) : Applied(Ticks), Loop(this->Device, {})
{
  const std::shared_ptr<const TouchScene> scene = SceneOf(count);
  this->Path = StrokeOver(OrganAtOrigin(), scene->Tool.Radius());
  const double before = BytesInUse();
  const auto start = BenchClock::now();
  const Status status = this->Loop.Publish(scene);
  this->Seconds = std::chrono::duration<double>(BenchClock::now() - start).count();
  this->Bytes = (BytesInUse() - before) / count;
  if (!status.IsOk())
  {
    throw std::runtime_error(status.Message());
  }
}

void StructureScene::TickAt(std::size_t place)
{
  this->Device.Next.Position = this->Path[place];
  this->Device.Next.Time = this->Tick.Started;
  this->Loop.Tick(this->Tick);
  ++this->Tick.Number;
  this->Tick.Scheduled = this->Tick.Started += Period;
}

// There and back, so that strokes join.
void StructureScene::Stroke()
{
  for (std::size_t n = 0; n < Ticks; ++n)
  {
    this->TickAt(n < Ticks / 2 ? n : Ticks - 1 - n);
    this->Applied[n] = this->Device.Applied;
  }
}

void StructureScene::StrokeTimed(std::vector<double>& shortest)
{
  shortest.resize(Ticks, INFINITY);
  for (std::size_t n = 0; n < Ticks; ++n)
  {
    const auto start = BenchClock::now();
    this->TickAt(n < Ticks / 2 ? n : Ticks - 1 - n);
    const std::chrono::duration<double, std::nano> spent = BenchClock::now() - start;
    shortest[n] = std::min(shortest[n], spent.count());
    this->Applied[n] = this->Device.Applied;
  }
}
} // namespace palpate::bench
