#include "TradeMeasure.h"

#include "Progress.h"
#include "Refusal.h"
#include "SceneTool.h"
#include "Servo.h"
#include "StructureFollower.h"
#include "TradeErrors.h"
#include "Units.h"

#include <algorithm>
#include <limits>
#include <memory>

namespace palpate
{
namespace
{
// Time between two consecutive readings of a clock.
double GlanceOf(const Clock& clock)
{
  constexpr int Glances = 1001;
  std::vector<double> times;
  for (int glance = 0; glance < Glances; ++glance)
  {
    const std::int64_t began = clock.Now();
    times.push_back(static_cast<double>(clock.Now() - began));
  }
  return QuantileOf(times, 0.5);
}

// A scene with this structure alone, at scale 1.
TouchScene SceneOf(const ContactModel& model, const TradeTouch& touch)
{
  TouchScene scene;
  scene.Tool = MakeTool(touch.Tool);
  scene.Structures.emplace_back();
  // Not owned: it outlives the measurement.
  scene.Structures.front().Model =
      std::shared_ptr<const ContactModel>(std::shared_ptr<const ContactModel>(), &model);
  scene.Structures.front().Law.Stiffness = touch.Stiffness;
  return scene;
}

// Runs one structure along a path repeatedly.
class Rehearsal
{
public:
  Rehearsal(const ContactModel& model, const TradeTouch& touch, const TradePath& path,
            const Clock& clock)
      : Touch(touch), Path(path), Time(clock), Scene(SceneOf(model, touch)),
        Times(path.Ticks.size(), std::numeric_limits<double>::infinity()), Felt(path.Ticks.size())
  {
    RequireInput(this->Scene.Check());
    RequireInput(StructureFollower::Make(this->Scene.Structures.front(), this->Scene,
                                         ServoSettings().VelocityTimeConstant, this->Followers));
  }

  void Run(const ProgressFunction& progress)
  {
    const std::size_t strokes = this->Path.Strokes.size();
    for (int run = 0; run < this->Touch.Runs; ++run)
    {
      for (std::size_t stroke = 0; stroke < strokes; ++stroke)
      {
        const double done = run + static_cast<double>(stroke) / static_cast<double>(strokes);
        ReportProgress(progress, done / this->Touch.Runs, "touch");
        this->RunStroke(this->Path.Strokes[stroke], this->Path.EndOf(stroke));
      }
    }
  }

  void Fill(TradeRow& row) const
  {
    constexpr double RareTick = 0.999;
    constexpr double Least = 1.0; // ns, below the resolution of any clock
    const double glance = GlanceOf(this->Time);
    std::vector<double> times = this->Times;
    for (double& time : times)
    {
      time = std::max(time - glance, Least);
    }
    row.TickMean = MeanOf(times);
    row.TickMedian = QuantileOf(times, 0.5);
    row.TickRare = QuantileOf(times, RareTick);
    row.Rate = 1.0 / (SecondsPerNanosecond * row.TickRare);
    CompareWithTruth(this->Path, this->Felt, this->Touch.Stiffness, row);
  }

  std::size_t Bytes() const { return this->Followers.front().Bytes(); }

private:
  void RunStroke(std::size_t first, std::size_t end)
  {
    StructureFollower& follower = this->Followers.front();
    follower.Leave();
    FollowStep step;
    step.Passed = TradePath::Period;
    Vector3 before = this->Path.Ticks[first].ProbeWorld;
    for (std::size_t tick = first; tick < end; ++tick)
    {
      step.Last.PositionWorld = before;
      step.Now.PositionWorld = this->Path.Ticks[tick].ProbeWorld;
      step.HandVelocity = (step.Now.PositionWorld - before) / TradePath::Period;
      const std::int64_t began = this->Time.Now();
      const Vector3 force = follower.Follow(step);
      const std::int64_t ended = this->Time.Now();
      this->Times[tick] = std::min(this->Times[tick], static_cast<double>(ended - began));
      this->Felt[tick] = {!force.isZero(0.0), force, follower.Touched().ProxyWorld};
      before = step.Now.PositionWorld;
    }
  }

  const TradeTouch& Touch;
  const TradePath& Path;
  const Clock& Time;
  TouchScene Scene; // referenced by the followers
  std::vector<StructureFollower> Followers;
  std::vector<double> Times; // ns
  std::vector<FeltTick> Felt;
};
} // namespace

void MeasureTouch(const ContactModel& model, const TradeTouch& touch, const TradePath& path,
                  const Clock& clock, TradeRow& row, const ProgressFunction& progress)
{
  Rehearsal rehearsal(model, touch, path, clock);
  rehearsal.Run(progress);
  rehearsal.Fill(row);
  row.Bytes = static_cast<double>(model.Bytes() + rehearsal.Bytes());
}
} // namespace palpate
