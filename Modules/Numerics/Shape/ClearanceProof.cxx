#include "ClearanceProof.h"

#include "ProofTask.h"
#include "SampleGeometry.h"
#include "SquaredDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
constexpr double Infinite = std::numeric_limits<double>::infinity();
constexpr double MinimumTolerance = 1e-9; // rad
constexpr int EvaluationsOfDescent = 8;   // nearly always enough
constexpr int LeastForDescent = 5;        // it usually ends before
} // namespace

template <typename Surface>
ClearanceProofOf<Surface>::ClearanceProofOf(const ClosestPointSearchOf<Surface>& search,
                                            double distance, double tolerance) noexcept
    : Search(&search), LeftOpen(tolerance), Needed(distance - tolerance), Asked(Needed)
{
  this->BeginAfresh();
}

// With the roots of the tree, without bounds.
template <typename Surface>
void ClearanceProofOf<Surface>::BeginAfresh() noexcept
{
  constexpr std::size_t Roots = SurfacePatchTreeOf<Surface>::RootCount;
  this->PathLength = 0.0;
  this->CellCount = Roots;
  for (std::size_t root = 0; root < Roots; ++root)
  {
    this->ClearUntil[root] = -Infinite;
    this->Nodes[root] = static_cast<int>(root);
  }
}

template <typename Surface>
void ClearanceProofOf<Surface>::GoTo(const Vector3& query) noexcept
{
  const double step = (query - this->Query).norm();
  this->IsTurned = step == 0.0 && !this->IsTurned;
  this->PathLength += step;
  this->Query = query;
  // Keeps the rounding of the path length far below any tolerance.
  const bool isFar = !(this->PathLength < 1e4 * this->Search->Tree().LargestRadius());
  constexpr std::size_t Few = Capacity / 8;
  if (isFar || this->CellCount > Capacity - Few)
  {
    this->BeginAfresh();
  }
}

// The nearest first, where minima are found
// soonest. Next to a minimum in a hollow as round as the distance some are never clear, so that
// every other query at a place begins with those that lack least.
template <typename Surface>
void ClearanceProofOf<Surface>::FindOpen() noexcept
{
  const double used = this->Used();
  this->OpenCount = 0;
  for (std::size_t i = 0; i < this->CellCount; ++i)
  {
    this->Open[this->OpenCount] = static_cast<std::uint16_t>(i);
    this->OpenCount += this->ClearUntil[i] < used ? 1 : 0;
  }
  std::sort(this->Open.begin(), this->Open.begin() + static_cast<std::ptrdiff_t>(this->OpenCount),
            [&](std::uint16_t a, std::uint16_t b)
            {
              const double one = this->ClearUntil[this->IsTurned ? b : a];
              const double other = this->ClearUntil[this->IsTurned ? a : b];
              return one < other || (one == other && a < b);
            });
}

template <typename Surface>
typename ClearanceProofOf<Surface>::Answer
ClearanceProofOf<Surface>::Ask(const Vector3& queryWorld, const ClosestPoint* known,
                               std::size_t knownCount, int evaluationLimit) noexcept
{
  return this->AskWithin(this->Needed + this->LeftOpen, queryWorld, known, knownCount,
                         evaluationLimit);
}

template <typename Surface>
typename ClearanceProofOf<Surface>::Answer
ClearanceProofOf<Surface>::AskWithin(double distance, const Vector3& queryWorld,
                                     const ClosestPoint* known, std::size_t knownCount,
                                     int evaluationLimit, double apart) noexcept
{
  this->Asked = distance - this->LeftOpen;
  this->GoTo(queryWorld - this->Search->Model().CenterWorld());
  const ClosestPointDescentOf<Surface>& descent = this->Search->Descent();
  Task task;
  task.Known = known;
  task.KnownCount = std::min(knownCount, MostKnown);
  task.WorkLeft = WorkOfEvaluation * evaluationLimit;
  task.Rounding = descent.Rounding(this->Query);
  task.Result.State = Finding::Clear;
  task.Result.LowerDistance = this->Asked;
  for (std::size_t i = 0; i < task.KnownCount; ++i)
  {
    auto basin = descent.BasinAround(this->Query, known[i]);
    Widen(basin, apart);
    task.Add(basin, known[i].SampleDirection, Infinite);
  }
  this->FindOpen();
  for (std::size_t i = 0; i < this->OpenCount && task.Result.State != Finding::Nearer; ++i)
  {
    if (task.WorkLeft < WorkOfEvaluation)
    {
      this->LeaveOpen(task, i);
      break;
    }
    this->Settle(task, this->Open[i]);
  }
  task.Result.Evaluations = evaluationLimit - task.WorkLeft / WorkOfEvaluation;
  return task.Result;
}

template <typename Surface>
void ClearanceProofOf<Surface>::Settle(Task& task, std::size_t index) noexcept
{
  Step step = Step::Again;
  while (step == Step::Again)
  {
    step = this->ClearUntil[index] >= this->Used() || this->SettlesByBasin(task, index)
               ? Step::Settled
           : task.WorkLeft <= 0         ? Step::Open
           : this->Nodes[index] != None ? this->SettleNode(task, index)
                                        : this->SettleTriangle(task, index);
  }
  if (step == Step::Open)
  {
    this->LeaveOpen(task, this->ClearUntil[index]);
  }
}

template <typename Surface>
void ClearanceProofOf<Surface>::LeaveOpen(Task& task, double until) const noexcept
{
  task.Result.State = Finding::Open;
  const double lower = this->Needed + until - this->PathLength;
  task.Result.LowerDistance = std::clamp(lower, 0.0, task.Result.LowerDistance);
}

// The rest, from the open cell of this number on.
template <typename Surface>
void ClearanceProofOf<Surface>::LeaveOpen(Task& task, std::size_t first) const noexcept
{
  double until = Infinite;
  for (std::size_t i = first; i < this->OpenCount; ++i)
  {
    const std::size_t index = this->Open[i];
    const bool isNearer = this->ClearUntil[index] < until;
    until = isNearer && task.LowerDistance(this->CapOf(index)) != Infinite ? this->ClearUntil[index]
                                                                           : until;
  }
  this->LeaveOpen(task, until);
}

// Stores the bound of the cell's distance; returns whether it suffices here.
template <typename Surface>
bool ClearanceProofOf<Surface>::Clears(double lower, std::size_t index) noexcept
{
  double& until = this->ClearUntil[index];
  until = std::max(until, this->PathLength + (lower - this->Needed));
  return until >= this->Used();
}

// Whether a basin supplies the bound of the cell.
template <typename Surface>
bool ClearanceProofOf<Surface>::SettlesByBasin(const Task& task, std::size_t index) noexcept
{
  const double lower = task.LowerDistance(this->CapOf(index));
  return lower == Infinite || this->Clears(lower, index);
}

template <typename Surface>
typename ClearanceProofOf<Surface>::Step
ClearanceProofOf<Surface>::SettleNode(Task& task, std::size_t index) noexcept
{
  const SurfacePatchTreeOf<Surface>& tree = this->Search->Tree();
  const int node = this->Nodes[index];
  --task.WorkLeft;
  if (this->Clears(tree.LowerDistance(node, this->Query) - task.Rounding, index))
  {
    return Step::Settled;
  }
  if (!tree.IsInner(node))
  {
    this->Separate(index);
    return Step::Again;
  }
  return this->CutNode(index) ? Step::Settled : Step::Open;
}

template <typename Surface>
typename ClearanceProofOf<Surface>::Step
ClearanceProofOf<Surface>::SettleTriangle(Task& task, std::size_t index) noexcept
{
  Triangle& cell = this->Triangles[index];
  const int work = cell.IsEvaluated ? WorkOfBound : WorkOfEvaluation;
  if (task.WorkLeft < work)
  {
    return Step::Open;
  }
  task.WorkLeft -= work;
  if (!cell.IsEvaluated)
  {
    this->Evaluate(cell);
  }
  const double lower = this->Search->Descent().LowerDistance(
      this->Query, cell.Cap.Center, cell.Sample, cell.Cap.Radius, cell.Bounds);
  if (this->Clears(lower - task.Rounding, index))
  {
    return Step::Settled;
  }
  const Step step = this->Descend(task, cell);
  if (step != Step::Again || this->SettlesByBasin(task, index))
  {
    return step == Step::Again ? Step::Settled : step;
  }
  return this->CutTriangle(index) ? Step::Settled : Step::Open;
}

// Looks for a minimum in the cell that is closer than allowed. If it finds one that is farther,
// that one's basin may supply the missing bound of the cell.
template <typename Surface>
typename ClearanceProofOf<Surface>::Step
ClearanceProofOf<Surface>::Descend(Task& task, const Triangle& cell) noexcept
{
  const SquaredDistance distance(cell.Cap.Center, cell.Sample, this->Query);
  bool isWorthwhile = distance.Offset.norm() < this->Asked;
  if (!isWorthwhile && distance.IsConvex())
  {
    const Vector3 step = distance.NewtonStep();
    isWorthwhile = step.norm() <= 2.0 * cell.Cap.Radius &&
                   !task.IsNearBasin((cell.Cap.Center + step).normalized(), cell.Cap.Radius);
  }
  if (!isWorthwhile)
  {
    return Step::Again;
  }
  if (task.WorkLeft < LeastForDescent * WorkOfEvaluation)
  {
    return Step::Open;
  }
  const ClosestPointDescentOf<Surface>& descent = this->Search->Descent();
  const ClosestPointOf<Surface> found =
      descent.Run(this->Query, cell.Cap.Center, cell.Sample, MinimumTolerance,
                  std::max(EvaluationsOfDescent, task.WorkLeft / WorkOfEvaluation));
  task.WorkLeft -= WorkOfEvaluation * found.Evaluations;
  if (std::abs(found.SignedDistance) < this->Asked && !task.IsKnown(found))
  {
    task.Result.State = Finding::Nearer;
    task.Result.Minimum = found;
    return Step::Found;
  }
  const auto basin = descent.BasinAround(this->Query, found);
  task.Add(basin, found.SampleDirection, basin.LowerDistance);
  return Step::Again;
}

// The first part takes the cell's number, the others are new ones; all have its clearance.
template <typename Surface>
std::size_t ClearanceProofOf<Surface>::AddPart(std::size_t of, int part) noexcept
{
  const std::size_t index = part == 0 ? of : this->CellCount++;
  this->ClearUntil[index] = this->ClearUntil[of];
  this->Open[this->OpenCount++] = static_cast<std::uint16_t>(index);
  return index;
}

template <typename Surface>
bool ClearanceProofOf<Surface>::CutNode(std::size_t index) noexcept
{
  if (this->CellCount + 3 > Capacity)
  {
    return false;
  }
  const int first = SurfacePatchTreeOf<Surface>::FirstPart(this->Nodes[index]);
  for (int part = 0; part < 4; ++part)
  {
    this->Nodes[this->AddPart(index, part)] = first + part;
  }
  return true;
}

template <typename Surface>
bool ClearanceProofOf<Surface>::CutTriangle(std::size_t index) noexcept
{
  if (this->CellCount + 3 > Capacity)
  {
    return false;
  }
  const Triangle& whole = this->Triangles[index];
  const std::array<SphericalTriangle, 4> parts =
      (whole.Leaf != None ? this->Search->Tree().Triangle(whole.Leaf) : whole.Corners).Split();
  for (int part = 0; part < 4; ++part)
  {
    const std::size_t cell = this->AddPart(index, part);
    const SphericalTriangle& corners = parts[static_cast<std::size_t>(part)];
    this->Nodes[cell] = None;
    this->Triangles[cell].Leaf = None;
    this->Triangles[cell].IsEvaluated = false;
    this->Triangles[cell].Corners = corners;
    this->Triangles[cell].Cap = corners.Cap();
  }
  return true;
}

// Makes a triangle of a finest node.
template <typename Surface>
void ClearanceProofOf<Surface>::Separate(std::size_t index) noexcept
{
  Triangle& triangle = this->Triangles[index];
  triangle.Leaf = std::exchange(this->Nodes[index], None);
  triangle.IsEvaluated = false;
  triangle.Cap = this->Search->Tree().CapOf(triangle.Leaf);
}

template <typename Surface>
void ClearanceProofOf<Surface>::Evaluate(Triangle& cell) noexcept
{
  cell.Sample = this->Search->Model().EvaluateSecondOrder(cell.Cap.Center);
  cell.Bounds = this->Search->Descent().BoundsWithin(cell.Cap.Center, cell.Sample, cell.Cap.Radius);
  cell.IsEvaluated = true;
}

template class ClearanceProofOf<SphericalHarmonicModel>;
template class ClearanceProofOf<ParametricShape>;
} // namespace palpate
