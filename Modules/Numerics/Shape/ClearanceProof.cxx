#include "ClearanceProof.h"

#include "ParametricSample.h"
#include "SquaredDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace palpate
{
namespace
{
constexpr double Infinite = std::numeric_limits<double>::infinity();
constexpr double MinimumTolerance = 1e-9; // rad
// An evaluation with the bounds that it leads to takes as long as this many bounds of nodes.
constexpr int WorkOfEvaluation = 16;
constexpr int WorkOfDescent = 8 * WorkOfEvaluation; // nearly always enough

template <typename Surface>
bool IsSame(const ClosestPointOf<Surface>& a, const ClosestPointOf<Surface>& b) noexcept
{
  constexpr double Apart = ClearanceProofOf<Surface>::Apart;
  return (a.Direction - b.Direction).squaredNorm() < Apart * Apart;
}
// Ways to ask the two kinds of basin: for a cap inside, and for a point near.
bool Contains(const RoundBasin& basin, const Vector3& around, const SphericalCap& cap) noexcept
{
  const double margin = basin.Angle - cap.Radius;
  const double chord = (cap.Center - around).norm();
  // An angle is less than this up to 2.6 rad.
  return chord * (1.0 + 0.1 * chord * chord) < margin;
}
bool Contains(const StretchedBasin& basin, const Vector3& around, const SphericalCap& cap) noexcept
{
  return basin.Contains(around, cap.Center, cap.Radius);
}
bool IsNear(const RoundBasin& basin, const Vector3& around, const Vector3& direction,
            double reach) noexcept
{
  return (around - direction).norm() < basin.Angle + reach;
}
bool IsNear(const StretchedBasin& basin, const Vector3& around, const Vector3& direction,
            double reach) noexcept
{
  return basin.IsNear(around, direction, reach);
}
void Widen(RoundBasin& basin, double angle) noexcept
{
  basin.Angle = std::max(basin.Angle, angle);
}
void Widen(StretchedBasin& basin, double angle) noexcept
{
  basin.LeastAngle = angle;
}
RoundBasin Limited(RoundBasin basin) noexcept
{
  constexpr double Widest = 2.0; // rad
  basin.Angle = std::min(basin.Angle, Widest);
  return basin;
}
const StretchedBasin& Limited(const StretchedBasin& basin) noexcept
{
  return basin;
}
} // namespace

// One query.
template <typename Surface>
struct ClearanceProofOf<Surface>::Task
{
  struct Basin
  {
    Vector3 Direction;
    typename ClosestPointDescentOf<Surface>::Basin Around;
    double LowerDistance; // infinite around known minima
  };

  void Add(const typename ClosestPointDescentOf<Surface>::Basin& around, const Vector3& direction,
           double lowerDistance) noexcept
  {
    if (this->BasinCount < this->Basins.size())
    {
      this->Basins[this->BasinCount++] = {direction, Limited(around), lowerDistance};
    }
  }
  // Lower bound of the cap's distance by the basins that cover it, mm.
  double LowerDistance(const SphericalCap& cap) const noexcept
  {
    double lower = 0.0;
    for (std::size_t i = 0; i < this->BasinCount; ++i)
    {
      const Basin& basin = this->Basins[i];
      if (Contains(basin.Around, basin.Direction, cap))
      {
        lower = std::max(lower, basin.LowerDistance);
      }
    }
    return lower;
  }
  // Whether a descent from here probably ends in a known minimum.
  bool IsNearBasin(const Vector3& direction, double reach) const noexcept
  {
    return std::any_of(this->Basins.begin(),
                       this->Basins.begin() + static_cast<std::ptrdiff_t>(this->BasinCount),
                       [&](const Basin& basin)
                       { return IsNear(basin.Around, basin.Direction, direction, reach); });
  }
  bool IsKnown(const ClosestPoint& minimum) const noexcept
  {
    return std::any_of(this->Known, this->Known + this->KnownCount,
                       [&](const ClosestPoint& known) { return IsSame(known, minimum); });
  }

  Vector3 Query;
  const ClosestPoint* Known;
  std::size_t KnownCount;
  int WorkLeft;    // in bounds of nodes
  double Rounding; // of distances, mm
  Answer Result;
  std::array<Basin, 2 * MostKnown> Basins;
  std::size_t BasinCount = 0;
};

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
  this->CellCount = SurfacePatchTreeOf<Surface>::RootCount;
  for (std::size_t root = 0; root < this->CellCount; ++root)
  {
    this->ClearUntil[root] = -Infinite;
    this->Cells[root].Node = static_cast<int>(root);
  }
}

// Most cells stay clear for many steps, so that only the others are looked at.
template <typename Surface>
void ClearanceProofOf<Surface>::GatherNear() noexcept
{
  this->NearCount = 0;
  for (std::size_t i = 0; i < this->CellCount; ++i)
  {
    this->Near[this->NearCount] = static_cast<std::uint16_t>(i);
    this->NearCount += this->ClearUntil[i] < this->NearUntil ? 1 : 0;
  }
}

// Parts of a cell that is not clear.
template <typename Surface>
void ClearanceProofOf<Surface>::AddNear(std::size_t count) noexcept
{
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Near[this->NearCount++] = static_cast<std::uint16_t>(this->CellCount++);
  }
}

template <typename Surface>
void ClearanceProofOf<Surface>::GoTo(const Vector3& query) noexcept
{
  constexpr double Ahead = 6.0;
  constexpr double Farthest = 0.25;
  const double step = (query - this->Query).norm();
  this->PathLength += step;
  this->Query = query;
  // Keeps the rounding of the path length far below any tolerance, and drops the many cells that
  // were split for places left behind.
  if (!(this->PathLength < 1e4 * this->Search->Tree().LargestRadius()) ||
      this->CellCount > CellCapacity * 3 / 4)
  {
    this->BeginAfresh();
  }
  if (this->Used() > this->NearUntil)
  {
    this->NearUntil = this->Used() + std::min(Ahead * step, Farthest * this->Needed);
    this->GatherNear();
  }
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
  for (std::size_t i = 0; i < this->NearCount && task.Result.State != Finding::Nearer; ++i)
  {
    this->Settle(task, this->Near[i]);
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
    const bool isClear = this->ClearUntil[index] >= this->Used();
    step = isClear                           ? Step::Settled
           : this->Cells[index].Node != None ? this->SettleNode(task, index)
                                             : this->SettleTriangle(task, index);
  }
  if (step == Step::Open)
  {
    task.Result.State = Finding::Open;
    const double lower = this->Needed + this->ClearUntil[index] - this->PathLength;
    task.Result.LowerDistance = std::clamp(lower, 0.0, task.Result.LowerDistance);
  }
}

// Stores the bound of the cell's distance; returns whether it suffices here.
template <typename Surface>
bool ClearanceProofOf<Surface>::Clears(double lower, std::size_t index) noexcept
{
  double& until = this->ClearUntil[index];
  until = std::max(until, this->PathLength + (lower - this->Needed));
  return until >= this->Used();
}

template <typename Surface>
typename ClearanceProofOf<Surface>::Step
ClearanceProofOf<Surface>::SettleNode(Task& task, std::size_t index) noexcept
{
  if (task.WorkLeft <= 0)
  {
    return Step::Open;
  }
  --task.WorkLeft;
  const SurfacePatchTreeOf<Surface>& tree = this->Search->Tree();
  const int node = this->Cells[index].Node;
  const double inBasin = task.LowerDistance(tree.CapOf(node));
  if (inBasin == Infinite || this->Clears(inBasin, index) ||
      this->Clears(tree.LowerDistance(node, this->Query) - task.Rounding, index))
  {
    return Step::Settled;
  }
  return this->CutNode(index);
}

template <typename Surface>
void ClearanceProofOf<Surface>::Evaluate(Cell& cell) noexcept
{
  cell.Sample = this->Search->Model().EvaluateSecondOrder(cell.Cap.Center);
  cell.IsEvaluated = true;
  if constexpr (std::is_same_v<Surface, ParametricShape>)
  {
    const double reach = cell.Cap.Radius;
    const double third = this->Search->Descent().Bounds().ThirdWithin(cell.Cap.Center, reach);
    cell.Extent = reach * (LargestFirst(cell.Sample) +
                           reach * (0.5 * LargestSecond(cell.Sample) + reach * third / 6.0));
    cell.LowerDistance = 0.0;
  }
}

template <typename Surface>
double ClearanceProofOf<Surface>::LowerDistanceOf(Cell& cell) noexcept
{
  const double lower = this->Search->Descent().LowerDistance(this->Query, cell.Cap.Center,
                                                             cell.Sample, cell.Cap.Radius);
  if constexpr (std::is_same_v<Surface, ParametricShape>)
  {
    cell.Place = this->Query;
    cell.LowerDistance = lower;
  }
  return lower;
}

// The last bound, moved to the query: |x - q - d|^2 = |x - q|^2 - 2 d.(x - q) + |d|^2. A step along
// the surface hardly changes it, unlike the clearance that the path length uses up.
template <typename Surface>
double ClearanceProofOf<Surface>::LastBoundOf(const Cell& cell) const noexcept
{
  if constexpr (std::is_same_v<Surface, ParametricShape>)
  {
    const Vector3 step = this->Query - cell.Place;
    const double along = step.dot(cell.Sample.Point - cell.Place) + step.norm() * cell.Extent;
    const double square =
        cell.LowerDistance * cell.LowerDistance - 2.0 * along + step.squaredNorm();
    return cell.LowerDistance > 0.0 && square > 0.0 ? std::sqrt(square) : 0.0;
  }
  else
  {
    return -Infinite;
  }
}

template <typename Surface>
typename ClearanceProofOf<Surface>::Step
ClearanceProofOf<Surface>::SettleTriangle(Task& task, std::size_t index) noexcept
{
  Cell& cell = this->Cells[index];
  if (cell.IsEvaluated && this->Clears(this->LastBoundOf(cell) - task.Rounding, index))
  {
    return Step::Settled;
  }
  const double inBasin = task.LowerDistance(cell.Cap);
  if (inBasin == Infinite || this->Clears(inBasin, index))
  {
    return Step::Settled;
  }
  if (!cell.IsEvaluated)
  {
    if (task.WorkLeft < WorkOfEvaluation)
    {
      return Step::Open;
    }
    task.WorkLeft -= WorkOfEvaluation;
    this->Evaluate(cell);
  }
  if (this->Clears(this->LowerDistanceOf(cell) - task.Rounding, index))
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
  if (task.WorkLeft < WorkOfDescent)
  {
    return Step::Open;
  }
  const ClosestPointDescentOf<Surface>& descent = this->Search->Descent();
  const ClosestPointOf<Surface> found =
      descent.Run(this->Query, cell.Cap.Center, cell.Sample, MinimumTolerance,
                  task.WorkLeft / WorkOfEvaluation);
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
ClearanceProofOf<Surface>::CutNode(std::size_t index) noexcept
{
  const SurfacePatchTreeOf<Surface>& tree = this->Search->Tree();
  Cell& cell = this->Cells[index];
  const int node = cell.Node;
  if (!tree.IsInner(node))
  {
    cell.Node = None;
    cell.IsEvaluated = false;
    cell.Triangle = tree.Triangle(node);
    cell.Cap = tree.CapOf(node);
    return Step::Again;
  }
  if (this->CellCount + 3 > CellCapacity)
  {
    return Step::Open;
  }
  const std::array<std::size_t, 4> places{index, this->CellCount, this->CellCount + 1,
                                          this->CellCount + 2};
  for (std::size_t part = 0; part < 4; ++part)
  {
    this->Cells[places[part]].Node =
        SurfacePatchTreeOf<Surface>::FirstPart(node) + static_cast<int>(part);
    this->ClearUntil[places[part]] = this->ClearUntil[index];
  }
  this->AddNear(3);
  return Step::Again;
}

template <typename Surface>
typename ClearanceProofOf<Surface>::Step
ClearanceProofOf<Surface>::CutTriangle(std::size_t index) noexcept
{
  if (this->CellCount + 3 > CellCapacity)
  {
    return Step::Open;
  }
  const std::array<SphericalTriangle, 4> parts = this->Cells[index].Triangle.Split();
  const std::array<std::size_t, 4> places{index, this->CellCount, this->CellCount + 1,
                                          this->CellCount + 2};
  for (std::size_t part = 0; part < 4; ++part)
  {
    Cell& cell = this->Cells[places[part]];
    cell.Node = None;
    cell.IsEvaluated = false;
    cell.Triangle = parts[part];
    cell.Cap = parts[part].Cap();
    this->ClearUntil[places[part]] = this->ClearUntil[index];
  }
  this->AddNear(3);
  return Step::Again;
}

template class ClearanceProofOf<SphericalHarmonicModel>;
template class ClearanceProofOf<ParametricShape>;
} // namespace palpate
