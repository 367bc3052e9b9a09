#include "TouchCost.h"

#include "HandPath.h"
#include "Median.h"
#include "Progress.h"
#include "Refusal.h"
#include "SceneTool.h"
#include "Servo.h"
#include "StructureFollower.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace palpate
{
namespace
{
constexpr double Period = 1e-3; // s
} // namespace

TouchCost MeasureTouchCost(const TouchContact& contact, const TouchToolSettings& tool,
                           const Clock& clock, const ProgressFunction& progress)
{
  constexpr int TicksBetweenQuestions = 256;
  TouchScene scene;
  scene.Tool = MakeTool(tool);
  scene.Structures.emplace_back();
  scene.Structures.front().Model = contact.Model;
  std::vector<StructureFollower> followers;
  HandPath path;
  RequireInput(scene.Check());
  RequireInput(PressesOf(scene, {}, path));
  RequireInput(StructureFollower::Make(scene.Structures.front(), scene,
                                       ServoSettings().VelocityTimeConstant, followers));
  std::vector<double> durations;
  FollowStep step;
  step.Passed = Period;
  step.Now.PositionWorld = path.At(0.0);
  const auto ticks = static_cast<int>(path.Duration() / Period);
  for (int tick = 1; tick <= ticks; ++tick)
  {
    if (tick % TicksBetweenQuestions == 0)
    {
      ReportProgress(progress, static_cast<double>(tick) / ticks, "time per tick");
    }
    step.Last = step.Now;
    step.Now.PositionWorld = path.At(Period * tick);
    step.HandVelocity = (step.Now.PositionWorld - step.Last.PositionWorld) / Period;
    const std::int64_t began = clock.Now();
    followers.front().Follow(step);
    const std::int64_t ended = clock.Now();
    if (followers.front().Touched().IsTouching)
    {
      durations.push_back(static_cast<double>(ended - began));
    }
  }
  return durations.empty() ? TouchCost() : TouchCost{UpperMedian(durations), durations.size()};
}
} // namespace palpate
