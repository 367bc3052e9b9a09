#pragma once

#include "ClosestPoint.h"
#include "ClosestPointSearch.h"
#include "SphericalTriangle.h"
#include "SurfaceKind.h"

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
  // Within a finest node of the search's tree.
  struct Triangle
  {
    int Leaf; // of one that is a whole node, else None
    bool IsEvaluated;
    SphericalTriangle Corners; // without a leaf
    SphericalCap Cap;
    SampleOf<Surface> Sample; // at the cap's centre
    typename ClosestPointDescentOf<Surface>::CapBounds Bounds;
  };
  struct Task;
  enum class Step
  {
    Settled,
    Again, // as another kind of cell
    Found, // a minimum
    Open
  };
  static constexpr int None = -1;
  static constexpr int WorkOfEvaluation = SurfaceKind<Surface>::WorkOfEvaluation;
  static constexpr int WorkOfBound = SurfaceKind<Surface>::WorkOfBound;
  static constexpr std::size_t Capacity = SurfaceKind<Surface>::ProofCells;

  void BeginAfresh() noexcept;
  void GoTo(const Vector3& query) noexcept;
  void FindOpen() noexcept;
  void LeaveOpen(Task& task, double until) const noexcept;
  void LeaveOpen(Task& task, std::size_t first) const noexcept;
  void Settle(Task& task, std::size_t index) noexcept;
  Step SettleNode(Task& task, std::size_t index) noexcept;
  Step SettleTriangle(Task& task, std::size_t index) noexcept;
  Step Descend(Task& task, const Triangle& cell) noexcept;
  // The parts take the cell's place; returns false without memory.
  bool CutNode(std::size_t index) noexcept;
  bool CutTriangle(std::size_t index) noexcept;
  void Separate(std::size_t index) noexcept;
  std::size_t AddPart(std::size_t of, int part) noexcept;
  void Evaluate(Triangle& cell) noexcept;
  bool Clears(double lower, std::size_t index) noexcept;
  bool SettlesByBasin(const Task& task, std::size_t index) noexcept;
  const SphericalCap& CapOf(std::size_t index) const noexcept
  {
    const int node = this->Nodes[index];
    return node != None ? this->Search->Tree().CapOf(node) : this->Triangles[index].Cap;
  }
  // Cells with more clearance than this need no work.
  double Used() const noexcept { return this->PathLength + (this->Asked - this->Needed); }

  const ClosestPointSearchOf<Surface>* Search;
  double LeftOpen; // mm
  double Needed;   // mm, usually
  double Asked;    // mm, now
  Vector3 Query = Vector3::Zero();
  double PathLength = 0.0; // path length of the query since the cells were created, mm
  // Cells cover the parameters: nodes of the tree, and triangles. No point of a cell is closer than
  // this plus what the proof needs, minus the path length.
  std::array<double, Capacity> ClearUntil;
  std::array<int, Capacity> Nodes; // None for triangles
  std::array<Triangle, Capacity> Triangles;
  std::size_t CellCount = 0;
  // Those to work at, with the parts of cells that were cut.
  std::array<std::uint16_t, 3 * Capacity> Open;
  std::size_t OpenCount = 0;
  bool IsTurned = false; // those that lack least come first
};
using ClearanceProof = ClearanceProofOf<SphericalHarmonicModel>;
} // namespace palpate
