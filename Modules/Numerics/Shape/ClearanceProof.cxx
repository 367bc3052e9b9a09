#include "ClearanceProof.h"

#include "ExpandedParts.h"
#include "ProofTask.h"
#include "SampleGeometry.h"
#include "SquaredDistance.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
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
constexpr std::size_t SortedCells = 32;
} // namespace

template <typename Surface>
ClearanceProofOf<Surface>::ClearanceProofOf(const ClosestPointSearchOf<Surface>& search,
                                            double distance, double tolerance) noexcept
    : Search(&search), LeftOpen(tolerance), Needed(distance - tolerance), Asked(Needed),
      Set(FastestInstructionSet())
{
  this->BeginAfresh();
}

template <typename Surface>
void ClearanceProofOf<Surface>::BeginAfresh() noexcept
{
  constexpr std::size_t Roots = SurfacePatchTreeOf<Surface>::RootCount;
  static_assert(Roots % MovedBounds::Count == 0, "roots fill whole groups");
  this->PathLength = 0.0;
  this->NearUntil = -Infinite;
  this->Parts.Begin(Roots / MovedBounds::Count);
  this->ClearUntil.fill(Infinite);
  for (std::size_t root = 0; root < Roots; ++root)
  {
    this->ClearUntil[root] = -Infinite;
    this->Cells[root].Node = static_cast<int>(root);
    this->Bounds[root / MovedBounds::Count].Forget();
  }
}

template <typename Surface>
double ClearanceProofOf<Surface>::LeastOf(std::size_t group) const noexcept
{
  const double* until = &this->ClearUntil[MovedBounds::Count * group];
  return std::min(std::min(until[0], until[1]), std::min(until[2], until[3]));
}

// The many cells that were quartered for places left behind.
template <typename Surface>
void ClearanceProofOf<Surface>::JoinFar() noexcept
{
  constexpr double Farther = 0.1;
  const double far = this->Used() + Farther * this->Needed;
  this->Parts.Join([&](std::size_t group) { return this->LeastOf(group) > far; },
                   [&](std::size_t cell, std::size_t group)
                   {
                     this->ClearUntil[cell] = this->LeastOf(group);
                     std::fill_n(&this->ClearUntil[MovedBounds::Count * group], MovedBounds::Count,
                                 Infinite);
                   });
}

// Most cells stay clear for many steps, so that only the others are looked at.
template <typename Surface>
void ClearanceProofOf<Surface>::GatherNear() noexcept
{
  this->NearCount = 0;
  for (std::size_t group = 0; group < this->Parts.End(); ++group)
  {
    this->Near[this->NearCount] = static_cast<std::uint16_t>(group);
    this->NearCount += this->LeastOf(group) < this->NearUntil ? 1 : 0;
  }
}

template <typename Surface>
void ClearanceProofOf<Surface>::GoTo(const Vector3& query) noexcept
{
  constexpr double Ahead = 3.0;
  constexpr double Farthest = 0.25;
  const double step = (query - this->Query).norm();
  this->PathLength += step;
  this->Query = query;
  // Keeps the rounding of the path length far below any tolerance.
  if (!(this->PathLength < 1e4 * this->Search->Tree().LargestRadius()) || this->IsNearlyFull())
  {
    this->BeginAfresh();
  }
  if (this->Used() > this->NearUntil)
  {
    this->NearUntil = this->Used() + std::min(Ahead * step, Farthest * this->Needed);
    this->GatherNear();
  }
}

// After the cells of places left behind were joined.
template <typename Surface>
bool ClearanceProofOf<Surface>::IsNearlyFull() noexcept
{
  constexpr std::size_t Few = Groups / 8;
  if (this->Parts.FreeGroups() < Few)
  {
    this->JoinFar();
    this->NearUntil = -Infinite; // some of the near cells are joined
  }
  return this->Parts.FreeGroups() < Few;
}

// A cell that is not clear at a path length.
template <typename Surface>
[[gnu::always_inline]] inline void ClearanceProofOf<Surface>::AddOpen(std::size_t index,
                                                                      double used) noexcept
{
  const double lacks = used - this->ClearUntil[index];
  std::uint64_t bits;
  std::memcpy(&bits, &lacks, sizeof bits);
  this->Open[this->OpenCount] = (bits & ~IndexBits) | index;
  this->OpenCount += lacks > 0.0 ? 1 : 0;
}

// Most of the near cells are clear by their last bounds.
template <typename Surface>
void ClearanceProofOf<Surface>::MoveBounds(double rounding) noexcept
{
  const double used = this->Used();
  const double less = this->PathLength - this->Needed - rounding;
  std::size_t moved = 0;
  for (std::size_t i = 0; i < this->NearCount; ++i)
  {
    this->Moved[moved] = this->Near[i];
    moved += this->IsUsedUp(this->Near[i], used) ? 1 : 0;
  }
  this->OpenCount = 0;
  for (std::size_t i = 0; i < moved; ++i)
  {
    const std::size_t group = this->Moved[i];
    FourLanes lower;
    this->Bounds[group].Move(this->Query, lower);
    lower += less;
    auto& until = reinterpret_cast<Clearances&>(this->ClearUntil[MovedBounds::Count * group]);
    until = lower > until ? lower : until;
    for (std::size_t part = 0; part < MovedBounds::Count; ++part)
    {
      this->AddOpen(MovedBounds::Count * group + part, used);
    }
  }
}

// Compiled twice, like the tracking of closest points: everything is inlined here.
template <typename Surface>
[[gnu::flatten]] void ClearanceProofOf<Surface>::FindOpenPortably(double rounding) noexcept
{
  this->MoveBounds(rounding);
}

template <typename Surface>
#if defined(__x86_64__)
[[gnu::target("avx2,fma")]]
#endif
[[gnu::flatten]] void
ClearanceProofOf<Surface>::FindOpenByAvx2(double rounding) noexcept
{
  this->MoveBounds(rounding);
}

template <typename Surface>
void ClearanceProofOf<Surface>::FindOpen(double rounding) noexcept
{
  if (this->Set == InstructionSet::Avx2)
  {
    this->FindOpenByAvx2(rounding);
  }
  else
  {
    this->FindOpenPortably(rounding);
  }
}

// Most open cells were evaluated before, and only lack a bound from here. Half of the work, and
// enough for a descent, is left for those that stay open.
template <typename Surface>
void ClearanceProofOf<Surface>::BoundOpen(Task& task) noexcept
{
  if constexpr (SurfaceKind<Surface>::MayBoundTogether)
  {
    ExpandedParts parts;
    std::array<std::size_t, ExpandedParts::Count> bounded{};
    std::size_t count = 0;
    const int least = std::max(task.WorkLeft / 2, LeastForDescent * WorkOfEvaluation + WorkOfBound);
    for (std::size_t i = 0; i < this->OpenCount && task.WorkLeft > least; ++i)
    {
      this->Prefetch(i + 4);
      const std::size_t index = this->OpenAt(i);
      const Cell& cell = this->Cells[index];
      if (cell.Node == None && cell.IsEvaluated && !this->SettlesByBasin(task, cell.Cap, index))
      {
        task.WorkLeft -= SurfaceKind<Surface>::WorkOfJointBound;
        parts.Set(count, cell.Sample, cell.Cap.Radius, cell.Bounds);
        bounded[count++] = index;
      }
      if (count == bounded.size())
      {
        this->KeepBounds(task, parts, bounded.data(), std::exchange(count, 0));
      }
    }
    this->KeepBounds(task, parts, bounded.data(), count);
    const std::size_t before = std::exchange(this->OpenCount, 0);
    for (std::size_t i = 0; i < before; ++i)
    {
      this->AddOpen(this->OpenAt(i), this->Used());
    }
  }
}

template <typename Surface>
void ClearanceProofOf<Surface>::KeepBounds(Task& task, const ExpandedParts& parts,
                                           const std::size_t* bounded, std::size_t count) noexcept
{
  if (count == 0)
  {
    return;
  }
  FourLanes lower;
  parts.LowerDistance(this->Query, this->Set, lower);
  for (std::size_t i = 0; i < count; ++i)
  {
    const Cell& cell = this->Cells[bounded[i]];
    this->KeepBound(bounded[i], lower[i], PointOf(cell.Cap.Center, cell.Sample),
                    cell.Bounds.Extent(cell.Cap.Radius));
    this->Clears(lower[i] - task.Rounding, bounded[i]);
  }
}

// To look through the cells takes time too, but leaves some to settle them.
template <typename Surface>
int ClearanceProofOf<Surface>::WorkOfLook(int workLeft) const noexcept
{
  return std::min(workLeft / 4, static_cast<int>((this->NearCount + 2 * this->OpenCount) / 4));
}

// The nearest first, where minima are found soonest; the many others in any order.
template <typename Surface>
void ClearanceProofOf<Surface>::SortOpen() noexcept
{
  const auto begin = this->Open.begin();
  const auto end = begin + static_cast<std::ptrdiff_t>(this->OpenCount);
  const auto last = begin + static_cast<std::ptrdiff_t>(std::min(SortedCells, this->OpenCount));
  if (last != end)
  {
    std::nth_element(begin, last, end, std::greater<>());
  }
  std::sort(begin, last, std::greater<>());
}

template <typename Surface>
typename ClearanceProofOf<Surface>::Answer
ClearanceProofOf<Surface>::Ask(const Vector3& queryWorld, const ClosestPoint* known,
                               std::size_t knownCount, int evaluationLimit,
                               const Rest& rest) noexcept
{
  return this->AskWithin(this->Needed + this->LeftOpen, queryWorld, known, knownCount,
                         evaluationLimit, Apart, rest);
}

template <typename Surface>
typename ClearanceProofOf<Surface>::Answer
ClearanceProofOf<Surface>::AskWithin(double distance, const Vector3& queryWorld,
                                     const ClosestPoint* known, std::size_t knownCount,
                                     int evaluationLimit, double apart, const Rest& rest) noexcept
{
  this->Asked = distance - this->LeftOpen;
  this->GoTo(queryWorld - this->Search->Model().CenterWorld());
  const ClosestPointDescentOf<Surface>& descent = this->Search->Descent();
  Task task;
  task.Known = known;
  task.KnownCount = std::min(knownCount, MostKnown);
  task.WorkLeft = WorkOfEvaluation * evaluationLimit;
  task.WorkOfRest = WorkOfEvaluation * rest.Evaluations;
  task.EnoughUntil = Infinite;
  task.Rounding = descent.Rounding(this->Query);
  task.Result.State = Finding::Clear;
  task.Result.LowerDistance = this->Asked;
  for (std::size_t i = 0; i < task.KnownCount; ++i)
  {
    auto basin = descent.BasinAround(this->Query, known[i]);
    Widen(basin, apart);
    task.Add(basin, known[i].SampleDirection, Infinite);
  }
  this->FindOpen(task.Rounding);
  task.WorkLeft -= this->WorkOfLook(task.WorkLeft);
  this->BoundOpen(task);
  this->SortOpen();
  const double enoughUntil = this->PathLength + (rest.Enough - this->Needed);
  for (std::size_t i = 0; i < this->OpenCount && task.Result.State != Finding::Nearer; ++i)
  {
    if (i >= SortedCells && task.WorkLeft < WorkOfEvaluation && !task.TakeRest(enoughUntil))
    {
      this->LeaveOpen(task, i);
      break;
    }
    this->Prefetch(i + 2);
    this->Settle(task, this->OpenAt(i), enoughUntil);
  }
  const int most = evaluationLimit + rest.Evaluations;
  task.Result.Evaluations = most - (task.WorkLeft + task.WorkOfRest) / WorkOfEvaluation;
  return task.Result;
}

template <typename Surface>
void ClearanceProofOf<Surface>::Settle(Task& task, std::size_t index, double enoughUntil) noexcept
{
  Step step = Step::Again;
  while (step == Step::Again)
  {
    const double until = this->ClearUntil[index];
    step = until >= this->Used()             ? Step::Settled
           : until >= task.EnoughUntil       ? Step::Open
           : this->Cells[index].Node != None ? this->SettleNode(task, index)
                                             : this->SettleTriangle(task, index);
    const bool mayGoOn = step == Step::Open && this->ClearUntil[index] < enoughUntil;
    step = mayGoOn && task.TakeRest(enoughUntil) ? Step::Again : step;
  }
  if (step == Step::Open)
  {
    this->LeaveOpen(task, this->ClearUntil[index]);
  }
}

template <typename Surface>
void ClearanceProofOf<Surface>::Prefetch(std::size_t i) const noexcept
{
  if (i < this->OpenCount)
  {
    this->Cells[this->OpenAt(i)].Prefetch();
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
    const std::size_t index = this->OpenAt(i);
    const bool isNearer = this->ClearUntil[index] < until;
    until = isNearer && task.LowerDistance(this->CapOf(index)) != Infinite ? this->ClearUntil[index]
                                                                           : until;
  }
  this->LeaveOpen(task, until);
}

template <typename Surface>
const SphericalCap& ClearanceProofOf<Surface>::CapOf(std::size_t index) const noexcept
{
  const Cell& cell = this->Cells[index];
  return cell.Node != None ? this->Search->Tree().CapOf(cell.Node) : cell.Cap;
}

// Stores the bound of the cell's distance; returns whether it suffices here.
template <typename Surface>
bool ClearanceProofOf<Surface>::Clears(double lower, std::size_t index) noexcept
{
  double& until = this->ClearUntil[index];
  until = std::max(until, this->PathLength + (lower - this->Needed));
  return until >= this->Used();
}

// Whether a basin supplies the bound of the cell over this cap.
template <typename Surface>
[[gnu::always_inline]] inline bool
ClearanceProofOf<Surface>::SettlesByBasin(const Task& task, const SphericalCap& cap,
                                          std::size_t index) noexcept
{
  const double lower = task.LowerDistance(cap);
  return lower == Infinite || this->Clears(lower, index);
}

// The bound holds at the query; the cell is within `extent` of `point`, all mm.
template <typename Surface>
void ClearanceProofOf<Surface>::KeepBound(std::size_t index, double lower, const Vector3& point,
                                          double extent) noexcept
{
  if (lower > 0.0)
  {
    this->Bounds[index / MovedBounds::Count].Set(index % MovedBounds::Count, this->Query, lower,
                                                 point, extent);
  }
}

template <typename Surface>
typename ClearanceProofOf<Surface>::Step
ClearanceProofOf<Surface>::SettleNode(Task& task, std::size_t index) noexcept
{
  const SurfacePatchTreeOf<Surface>& tree = this->Search->Tree();
  const int node = this->Cells[index].Node;
  if (this->SettlesByBasin(task, tree.CapOf(node), index))
  {
    return Step::Settled;
  }
  if (task.WorkLeft <= 0)
  {
    return Step::Open;
  }
  --task.WorkLeft;
  const double lower = tree.LowerDistance(node, this->Query);
  if (this->Clears(lower - task.Rounding, index))
  {
    const auto ball = tree.BallOf(node);
    this->KeepBound(index, lower, ball.Center, ball.Radius);
    return Step::Settled;
  }
  return this->CutNode(index);
}

template <typename Surface>
void ClearanceProofOf<Surface>::Evaluate(Cell& cell) noexcept
{
  cell.Sample = this->Search->Model().EvaluateSecondOrder(cell.Cap.Center);
  cell.Bounds = this->Search->Descent().BoundsWithin(cell.Cap.Center, cell.Sample, cell.Cap.Radius);
  cell.IsEvaluated = true;
}

template <typename Surface>
double ClearanceProofOf<Surface>::LowerDistanceOf(std::size_t index) noexcept
{
  const Cell& cell = this->Cells[index];
  const double lower = this->Search->Descent().LowerDistance(
      this->Query, cell.Cap.Center, cell.Sample, cell.Cap.Radius, cell.Bounds);
  this->KeepBound(index, lower, PointOf(cell.Cap.Center, cell.Sample),
                  cell.Bounds.Extent(cell.Cap.Radius));
  return lower;
}

template <typename Surface>
typename ClearanceProofOf<Surface>::Step
ClearanceProofOf<Surface>::SettleTriangle(Task& task, std::size_t index) noexcept
{
  Cell& cell = this->Cells[index];
  if (this->SettlesByBasin(task, cell.Cap, index))
  {
    return Step::Settled;
  }
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
  if (this->Clears(this->LowerDistanceOf(index) - task.Rounding, index))
  {
    return Step::Settled;
  }
  const Step step = this->Descend(task, cell);
  if (step != Step::Again || this->Clears(task.LowerDistance(cell.Cap), index))
  {
    return step == Step::Again ? Step::Settled : step;
  }
  return this->CutTriangle(index);
}

// Looks for a minimum in the cell that is closer than allowed. If it finds one that is farther,
// that one's basin may supply the missing bound of the cell.
template <typename Surface>
typename ClearanceProofOf<Surface>::Step
ClearanceProofOf<Surface>::Descend(Task& task, const Cell& cell) noexcept
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

// Returns the first of the cell's parts, which are open; CellCapacity without memory.
template <typename Surface>
std::size_t ClearanceProofOf<Surface>::Quarter(std::size_t index) noexcept
{
  const std::size_t group = this->Parts.Quarter(index);
  if (group == QuarteredCells<Groups>::None)
  {
    return CellCapacity;
  }
  const std::size_t first = MovedBounds::Count * group;
  const double until = std::exchange(this->ClearUntil[index], Infinite);
  this->Bounds[group].Forget();
  this->Near[this->NearCount++] = static_cast<std::uint16_t>(group);
  for (std::size_t part = first; part < first + MovedBounds::Count; ++part)
  {
    this->ClearUntil[part] = until;
    this->Open[this->OpenCount++] = part;
  }
  return first;
}

template <typename Surface>
typename ClearanceProofOf<Surface>::Step
ClearanceProofOf<Surface>::CutNode(std::size_t index) noexcept
{
  const SurfacePatchTreeOf<Surface>& tree = this->Search->Tree();
  Cell& cell = this->Cells[index];
  const int node = cell.Node;
  if (!tree.IsInner(node))
  {
    cell.Node = None;
    cell.Leaf = node;
    cell.IsEvaluated = false;
    cell.Cap = tree.CapOf(node);
    return Step::Again;
  }
  const std::size_t first = this->Quarter(index);
  if (first == CellCapacity)
  {
    return Step::Open;
  }
  for (std::size_t part = 0; part < MovedBounds::Count; ++part)
  {
    this->Cells[first + part].Node =
        SurfacePatchTreeOf<Surface>::FirstPart(node) + static_cast<int>(part);
  }
  return Step::Settled;
}

template <typename Surface>
typename ClearanceProofOf<Surface>::Step
ClearanceProofOf<Surface>::CutTriangle(std::size_t index) noexcept
{
  const std::size_t first = this->Quarter(index);
  if (first == CellCapacity)
  {
    return Step::Open;
  }
  const Cell& whole = this->Cells[index];
  const std::array<SphericalTriangle, MovedBounds::Count> parts =
      (whole.Leaf != None ? this->Search->Tree().Triangle(whole.Leaf) : whole.Triangle).Split();
  for (std::size_t part = 0; part < MovedBounds::Count; ++part)
  {
    Cell& cell = this->Cells[first + part];
    cell.Node = None;
    cell.Leaf = None;
    cell.IsEvaluated = false;
    cell.Triangle = parts[part];
    cell.Cap = parts[part].Cap();
  }
  return Step::Settled;
}

template class ClearanceProofOf<SphericalHarmonicModel>;
template class ClearanceProofOf<ParametricShape>;
} // namespace palpate
