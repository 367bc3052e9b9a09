#pragma once

#include "ClearanceProof.h"
#include "ClosestPoint.h"
#include "HalfSpaces.h"
#include "HarmonicSurface.h"

#include <array>
#include <cstddef>
#include <memory>

namespace palpate
{
/// Keeps a ball out of a star-shaped surface that has hollows too narrow for it: brings it to the
/// place nearest to a goal where no part of the surface is nearer than its radius. Some walls,
/// minima of the distance that are apart, are followed; their tangent planes allow a next place,
/// where the walls are asked again, and so on. Where that ends, ClearanceProof tells whether there
/// is a wall that was not known. The ball goes nowhere that is not proven.
class HarmonicWedge
{
public:
  HarmonicWedge(std::shared_ptr<const HarmonicSurface> surface, double radius);

  /// False if a ball (mm) touches in one place only wherever it may roll, found by trying some
  /// thousand places with a ball a tenth larger. Takes milliseconds.
  static bool IsNeeded(const HarmonicSurface& surface, double radius);

  /// At the surface's nearest point to the ball: where it is if it is free there, else pushed out
  /// by that wall.
  void Begin(const ClosestPoint& nearest) noexcept;
  /// Steps on from the last place; the walls' joint normal is then Normal().
  void MoveTo(const Vector3& goalWorld) noexcept;

  const Vector3& CenterWorld() const noexcept { return this->Center; }
  const Vector3& Normal() const noexcept { return this->JointNormal; }
  /// Whether a wall keeps the ball from the goal; one that none does has left the surface.
  bool IsHeld() const noexcept { return this->IsKeptBack; }

private:
  static constexpr std::size_t MostWalls = 6;
  static_assert(MostWalls <= ClearanceProof::MostKnown, "a proof takes all walls");

  // How far (mm) the next step may lead from a proven place.
  struct Leash
  {
    Vector3 ClearWorld;
    double Length;
  };

  void Approach(const Vector3& goalWorld) noexcept;
  void Shorten(Leash& leash) noexcept;
  Vector3 NextGoal(const Vector3& goalWorld, const Leash& leash) const noexcept;
  std::array<HalfSpace, MostWalls> Planes() const noexcept;
  bool Slide(const Vector3& goalWorld, const Leash& leash) noexcept;
  bool Roll(const Vector3& goalWorld, const Leash& leash, const HalfSpace* planes,
            const Vector3& heldWorld) noexcept;
  void ReturnToWall(const Vector3& goalWorld) noexcept;
  void GoTo(const Vector3& placeWorld, const ClosestPoint* touched) noexcept;
  void Meet(const ClosestPoint& wall) noexcept;
  bool IsClearOfWalls() const noexcept;

  std::shared_ptr<const HarmonicSurface> Surface;
  double Radius;
  double LongestStep; // mm, between two proofs
  double End;         // mm, of a slide
  ClearanceProof Proof;
  Vector3 Center = Vector3::Zero();
  bool IsClear = false; // proven for the centre
  bool IsKeptBack = false;
  Vector3 JointNormal = Vector3::UnitZ();
  std::array<ClosestPoint, MostWalls> Walls{}; // of the centre
  std::size_t WallCount = 0;
};
} // namespace palpate
