#pragma once

#include "ClosestPoint.h"
#include "ClosestPointDescent.h"
#include "SphericalTriangle.h"
#include "SurfacePatchTree.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace palpate
{
/// One search of ClosestPointSearch for the closest point of the whole surface; see there. Lives on
/// the stack for one query, does not allocate and ends after a fixed number of evaluations.
template <typename Surface>
class BranchAndBoundSearch
{
public:
  using ClosestPoint = ClosestPointOf<Surface>;

  /// `query` is relative to the surface's centre, mm. Of the part of the distance beyond
  /// `toolRadius` (mm), the search may leave the fraction `part` in [0, 1) unproven.
  BranchAndBoundSearch(const Surface& model, const ClosestPointDescentOf<Surface>& descent,
                       const SurfacePatchTreeOf<Surface>& tree, const Vector3& query,
                       int evaluationLimit, double toolRadius = 0.0, double part = 0.0) noexcept;

  /// Descends first from the sample of `near`, if that is given.
  ClosestPoint Run(const ClosestPoint* near = nullptr) noexcept;

private:
  // A part of the surface with the lower bound of its distance: a node of the tree or, with indices
  // beyond the tree's end, a piece of a finest node.
  struct Part
  {
    double Bound; // mm
    int Index;
  };
  struct Piece
  {
    SphericalTriangle Triangle;
    Vector3 Center;
    double Reach; // rad
    SampleOf<Surface> Sample;
  };
  struct Basin
  {
    Vector3 Direction;
    typename ClosestPointDescentOf<Surface>::Basin Around;
  };
  static constexpr std::size_t PartCapacity = 8192;
  static constexpr std::size_t PieceCapacity = 256;
  static constexpr std::size_t BasinCapacity = 8;

  Piece Evaluate(const SphericalTriangle& triangle) noexcept;
  void PushPiece(double bound, const Piece& piece) noexcept;
  void Push(double bound, int index) noexcept;
  Part Pop() noexcept;
  void PushParts(int node) noexcept;
  // Looks for a minimum near the piece's centre, and splits the piece if that does not settle it.
  void Examine(double bound, const Piece& piece) noexcept;
  void Cut(double bound, const Piece& piece) noexcept;
  void Visit(const Part& part) noexcept;
  void Descend(const Vector3& direction, const SampleOf<Surface>& sample) noexcept;
  void DescendFromQuery() noexcept;
  // Whether a basin covers the cap, which proves its lower bound.
  bool IsCovered(const Vector3& center, double reach) noexcept;
  // Distance at which the search can stop, given rounding and the part that may stay unproven.
  double Enough() const noexcept
  {
    return this->BestDistance -
           std::max(this->Rounding, this->OpenPart * (this->BestDistance - this->ToolRadius));
  }

  const Surface& Model;
  const ClosestPointDescentOf<Surface>& Descent;
  const SurfacePatchTreeOf<Surface>& Tree;
  const Vector3 Query;
  const int EvaluationLimit;
  const double ToolRadius; // mm
  const double OpenPart;
  const double Rounding; // of distances, mm

  ClosestPoint Best;
  double BestDistance; // mm
  double Proven;       // no point outside the queue is closer, mm
  int Evaluations = 0;
  std::array<Part, PartCapacity> Queue; // a heap, smallest bound first
  std::size_t PartCount = 0;
  std::array<Piece, PieceCapacity> Pieces;
  std::array<int, PieceCapacity> FreePieces;
  std::size_t FreeCount = PieceCapacity;
  std::array<Basin, BasinCapacity> Basins;
  std::size_t BasinCount = 0;
};
} // namespace palpate
