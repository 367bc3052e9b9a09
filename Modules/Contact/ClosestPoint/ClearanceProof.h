#pragma once

#include "ClosestPoint.h"
#include "ClosestPointSearch.h"
#include "MovedBounds.h"
#include "OpenCells.h"
#include "ProofCells.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/// Proves from step to step that no part of a surface other than known minima is closer to a moving
/// point than a given distance, or finds the part that is. It keeps the bounds of cells of
/// directions while the point moves (README.md). Memory is fixed; queries do not allocate. They
/// cache their results, so a proof is for one thread.
template <typename Surface>
class ClearanceProofOf
{
public:
  using ClosestPoint = ClosestPointOf<Surface>;

  enum class Finding
  {
    Clear,  ///< nothing but the known minima is closer, up to the tolerance
    Nearer, ///< an unknown minimum is closer
    Open    ///< the limit of work was reached
  };
  struct Answer
  {
    Finding State;
    double LowerDistance; ///< no point except known minima is closer, mm; for Clear and Open
    int Evaluations;      ///< work done, as below
    ClosestPoint Minimum; ///< of Nearer
  };

  /// Minima whose directions differ by less (rad) count as one.
  static constexpr double Apart = 0.003;

  /// `distance` > `tolerance` > 0, mm. Keeps the address of the search, which must outlive it.
  ClearanceProofOf(const ClosestPointSearchOf<Surface>& search, double distance,
                   double tolerance) noexcept;
  double Tolerance() const noexcept { return this->LeftOpen; }

  /// `known` are minima of the distance to `queryWorld` (mm; at most 1e100), tracked there, at most
  /// MostKnown. Works as long as about `evaluationLimit` evaluations of the surface with its first
  /// two derivatives take; what remains open is continued by the next query.
  Answer Ask(const Vector3& queryWorld, const ClosestPoint* known, std::size_t knownCount,
             int evaluationLimit) noexcept;
  /// The same for another distance, up to the tolerance, preferably less. Known minima count for
  /// everything within the angle `apart` (rad).
  Answer AskWithin(double distance, const Vector3& queryWorld, const ClosestPoint* known,
                   std::size_t knownCount, int evaluationLimit, double apart = Apart) noexcept;
  static constexpr std::size_t MostKnown = 8;

private:
  using Triangle = typename ProofCells<Surface>::Triangle;
  typedef FourLanes Clearances __attribute__((may_alias)); // of a group
  struct Task;
  enum class Step
  {
    Settled,
    Again, // as another kind of cell
    Found, // a minimum
    Open
  };
  static constexpr int None = ProofCells<Surface>::None;
  static constexpr int WorkOfEvaluation = SurfaceKind<Surface>::WorkOfEvaluation;
  static constexpr int WorkOfBound = SurfaceKind<Surface>::WorkOfBound;
  static constexpr int WorkOfGroup = SurfaceKind<Surface>::WorkOfGroup;
  static constexpr std::size_t Groups = ProofCells<Surface>::Groups;
  static constexpr std::size_t CellCapacity = ProofCells<Surface>::Capacity;

  void BeginAfresh() noexcept;
  bool IsNearlyFull() noexcept;
  void GatherNear() noexcept;
  void GoTo(const Vector3& query) noexcept;
  int WorkOfLook(int workLeft) const noexcept;
  void MoveBounds(double rounding) noexcept;
  void BoundMoved(Task& task) noexcept;
  void BoundGroup(const Task& task, std::size_t group) noexcept;
  void Improve(const Task& task, std::size_t index, double lower, const Vector3& point,
               double extent) noexcept;
  void AddOpenOf(std::size_t group) noexcept;
  void AddGroup(std::size_t group) noexcept;
  // Whether BoundGroup has bounded the group at this place.
  bool IsBounded(std::size_t group) const noexcept
  {
    return this->BoundedAt[group] == this->Bounded;
  }
  void LeaveOpen(Task& task, double until) const noexcept;
  void LeaveOpen(Task& task, std::size_t first) const noexcept;
  void Settle(Task& task, std::size_t index) noexcept;
  Step SettleNode(Task& task, std::size_t index) noexcept;
  Step SettleTriangle(Task& task, std::size_t index) noexcept;
  Step Descend(Task& task, const Triangle& cell) noexcept;
  Step CutNode(Task& task, std::size_t index) noexcept;
  Step CutTriangle(std::size_t index) noexcept;
  bool Clears(double lower, std::size_t index) noexcept;
  bool SettlesByBasin(const Task& task, const SphericalCap& cap, std::size_t index) noexcept;
  double LowerDistanceOf(std::size_t index) noexcept;
  void KeepBound(std::size_t index, double lower, const Vector3& point, double extent) noexcept;
  // Whether that is less than a path length.
  bool IsUsedUp(std::size_t group, double used) const noexcept
  {
    const auto isUsed = reinterpret_cast<const Clearances&>(
                            this->Cells.ClearUntil[MovedBounds::Count * group]) < used;
    return ((isUsed[0] | isUsed[1]) | (isUsed[2] | isUsed[3])) != 0;
  }
  // Cells with more clearance than this need no work.
  double Used() const noexcept { return this->PathLength + (this->Asked - this->Needed); }

  const ClosestPointSearchOf<Surface>* Search;
  double LeftOpen; // mm
  double Needed;   // mm, usually
  double Asked;    // mm, now
  Vector3 Query = Vector3::Zero();
  double PathLength = 0.0; // path length of the query since the cells were created, mm
  ProofCells<Surface> Cells;
  std::array<std::uint32_t, Groups> BoundedAt{};
  // The groups of cells whose clearance may be used up before a path length.
  std::array<std::uint16_t, Groups> Near;
  std::size_t NearCount = 0;
  double NearUntil = 0.0;                  // mm
  std::array<std::uint16_t, Groups> Moved; // of them, those whose clearance is used up
  std::size_t MovedCount = 0;
  OpenCells<CellCapacity> Open; // at the query
  double BoundedFor = 0.0;      // Used() where groups were bounded, mm
  std::uint32_t Bounded = 0;    // a number for that place
  bool IsTurned = false;        // those that lack least come first
};
using ClearanceProof = ClearanceProofOf<RadialModel>;
} // namespace palpate
