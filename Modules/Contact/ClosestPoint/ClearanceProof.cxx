#include "ClearanceProof.h"

#include "ProofTask.h"
#include "SampleGeometry.h"
#include "SquaredDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr double Infinite = std::numeric_limits<double>::infinity();
constexpr double MinimumTolerance = 1e-9; // rad
constexpr int EvaluationsOfDescent = 8;   // nearly always enough
constexpr int LeastForDescent = 5;        // it usually ends before
constexpr std::size_t FirstCells = 32;    // to which little is done without work, too
} // namespace

template <typename Surface>
ClearanceProofOf<Surface>::ClearanceProofOf(const ClosestPointSearchOf<Surface>& search,
                                            double distance, double tolerance) noexcept
    : Search(&search), LeftOpen(tolerance), Needed(distance - tolerance), Asked(Needed)
{
  this->BeginAfresh();
}

template <typename Surface>
void ClearanceProofOf<Surface>::BeginAfresh() noexcept
{
  this->PathLength = 0.0;
  this->NearUntil = -Infinite;
  this->Cells.Begin(*this->Search);
}

// Most cells stay clear for many steps, so that only the others are looked at.
template <typename Surface>
void ClearanceProofOf<Surface>::GatherNear() noexcept
{
  this->NearCount = 0;
  for (std::size_t group = 0; group < this->Cells.Parts.End(); ++group)
  {
    this->Near[this->NearCount] = static_cast<std::uint16_t>(group);
    this->NearCount += this->Cells.LeastOf(group) < this->NearUntil ? 1 : 0;
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
  const bool isFar = !(this->PathLength < 1e4 * this->Search->Tree().LargestRadius());
  const bool isAfresh = isFar || this->IsNearlyFull();
  if (isAfresh)
  {
    this->BeginAfresh();
  }
  // A query that goes on where the last one ended has the same bounds.
  const bool isNew = isAfresh || step > 0.0 || this->Used() > this->BoundedFor;
  this->IsTurned = !isNew && !this->IsTurned;
  if (isNew)
  {
    ++this->Bounded;
    this->BoundedFor = this->Used();
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
  if (this->Cells.Parts.FreeGroups() < Few)
  {
    constexpr double Farther = 0.1;
    this->Cells.Join(this->Used() + Farther * this->Needed);
    this->NearUntil = -Infinite; // some of the near cells are joined
  }
  return this->Cells.Parts.FreeGroups() < Few;
}

// Most of the near cells are clear by their last bounds; leaves the groups of the others.
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
  this->MovedCount = 0;
  for (std::size_t i = 0; i < moved; ++i)
  {
    const std::uint16_t group = this->Moved[i];
    FourLanes lower;
    this->Cells.Bounds[group].Move(this->Query, lower);
    lower += less;
    auto& until = reinterpret_cast<Clearances&>(this->Cells.ClearUntil[MovedBounds::Count * group]);
    until = lower > until ? lower : until;
    this->Moved[this->MovedCount] = group;
    this->MovedCount += this->IsUsedUp(group, used) ? 1 : 0;
  }
}

// Most cells that are not clear by their last bounds only lack bounds from here. An eighth of the
// work, and enough for a descent, is left for those that stay open.
template <typename Surface>
void ClearanceProofOf<Surface>::BoundMoved(Task& task) noexcept
{
  const int least = std::max(task.WorkLeft / 8, LeastForDescent * WorkOfEvaluation + WorkOfBound);
  this->Open.Clear();
  for (std::size_t i = 0; i < this->MovedCount; ++i)
  {
    const std::size_t group = this->Moved[i];
    if (task.WorkLeft >= least + WorkOfGroup && !this->IsBounded(group) &&
        this->Cells.FirstNodes[group] != None)
    {
      task.WorkLeft -= WorkOfGroup;
      this->BoundGroup(task, group);
    }
    this->AddOpenOf(group);
  }
}

// Bounds at the query of the group's cells that lack them, by their nodes; also of
// cells in a basin, since to find that out takes as long.
template <typename Surface>
void ClearanceProofOf<Surface>::BoundGroup(const Task& task, std::size_t group) noexcept
{
  const SurfacePatchTreeOf<Surface>& tree = this->Search->Tree();
  const std::size_t first = MovedBounds::Count * group;
  const double used = this->Used();
  const int node = this->Cells.FirstNodes[group];
  this->BoundedAt[group] = this->Bounded;
  for (std::size_t part = 0; node != None && part < MovedBounds::Count; ++part)
  {
    if (this->Cells.ClearUntil[first + part] < used)
    {
      const int each = node + static_cast<int>(part);
      const auto& ball = tree.BallOf(each);
      this->Improve(task, first + part, tree.LowerDistance(each, this->Query), ball.Center,
                    ball.Radius);
    }
  }
}

// Takes a bound of the cell at the query if it is more than is known.
template <typename Surface>
void ClearanceProofOf<Surface>::Improve(const Task& task, std::size_t index, double lower,
                                        const Vector3& point, double extent) noexcept
{
  const double before = this->Cells.ClearUntil[index];
  this->Clears(lower - task.Rounding, index);
  if (this->Cells.ClearUntil[index] > before)
  {
    this->KeepBound(index, lower, point, extent);
  }
}

template <typename Surface>
void ClearanceProofOf<Surface>::AddOpenOf(std::size_t group) noexcept
{
  for (std::size_t part = 0; part < MovedBounds::Count; ++part)
  {
    const std::size_t index = MovedBounds::Count * group + part;
    this->Open.Add(index, this->Used() - this->Cells.ClearUntil[index]);
  }
}

// To look through the cells takes time too, but leaves some to settle them.
template <typename Surface>
int ClearanceProofOf<Surface>::WorkOfLook(int workLeft) const noexcept
{
  return std::min(workLeft / 4, static_cast<int>((this->NearCount + 8 * this->MovedCount) / 4));
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
  this->MoveBounds(task.Rounding);
  task.WorkLeft -= this->WorkOfLook(task.WorkLeft);
  this->BoundMoved(task);
  // The nearest first, where minima are found soonest. Next to a minimum in a hollow as round as
  // the distance some are never clear, so that every other query at a place begins with those that
  // lack least.
  this->Open.Sort(this->IsTurned);
  for (std::size_t i = 0; i < this->Open.Count() && task.Result.State != Finding::Nearer; ++i)
  {
    if (i >= FirstCells && task.WorkLeft < WorkOfEvaluation)
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
    step = this->Cells.ClearUntil[index] >= this->Used() ? Step::Settled
           : this->Cells.Nodes[index] != None            ? this->SettleNode(task, index)
                                                         : this->SettleTriangle(task, index);
  }
  if (step == Step::Open)
  {
    this->LeaveOpen(task, this->Cells.ClearUntil[index]);
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
  for (std::size_t i = first; i < this->Open.Count(); ++i)
  {
    const std::size_t index = this->Open[i];
    const bool isNearer = this->Cells.ClearUntil[index] < until;
    until = isNearer && task.LowerDistance(this->Cells.CapOf(index)) != Infinite
                ? this->Cells.ClearUntil[index]
                : until;
  }
  this->LeaveOpen(task, until);
}

// Stores the bound of the cell's distance; returns whether it suffices here.
template <typename Surface>
bool ClearanceProofOf<Surface>::Clears(double lower, std::size_t index) noexcept
{
  double& until = this->Cells.ClearUntil[index];
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
    this->Cells.Bounds[index / MovedBounds::Count].Set(index % MovedBounds::Count, this->Query,
                                                       lower, point, extent);
  }
}

template <typename Surface>
typename ClearanceProofOf<Surface>::Step
ClearanceProofOf<Surface>::SettleNode(Task& task, std::size_t index) noexcept
{
  const SurfacePatchTreeOf<Surface>& tree = this->Search->Tree();
  if (this->SettlesByBasin(task, tree.CapOf(this->Cells.Nodes[index]), index))
  {
    return Step::Settled;
  }
  if (task.WorkLeft <= 0)
  {
    return Step::Open;
  }
  const std::size_t group = index / MovedBounds::Count;
  if (!this->IsBounded(group))
  {
    task.WorkLeft -= WorkOfGroup;
    this->BoundGroup(task, group);
    return Step::Again;
  }
  return this->CutNode(task, index);
}

template <typename Surface>
double ClearanceProofOf<Surface>::LowerDistanceOf(std::size_t index) noexcept
{
  const Triangle& cell = this->Cells.Triangles[index];
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
  Triangle& cell = this->Cells.Triangles[index];
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
    this->Cells.Evaluate(index);
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

template <typename Surface>
typename ClearanceProofOf<Surface>::Step
ClearanceProofOf<Surface>::CutNode(Task& task, std::size_t index) noexcept
{
  if (!this->Search->Tree().IsInner(this->Cells.Nodes[index]))
  {
    this->Cells.Separate(index);
    return Step::Again;
  }
  const std::size_t group = this->Cells.CutNode(index);
  if (group == Groups)
  {
    return Step::Open;
  }
  task.WorkLeft -= WorkOfGroup;
  this->BoundGroup(task, group);
  this->AddGroup(group);
  return Step::Settled;
}

template <typename Surface>
typename ClearanceProofOf<Surface>::Step
ClearanceProofOf<Surface>::CutTriangle(std::size_t index) noexcept
{
  const std::size_t group = this->Cells.CutTriangle(index);
  if (group == Groups)
  {
    return Step::Open;
  }
  this->BoundedAt[group] = this->Bounded;
  this->AddGroup(group);
  return Step::Settled;
}

// One that is new.
template <typename Surface>
void ClearanceProofOf<Surface>::AddGroup(std::size_t group) noexcept
{
  this->Near[this->NearCount++] = static_cast<std::uint16_t>(group);
  this->AddOpenOf(group);
}

template class ClearanceProofOf<RadialModel>;
template class ClearanceProofOf<CenteredSurface>;
} // namespace palpate
