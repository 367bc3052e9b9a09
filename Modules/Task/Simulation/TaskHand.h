#pragma once

#include "HandSkill.h"
#include "HandTremor.h"
#include "LoopSchedule.h"
#include "ManualClock.h"
#include "PalpateTaskModule.h"
#include "TaskSettings.h"
#include "TaskWatch.h"
#include "TouchRun.h"
#include "TouchSession.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <random>
#include <vector>

namespace palpate
{
/// A simulated hand that holds the simulated device of a touch session in virtual time. It has no
/// knowledge but what a person has: it sees places on surfaces (with errors), sees where the tool
/// is, and feels forces (with errors). Everything is done by ticks of the servo that serves people.
///
/// Movements have the least jerk (Flash and Hogan 1985) and end where MovementDeviation puts them;
/// tremor is added all the time. Movements do nothing once a limit has ended the trial.
class PALPATETASK_EXPORT TaskHand
{
public:
  static constexpr double Hover = 5.0;         ///< mm above what is approached
  static constexpr double LongestReach = 15.0; ///< mm, for a contact

  /// Starts outside of the scene, towards `from` (unit) from its centre. Keeps the addresses.
  /// Throws InputError if the scene cannot be touched.
  TaskHand(const PreparedTouch& touch, const TaskSettings& task, bool hasForce,
           const HandSkill& skill, const Vector3& from, std::uint64_t seed);

  /// Straight to a place of the tool (world, mm).
  void MoveTo(const Vector3& toolWorld) { this->MoveTo(toolWorld, this->Skill.Speed); }
  void MoveTo(const Vector3& toolWorld, double speed);
  /// Round the scene, outside of everything, then straight.
  void TravelTo(const Vector3& toolWorld);
  void Hold(double seconds);

  /// Pushes along a direction until the tool is that deep in something; gives up after `most` mm.
  void PressTo(double depth, const Vector3& direction, double most);
  /// Moves along a direction until a force is felt, and waits for the hand to stop; false after
  /// `most` mm without.
  bool ReachForContact(const Vector3& direction, double most);
  /// The mean force over a while, as it is perceived, N.
  double PerceiveForce(double seconds);
  /// Along a line through points; what pushes back, or is seen to be touched, is avoided. The
  /// tool's way is kept for the answer.
  void Follow(const std::vector<Vector3>& points, bool avoidsContact);

  /// The place where the tool would rest on what lies between two points, as it is seen.
  std::optional<TouchRay::Rest> Look(const Vector3& from, const Vector3& to);
  /// A normally distributed error.
  double Error(double deviation) { return deviation * this->Normal(this->Random); }
  Vector3 Errors(double deviation);
  /// A place as it is seen: errors along the surface, and in depth along the normal.
  Vector3 See(const Vector3& pointWorld, const Vector3& normal);

  /// From now on this scene is felt, with the tool where it is.
  void Feel(TouchScene scene);
  const TouchScene& Scene() const { return *this->Session.Scene(); }
  /// That the hand began with.
  const TouchScene& FirstScene() const { return *this->First; }

  bool HasForce() const { return this->FeelsForce; }
  /// Where the hand has the tool, whatever holds it.
  Vector3 ProbeWorld() const { return Vector3(this->Now.ProbeWorld); }
  Vector3 AimWorld() const { return this->Aim; }
  Vector3 TipWorld() const { return this->Watch.TipWorld(this->Now); }
  const TaskWatch& Watched() const { return this->Watch; }
  const Vector3& Center() const { return this->SceneCenter; }
  double Outside() const { return this->SceneRadius; } ///< mm from the centre
  double ToolRadius() const { return this->Radius; }

private:
  bool Tick(const Vector3& aimWorld);

  HandSkill Skill;
  std::shared_ptr<const TouchScene> First;
  bool FeelsForce;
  std::mt19937_64 Random;
  std::normal_distribution<double> Normal;
  HandTremor Tremor;
  Vector3 SceneCenter;
  double SceneRadius;
  double Radius;
  double Period; // s
  WorkspaceFrame Frame;
  TaskWatch Watch;
  ManualClock Time;
  LoopSchedule Schedule;
  TouchSession Session;
  Vector3 Aim; // world
  TouchState Now;
  std::uint64_t Ticks = 0;
};
} // namespace palpate
