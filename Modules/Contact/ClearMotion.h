#pragma once

#include "ClearanceProof.h"
#include "ProvenBall.h"
#include "TouchableSurfaceModel.h"
#include "WedgePlaces.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>

namespace palpate
{
/// Moves a spherical tool without contact along its path, at a surface model.
///
/// As far above the surface as WedgePlaces found room, the nearest point is the minimum of the
/// distance that Newton's method continues: one evaluation a tick. Elsewhere a ClearanceProof shows
/// how far all of the surface is, apart from known minima. In the ball around that place a tick
/// takes no evaluation.
///
/// The work of a proof is limited; where it does not end, a search of the whole surface takes its
/// place. A step that the work of a tick does not prove is left to the next tick. For one thread;
/// does not allocate.
class ClearMotion
{
public:
  using ClosestPoint = TouchableSurfaceModel::ClosestPoint;
  using Proof = ClearanceProofOf<TouchableSurfaceModel::Shape>;

  /// `radius` is the tool's (mm), which the surface's margin enlarges at `places`; `stride` the
  /// longest step that stays with a minimum, `exactness` that of a minimum's distance (mm).
  /// Keeps the addresses of surface and places, which must outlive it. `clearance` is the proof of
  /// whoever else moves this tool at the surface; null for one of its own.
  ClearMotion(const TouchableSurfaceModel& surface, const WedgePlaces& places, double radius,
              double stride, double exactness, std::shared_ptr<Proof> clearance);

  /// Begins at a place (mm) where the tool is free, at the outer side of this minimum of the
  /// distance to it.
  void Begin(const Vector3& placeWorld, const ClosestPoint& minimum) noexcept;
  /// Moves towards the probe (mm), as far as about so many evaluations of the surface allow.
  /// Returns false on contact with Met() at PlaceWorld().
  bool MoveTo(const Vector3& probeWorld, int evaluations) noexcept;
  /// What the last MoveTo left of them.
  int Left() const noexcept { return this->EvaluationsLeft; }

  /// Without a proof that it shares.
  std::size_t Bytes() const noexcept
  {
    return sizeof(*this) + (this->Clearance.use_count() == 1 ? sizeof(Proof) : 0);
  }
  const Vector3& PlaceWorld() const noexcept { return this->Place; }
  const ClosestPoint& Met() const noexcept { return this->Wall; }
  /// Where the last step began, which was free.
  ProvenBall FreeBefore() const noexcept
  {
    return {this->Start, std::max(0.0, this->Radius - this->Slack)};
  }

private:
  static constexpr std::size_t MostMinima = 4;

  struct Minima
  {
    Vector3 PlaceWorld; // of the tool
    std::array<ClosestPoint, MostMinima> Each;
    std::size_t Count = 0;

    double Nearest() const noexcept;
    /// In place of the last one if there are too many.
    void Add(const ClosestPoint& found) noexcept
    {
      this->Count = std::min(this->Count, MostMinima - 1);
      this->Each[this->Count++] = found;
    }
  };
  enum class Step
  {
    Taken,
    TooLong,
    Met,
    Open
  };

  double RadiusAt(const ClosestPoint& minimum) const noexcept;
  Vector3 EndOfBall(const Vector3& probe) const noexcept;
  Step StepTo(const Vector3& start, const Vector3& goal) noexcept;
  bool IsHeldUp(const Vector3& probe) noexcept;
  bool IsFar(const Vector3& place) noexcept;
  bool IsAlone(const ClosestPoint& last, const ClosestPoint& next) const noexcept;
  Minima Continued(const Vector3& goal) noexcept;
  const ClosestPoint* Touched(const Minima& minima) const noexcept;
  void MeetFirst(const Vector3& start, const Vector3& goal, const ClosestPoint& minimum) noexcept;
  void Meet(const Vector3& start, const Vector3& goal, const ClosestPoint& minimum) noexcept;
  Step StepShortly(const Vector3& start, const Vector3& goal, Minima& minima) noexcept;
  bool IsShort(const Vector3& start, const Vector3& goal) const noexcept;
  Step Prove(const Vector3& start, const Vector3& goal, double needed, Minima& minima) noexcept;
  Step SearchAt(const Vector3& start, const Vector3& goal, double needed) noexcept;
  void Remember(const ClosestPoint& found) noexcept;
  double Search(const Vector3& goal, Minima& minima) noexcept;
  double Wanted(double needed, const Minima& minima) const noexcept;
  double With(const ClosestPoint& found, double needed, Minima& minima) noexcept;
  double PartOfGap(double part, double distance) const noexcept
  {
    return this->Free + part * (distance - this->Free);
  }
  Step TakeIf(bool isProven, const Vector3& goal, const Minima& minima, double others) noexcept;
  void Take(const Vector3& goal, const Minima& minima, double others) noexcept;
  bool IsExact(const ClosestPoint& minimum) const noexcept
  {
    return minimum.Converged() && minimum.DistanceError <= this->Exactness;
  }

  const TouchableSurfaceModel* Surface;
  const WedgePlaces* Places;
  double Radius;
  // mm from the centre of the tool, where nothing unknown may be; but see SearchAt.
  double Free;
  double Stride;
  double Exactness;
  double Slack;                     // mm
  std::shared_ptr<Proof> Clearance; // of everything but known minima
  int EvaluationsLeft = 0;
  Vector3 Place = Vector3::Zero();
  Vector3 Start = Vector3::Zero(); // of the last step
  // At the last measured place. While the tool is in the ball around it, it touches nothing.
  Vector3 BallCenter = Vector3::Zero();
  double BallRadius = 0.0; // mm
  Minima Known;
  ClosestPoint Wall{};
};
} // namespace palpate
