#pragma once

#include "ClearanceProof.h"
#include "ClosestPoint.h"
#include "HalfSpaces.h"
#include "ProvenBall.h"
#include "TouchableRadialModel.h"
#include "TouchableSurfaceModel.h"
#include "WedgeGroove.h"
#include "WedgeLimits.h"

#include <array>
#include <cstddef>
#include <memory>

namespace palpate
{
/// Keeps a sphere out of a surface with hollows that are too narrow for it: moves it to
/// the place nearest to a goal where no part of the surface is nearer than its radius. Several
/// walls, that is separate minima of the distance, are tracked; their tangent planes allow a next
/// place, where the walls are evaluated again, and so on. At the end, ClearanceProof checks for
/// walls that were not known. The sphere is never moved to an unproven place.
///
/// At a surface model a wall keeps out of the side where the sphere was free, and the steps
/// between free places are shorter than the sphere, so that no sheet of the surface is stepped over
/// wherever the surface crosses itself.
template <typename Surface>
class ContactWedgeOf
{
public:
  using ClosestPoint = typename Surface::ClosestPoint;
  using Proof = ClearanceProofOf<typename Surface::Shape>;

  /// Walls are known, too, that keep the sphere from `ahead` (mm) further along its normal, were it
  /// larger by that; see LookAhead.
  ContactWedgeOf(std::shared_ptr<const Surface> surface, double radius, double ahead = 0.0);
  /// The proof that it keeps from step to step, for others that move the same sphere.
  const std::shared_ptr<Proof>& Clearance() const noexcept { return this->Clear; }

  /// False if a sphere (mm) touches in at most one place wherever it rolls, tested at some thousand
  /// places with a sphere a tenth larger. Takes milliseconds.
  static bool IsNeeded(const Surface& surface, double radius);
  /// The same at one place, by its direction or parameter.
  static bool IsNeededAt(const Surface& surface, const Vector3& direction, double radius);

  /// Starts at the surface's nearest point to the sphere: in place if the sphere is free there,
  /// else pushed out by that wall. What is known to be free near there lets it move on where the
  /// proof does not end at once.
  void Begin(const ClosestPoint& nearest, const ProvenBall& known = {}) noexcept;
  /// Moves from the last place towards the goal with at most about so many evaluations of the
  /// surface, or in each proof so many where the surface does not count all work; Normal() is then
  /// the combined normal of the walls.
  void MoveTo(const Vector3& goalWorld, int evaluations = WedgeLimits::EvaluationsOfProof) noexcept;
  /// What the last MoveTo left of them.
  int Left() const noexcept { return this->EvaluationsLeft; }
  /// Whether the last MoveTo ended at the place nearest to the goal; else the next one goes on.
  bool HasArrived() const noexcept { return this->IsAtGoal; }

  /// Searches for walls that the sphere does not touch yet: those that a sphere larger by `ahead`
  /// would touch if the walls that hold this one held it. Between two walls that enclose an angle
  /// of 120 degrees, the other one is found when its gap is half of `ahead`. Takes a proof.
  void LookAhead() noexcept;

  const Vector3& CenterWorld() const noexcept { return this->Center; }
  const Vector3& Normal() const noexcept { return this->JointNormal; }
  /// Whether a wall keeps the sphere from the goal; otherwise it has left the surface.
  bool IsHeld() const noexcept { return this->IsKeptBack; }
  /// The known walls, at the sphere's place.
  const ClosestPoint* Walls() const noexcept { return this->Known.data(); }
  std::size_t WallCount() const noexcept { return this->KnownCount; }
  /// The nearest of the known walls, none of which may be near; null without any.
  const ClosestPoint* NearestWall() const noexcept;
  /// The wall that holds the sphere if no other one is known near it; else null.
  const ClosestPoint* OnlyWall() const noexcept
  {
    return this->KnownCount == 1 && this->IsKeptBack && this->IsClear ? &this->Known[0] : nullptr;
  }
  std::size_t Bytes() const noexcept
  {
    return sizeof(*this) + (this->ClearanceAhead ? 2 : 1) * sizeof(Proof);
  }
  /// The longest step (mm) between two proofs. Farther walls may be unknown.
  double Step() const noexcept { return this->LongestStep; }

private:
  static constexpr std::size_t MostWalls = 6;
  static_assert(MostWalls <= Proof::MostKnown, "a proof takes all walls");

  // Largest distance (mm) of the next step from a proven place.
  struct Leash
  {
    Vector3 ClearWorld;
    double Length;
  };

  // The walls that hold the sphere at a place that their planes allow.
  struct Holders
  {
    std::array<std::size_t, MostWalls> Each;
    std::size_t Count = 0;
  };

  // The last wall, at this parameter, that was continued to a goal.
  struct WallAtGoal
  {
    Vector3 From = Vector3::Zero();
    Vector3 GoalWorld = Vector3::Zero();
    ClosestPoint Wall{};
  };

  enum class Rolling
  {
    Done,
    Kept,     // by other walls
    NoMinimum // of the distance from the goal, which takes long to find out
  };

  void Approach(const Vector3& goalWorld) noexcept;
  void Count(int evaluations) noexcept
  {
    this->EvaluationsLeft -= Surface::CountsAllWork ? evaluations : 0;
  }
  void GoBack(const Leash& leash) noexcept;
  void Shorten(Leash& leash) noexcept;
  Vector3 NextGoal(const Vector3& goalWorld, const Leash& leash) const noexcept;
  std::array<HalfSpace, MostWalls> Planes() const noexcept;
  bool Slide(const Vector3& goalWorld, const Leash& leash) noexcept;
  Holders HoldersAt(const Vector3& heldWorld, const HalfSpace* planes) const noexcept;
  WedgeGroove GrooveAt(const HalfSpace* planes, const Vector3& heldWorld,
                       const Vector3& goalWorld) const noexcept;
  const ClosestPoint& AtGoal(const Vector3& goalWorld, const ClosestPoint& wall,
                             const Leash& leash) noexcept;
  Rolling Roll(const Vector3& goalWorld, const Leash& leash, const HalfSpace* planes,
               const Vector3& heldWorld) noexcept;
  bool IsFartherOff(const Vector3& goalWorld, bool isThere, const Leash& leash) const noexcept;
  bool IsBadStep(double moved, double before) const noexcept;
  void PushOut() noexcept;
  void ReturnToWall(const Vector3& goalWorld) noexcept;
  void GoTo(const Vector3& placeWorld, const ClosestPoint* touched) noexcept;
  void Meet(const ClosestPoint& wall) noexcept;
  ClosestPoint Sided(const ClosestPoint& wall) const noexcept;
  bool IsClearOfWalls() const noexcept;

  std::shared_ptr<const Surface> Touched;
  double Radius;
  double LongestStep; // mm, between two proofs
  double Ahead;       // mm
  double Kept;        // mm, the gap up to which a wall is followed
  double End;         // mm, at which a slide ends
  std::shared_ptr<Proof> Clear;
  ProvenBall Around; // the last place that was proven
  std::unique_ptr<Proof> ClearanceAhead;
  Vector3 Center = Vector3::Zero();
  bool IsClear = false; // proven for the centre
  bool IsAtGoal = false;
  int EvaluationsLeft = 0; // in this tick
  bool IsKeptBack = false;
  Vector3 JointNormal = Vector3::UnitZ();
  std::array<ClosestPoint, MostWalls> Known{}; // at the centre
  std::size_t KnownCount = 0;
  WallAtGoal Rolled;
};
using ContactWedge = ContactWedgeOf<TouchableRadialModel>;
} // namespace palpate
