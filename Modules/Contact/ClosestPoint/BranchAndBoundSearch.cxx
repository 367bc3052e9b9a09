#include "BranchAndBoundSearch.h"

#include "SquaredDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace palpate
{
namespace
{
// Angle between two unit vectors, rounded up slightly.
double AngleBetween(const Vector3& a, const Vector3& b)
{
  const double chord = (a - b).norm();
  return chord < 1.0 ? chord * (1.0 + 0.05 * chord * chord) + 1e-15
                     : 2.0 * std::asin(std::min(1.0, 0.5 * chord)) + 1e-15;
}

bool Contains(const RoundBasin& basin, const Vector3& around, const Vector3& center, double reach)
{
  return AngleBetween(center, around) + reach <= basin.Angle;
}
bool Contains(const StretchedBasin& basin, const Vector3& around, const Vector3& center,
              double reach)
{
  return basin.Contains(around, center, reach);
}

// Often the point in the query's direction.
Vector3 StartFor(const Vector3& query, const SurfacePatchTreeOf<RadialModel>&)
{
  const double distance = query.norm();
  return distance > 0.0 ? Vector3(query / distance) : Vector3(Vector3::UnitZ());
}

// Down the tree, to the nearest centres.
Vector3 StartFor(const Vector3& query, const SurfacePatchTreeOf<CenteredSurface>& tree)
{
  const auto nearestOf = [&](int first, int count)
  {
    int nearest = first;
    double least = tree.SquaredCenterDistance(first, query);
    for (int node = first + 1; node < first + count; ++node)
    {
      const double square = tree.SquaredCenterDistance(node, query);
      nearest = square < least ? node : nearest;
      least = std::min(square, least);
    }
    return nearest;
  };
  int node = nearestOf(0, tree.RootCount);
  while (tree.IsInner(node))
  {
    node = nearestOf(tree.FirstPart(node), 4);
  }
  return tree.CapOf(node).Center;
}
} // namespace

template <typename Surface>
BranchAndBoundSearch<Surface>::BranchAndBoundSearch(const Surface& model,
                                                    const ClosestPointDescentOf<Surface>& descent,
                                                    const SurfacePatchTreeOf<Surface>& tree,
                                                    const Vector3& query, int evaluationLimit,
                                                    double toolRadius, double part) noexcept
    : Model(model), Descent(descent), Tree(tree), Query(query), EvaluationLimit(evaluationLimit),
      ToolRadius(toolRadius), OpenPart(part), Rounding(descent.Rounding(query)),
      BestDistance(std::numeric_limits<double>::infinity()), Proven(BestDistance)
{
  std::iota(this->FreePieces.begin(), this->FreePieces.end(), 0);
}

template <typename Surface>
void BranchAndBoundSearch<Surface>::Push(double bound, int index) noexcept
{
  if (!(bound < this->Enough()))
  {
    return;
  }
  if (this->PartCount == PartCapacity)
  {
    this->Proven = std::min(this->Proven, bound);
    return;
  }
  this->Queue[this->PartCount++] = {bound, index};
  std::push_heap(this->Queue.begin(),
                 this->Queue.begin() + static_cast<std::ptrdiff_t>(this->PartCount),
                 [](const Part& a, const Part& b) { return a.Bound > b.Bound; });
}

template <typename Surface>
typename BranchAndBoundSearch<Surface>::Part BranchAndBoundSearch<Surface>::Pop() noexcept
{
  std::pop_heap(this->Queue.begin(),
                this->Queue.begin() + static_cast<std::ptrdiff_t>(this->PartCount),
                [](const Part& a, const Part& b) { return a.Bound > b.Bound; });
  return this->Queue[--this->PartCount];
}

template <typename Surface>
typename BranchAndBoundSearch<Surface>::Piece
BranchAndBoundSearch<Surface>::Evaluate(const SphericalTriangle& triangle) noexcept
{
  ++this->Evaluations;
  const SphericalCap cap = triangle.Cap();
  return {triangle, cap.Center, cap.Radius, this->Model.EvaluateSecondOrder(cap.Center)};
}

template <typename Surface>
bool BranchAndBoundSearch<Surface>::IsCovered(const Vector3& center, double reach) noexcept
{
  for (std::size_t i = 0; i < this->BasinCount; ++i)
  {
    const Basin& basin = this->Basins[i];
    if (Contains(basin.Around, basin.Direction, center, reach))
    {
      this->Proven = std::min(this->Proven, basin.Around.LowerDistance);
      return true;
    }
  }
  return false;
}

template <typename Surface>
void BranchAndBoundSearch<Surface>::Descend(const Vector3& direction,
                                            const SampleOf<Surface>& sample) noexcept
{
  constexpr double Tolerance = 1e-12; // rad
  const ClosestPointOf<Surface> found =
      this->Descent.Run(this->Query, direction, sample, Tolerance,
                        std::max(0, this->EvaluationLimit - this->Evaluations));
  this->Evaluations += found.Evaluations;
  const double distance = std::abs(found.SignedDistance);
  if (distance < this->BestDistance)
  {
    this->Best = found;
    this->BestDistance = distance;
  }
  if (this->BasinCount < BasinCapacity)
  {
    this->Basins[this->BasinCount++] = {found.SampleDirection,
                                        this->Descent.BasinAround(this->Query, found)};
  }
}

// A good start leaves to the rest only to prove it.
template <typename Surface>
void BranchAndBoundSearch<Surface>::DescendFromQuery() noexcept
{
  const Vector3 direction = StartFor(this->Query, this->Tree);
  ++this->Evaluations;
  this->Descend(direction, this->Model.EvaluateSecondOrder(direction));
}

template <typename Surface>
void BranchAndBoundSearch<Surface>::Examine(double bound, const Piece& piece) noexcept
{
  const SquaredDistance distance(piece.Center, piece.Sample, this->Query);
  bool worthwhile = distance.Offset.norm() < this->BestDistance;
  if (!worthwhile && distance.IsConvex())
  {
    const Vector3 step = distance.NewtonStep();
    worthwhile = step.norm() <= 2.0 * piece.Reach &&
                 !this->IsCovered((piece.Center + step).normalized(), 0.0);
  }
  if (worthwhile)
  {
    this->Descend(piece.Center, piece.Sample);
  }
  if (!this->IsCovered(piece.Center, piece.Reach))
  {
    this->Cut(bound, piece);
  }
}

template <typename Surface>
void BranchAndBoundSearch<Surface>::Cut(double bound, const Piece& piece) noexcept
{
  for (const SphericalTriangle& triangle : piece.Triangle.Split())
  {
    const SphericalCap cap = triangle.Cap();
    if (this->IsCovered(cap.Center, cap.Radius))
    {
      continue;
    }
    const Piece child = this->Evaluate(triangle);
    const typename SurfaceKind<Surface>::Patch patch(
        child.Center, child.Sample, child.Reach,
        this->Descent.Bounds().ThirdWithin(child.Center, child.Reach));
    const double expansion =
        this->Descent.LowerDistance(this->Query, child.Center, child.Sample, child.Reach);
    this->PushPiece(std::max({bound, patch.LowerDistance(this->Query), expansion}), child);
  }
}

template <typename Surface>
void BranchAndBoundSearch<Surface>::PushPiece(double bound, const Piece& piece) noexcept
{
  if (!(bound < this->Enough()))
  {
    return;
  }
  if (this->FreeCount == 0)
  {
    this->Proven = std::min(this->Proven, bound);
    return;
  }
  const int slot = this->FreePieces[--this->FreeCount];
  this->Pieces[static_cast<std::size_t>(slot)] = piece;
  this->Push(bound, this->Tree.NodeCount() + slot);
}

template <typename Surface>
void BranchAndBoundSearch<Surface>::PushParts(int node) noexcept
{
  const int first = SurfacePatchTreeOf<Surface>::FirstPart(node);
  for (int part = first; part < first + 4; ++part)
  {
    this->Push(this->Tree.LowerDistance(part, this->Query), part);
  }
}

template <typename Surface>
void BranchAndBoundSearch<Surface>::Visit(const Part& part) noexcept
{
  if (part.Index >= this->Tree.NodeCount())
  {
    const int slot = part.Index - this->Tree.NodeCount();
    const Piece piece = this->Pieces[static_cast<std::size_t>(slot)];
    this->FreePieces[this->FreeCount++] = slot;
    this->Examine(part.Bound, piece);
    return;
  }
  const auto& [center, reach] = this->Tree.CapOf(part.Index);
  if (this->IsCovered(center, reach))
  {
    return;
  }
  if (this->Tree.IsInner(part.Index))
  {
    this->PushParts(part.Index);
    return;
  }
  const Piece piece = this->Evaluate(this->Tree.Triangle(part.Index));
  const double bound = std::max(part.Bound, this->Descent.LowerDistance(this->Query, piece.Center,
                                                                        piece.Sample, piece.Reach));
  if (bound < this->Enough())
  {
    this->Examine(bound, piece);
  }
}

template <typename Surface>
ClosestPointOf<Surface> BranchAndBoundSearch<Surface>::Run(const ClosestPoint* near) noexcept
{
  if (near != nullptr)
  {
    this->Descend(near->SampleDirection, near->Sample);
  }
  else
  {
    this->DescendFromQuery();
  }
  for (int root = 0; root < SurfacePatchTreeOf<Surface>::RootCount; ++root)
  {
    this->Push(this->Tree.LowerDistance(root, this->Query), root);
  }
  const double distance = this->Query.norm();
  const double shell =
      std::max({0.0, this->Tree.LeastRadius() - distance, distance - this->Tree.LargestRadius()});
  while (this->PartCount > 0 && shell < this->Enough())
  {
    const Part part = this->Pop();
    const bool isDone = this->Evaluations >= this->EvaluationLimit &&
                        this->BestDistance < std::numeric_limits<double>::infinity();
    if (!(part.Bound < this->Enough()) || isDone)
    {
      this->Proven = std::min(this->Proven, part.Bound);
      break;
    }
    this->Visit(part);
  }
  const double proven = std::max(shell, std::min(this->Proven, this->Enough()));
  this->Best.DistanceError = std::max(0.0, this->BestDistance - proven) + this->Rounding;
  this->Best.Evaluations = this->Evaluations;
  return this->Best;
}

template class BranchAndBoundSearch<RadialModel>;
template class BranchAndBoundSearch<CenteredSurface>;
} // namespace palpate
