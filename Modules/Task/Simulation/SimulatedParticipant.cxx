#include "SimulatedParticipant.h"

#include "BodyDocker.h"
#include "ForcePerception.h"
#include "MaskPuller.h"
#include "MaskTruth.h"
#include "MeshConversion.h"
#include "PoseMap.h"
#include "Refusal.h"
#include "SceneSurfaces.h"
#include "TargetScene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr double PressDepth = 3.0;      // mm; linear elasticity holds for a finger's size
constexpr double PressSeconds = 0.2;    // of a press that is judged
constexpr double LightPress = 0.8;      // mm that a hand pushes into what it follows
constexpr double SpacingOfSizing = 3.0; // mm
constexpr int StepsOfSizing = 5;

// Axes of the side that is palpated.
std::array<Vector3, 2> AxesAcross(const Vector3& side)
{
  const Vector3 right = side.unitOrthogonal();
  return {{right, side.cross(right)}};
}

// How far from its start a profile stays above a level, between its samples by a line.
double WidthAbove(const std::vector<double>& profile, double level, double spacing)
{
  for (std::size_t i = 1; i < profile.size(); ++i)
  {
    if (profile[i] < level)
    {
      const double part = (profile[i - 1] - level) / (profile[i - 1] - profile[i]);
      return spacing * (static_cast<double>(i) - 1.0 + std::clamp(part, 0.0, 1.0));
    }
  }
  return spacing * static_cast<double>(profile.size() - 1);
}
} // namespace

TaskAnswer SimulatedParticipant::Do(TaskKind kind, const TaskTarget& target)
{
  switch (kind)
  {
  case TaskKind::Nodule:
    return this->FindNodule(target);
  case TaskKind::Landmarks:
    return this->MarkLandmarks(target);
  case TaskKind::Outline:
    return this->DrawOutline(target);
  case TaskKind::Path:
    return this->FollowPath(target);
  case TaskKind::Mask:
    return this->CorrectMask(target);
  case TaskKind::Dock:
    return this->DockBody(target);
  }
  return {};
}

// 0 where there is nothing to press, and once the trial is over.
double SimulatedParticipant::Press(const TaskTarget& target, const FreePlace& place)
{
  const Vector3 side = target.Side.normalized();
  const auto [right, up] = AxesAcross(side);
  const Vector3 over =
      this->Hand.Center() + place.x() * right + place.y() * up + this->Hand.Outside() * side;
  const Vector3 seen = this->Hand.See(over, side);
  const auto rest = this->Hand.Look(seen, seen - 1.5 * this->Hand.Outside() * side);
  if (!rest || this->Hand.Watched().IsOver())
  {
    return 0.0;
  }
  this->Hand.MoveTo(rest->ToolWorld + TaskHand::Hover * rest->NormalWorld);
  this->Hand.PressTo(PressDepth, -rest->NormalWorld, TaskHand::LongestReach + TaskHand::Hover);
  const double force = this->Hand.PerceiveForce(PressSeconds);
  this->Pressed = this->Hand.TipWorld();
  this->Hand.MoveTo(rest->ToolWorld + TaskHand::Hover * rest->NormalWorld);
  return force;
}

TaskAnswer SimulatedParticipant::FindNodule(const TaskTarget& target)
{
  PalpationSearch::Technique technique;
  technique.Reach = target.Reach;
  technique.Sweeps = this->Skill.Sweeps;
  technique.Returns = this->Skill.Returns;
  const PalpationSearch search(technique);
  const auto finding =
      search.Search([&](const FreePlace& place) { return this->Press(target, place); }, this->Seed);
  TaskAnswer answer;
  if (finding && !this->Hand.Watched().IsOver())
  {
    static_cast<void>(this->Press(target, finding->Place));
    answer.PointsWorld.push_back(this->Pressed);
    answer.Diameter = this->SizeOf(target, *finding);
  }
  return answer;
}

double SimulatedParticipant::SizeOf(const TaskTarget& target,
                                    const PalpationSearch::Finding& finding)
{
  double width = 0.0;
  for (const FreePlace& direction :
       {FreePlace(1, 0), FreePlace(-1, 0), FreePlace(0, 1), FreePlace(0, -1)})
  {
    std::vector<double> profile{finding.Contrast};
    while (profile.size() <= StepsOfSizing && profile.back() >= 0.5 * finding.Contrast)
    {
      const FreePlace place =
          finding.Place + SpacingOfSizing * static_cast<double>(profile.size()) * direction;
      profile.push_back(ForcePerception::Contrast(this->Press(target, place), finding.Usual));
    }
    width += WidthAbove(profile, 0.5 * finding.Contrast, SpacingOfSizing);
  }
  return 0.5 * width;
}

TaskAnswer SimulatedParticipant::MarkLandmarks(const TaskTarget& target)
{
  TaskAnswer answer;
  for (const TaskPoint& point : target.Points)
  {
    const Vector3 mark = this->Mark(point.PointWorld);
    answer.PointsWorld.push_back(
        this->Hand.Watched().IsOver()
            ? Vector3(Vector3::Constant(std::numeric_limits<double>::quiet_NaN()))
            : mark);
  }
  return answer;
}

Vector3 SimulatedParticipant::Mark(const Vector3& pointWorld)
{
  const Vector3 outwards = (pointWorld - this->Hand.Center()).stableNormalized();
  const auto rest =
      this->Hand.Look(this->Hand.Center() + this->Hand.Outside() * outwards, this->Hand.Center());
  const Vector3 normal = rest ? rest->NormalWorld : outwards;
  const Vector3 seen = this->Hand.See(pointWorld, normal);
  const double radius = this->Hand.ToolRadius();
  const Vector3 over = seen + (radius + TaskHand::Hover) * normal;
  this->Hand.TravelTo(over);
  this->Hand.MoveTo(over); // corrects what is seen of the long movement's error
  if (this->Hand.HasForce())
  {
    this->Hand.ReachForContact(-normal, TaskHand::LongestReach);
  }
  else
  {
    this->Hand.MoveTo(seen);
  }
  this->Hand.Hold(PressSeconds);
  return this->Hand.TipWorld();
}

TaskAnswer SimulatedParticipant::DrawOutline(const TaskTarget& target)
{
  Vector3 middle = Vector3::Zero();
  for (const TaskPoint& point : target.Points)
  {
    middle += point.PointWorld / static_cast<double>(target.Points.size());
  }
  // The tool's sphere lies outside; it is pressed lightly against what is felt.
  const double outside = this->Hand.HasForce() ? this->Hand.ToolRadius() - LightPress : 0.0;
  std::vector<Vector3> line;
  for (const TaskPoint& point : target.Points)
  {
    line.emplace_back(point.PointWorld + outside * (point.PointWorld - middle).stableNormalized());
  }
  line.push_back(line.front());
  this->Hand.TravelTo(line.front());
  this->Hand.Follow(line, false);
  return {this->Hand.Watched().Trace()};
}

TaskAnswer SimulatedParticipant::FollowPath(const TaskTarget& target)
{
  std::vector<Vector3> line;
  for (const TaskPoint& point : target.Points)
  {
    line.push_back(point.PointWorld);
  }
  this->Hand.TravelTo(line.front());
  this->Hand.Follow(line, true);
  return {this->Hand.Watched().Trace()};
}

TaskAnswer SimulatedParticipant::CorrectMask(const TaskTarget& target)
{
  CorrectedShape mask = ReadWrongMask(target, this->Scene);
  const ComparedBody truth = ReadTrueMask(target, this->Scene);
  MaskPuller(this->Hand, this->Skill, truth).Correct(mask);
  return MaskAnswer(mask, truth);
}

TaskAnswer SimulatedParticipant::DockBody(const TaskTarget& target)
{
  CheckTarget(TaskKind::Dock, target, this->Scene);
  SceneSettings bodies = this->Scene;
  bodies.Structures.resize(2);
  const auto surfaces = DisplayedSurfaces(bodies, [](double, const std::string&) { return true; });
  const IndexedMesh place = ToIndexedMesh(surfaces.back());
  HeldFit fit;
  RequireInput(
      HeldFit::Make(ToIndexedMesh(surfaces.front()), place, HeldFitSettings::ForHand(place), fit),
      target.Scene.string());
  const Vector3& center = target.Points.front().PointWorld;
  BodyDocker docker(this->Hand, this->Skill, std::make_shared<const HeldFit>(std::move(fit)));
  const TaskPose pose = PoseOf(docker.Dock(MapOf(target.Pose, center)), center);
  TaskAnswer answer;
  answer.Shift = pose.Shift;
  answer.Turn = pose.Turn;
  return answer;
}
} // namespace palpate
