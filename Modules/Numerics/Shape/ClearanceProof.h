#pragma once

#include "ClosestPoint.h"
#include "ClosestPointSearch.h"
#include "SphericalTriangle.h"

#include <array>
#include <cstddef>

namespace palpate
{
/// Proves from step to step that no part of a surface is nearer to a moving place than a distance,
/// but for minima that are known, or finds the part that is.
///
/// The directions are cut into cells as ClosestPointSearch cuts them. What bounds a cell's distance
/// from below holds, less the way since, wherever the place goes: a cell is looked at again only
/// when the way has used up its clearance, and stays cut as fine as was needed. So a step asks few
/// cells, those next to the known minima, and evaluates the model only where it comes to new ones.
/// Memory is fixed; queries allocate nothing. They keep what they learn, so a proof is for one
/// thread.
class ClearanceProof
{
public:
  enum class Finding
  {
    Clear,  ///< nothing but the known minima is nearer, up to the tolerance
    Nearer, ///< a minimum that was not known is
    Open    ///< the evaluations allowed did not suffice
  };
  struct Answer
  {
    Finding State;
    double LowerDistance; ///< but for the known minima no point is nearer, mm; of Clear and Open
    ClosestPoint Minimum; ///< of Nearer
  };

  /// Minima are one where their directions differ by less (rad).
  static constexpr double Apart = 0.003;

  /// `distance` > `tolerance` > 0, mm. Keeps the address of the search, which must outlive it.
  ClearanceProof(const ClosestPointSearch& search, double distance, double tolerance) noexcept;

  /// `known` are minima of the distance to `queryWorld` (mm; no farther than 1e100), tracked there,
  /// at most MostKnown. The model is evaluated `evaluationLimit` times or little more.
  Answer Ask(const Vector3& queryWorld, const ClosestPoint* known, std::size_t knownCount,
             int evaluationLimit) noexcept;
  static constexpr std::size_t MostKnown = 8;

private:
  // A node of the tree, or a triangle of its own.
  struct Cell
  {
    int Node; // of triangles None
    bool IsEvaluated;
    SphericalTriangle Triangle;
    SphericalCap Cap;
    SphericalHarmonicModel::SecondOrderSample Sample; // at the cap's centre
  };
  struct Task;
  enum class Step
  {
    Settled,
    Again, // other cells are in its place
    Found, // a minimum
    Open
  };
  static constexpr int None = -1;
  static constexpr std::size_t CellCapacity = 1024;

  void BeginAfresh() noexcept;
  void GoTo(const Vector3& query) noexcept;
  void Settle(Task& task, std::size_t index) noexcept;
  Step SettleNode(Task& task, std::size_t index) noexcept;
  Step SettleTriangle(Task& task, std::size_t index) noexcept;
  Step Descend(Task& task, const Cell& cell) noexcept;
  Step CutNode(std::size_t index) noexcept;
  Step CutTriangle(std::size_t index) noexcept;
  bool Clears(double lower, std::size_t index) noexcept;

  const ClosestPointSearch* Search;
  double Needed; // mm
  Vector3 Query = Vector3::Zero();
  double Way = 0.0; // mm that the query has gone since the cells were begun
  // No point of a cell is nearer than this plus what is needed, less the way.
  std::array<double, CellCapacity> ClearUntil;
  std::array<Cell, CellCapacity> Cells;
  std::size_t CellCount = 0;
};
} // namespace palpate
