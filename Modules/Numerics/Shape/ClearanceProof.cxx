#include "ClearanceProof.h"

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

template <typename Surface>
bool IsSame(const ClosestPointOf<Surface>& a, const ClosestPointOf<Surface>& b) noexcept
{
  constexpr double Apart = ClearanceProofOf<Surface>::Apart;
  return (a.Direction - b.Direction).squaredNorm() < Apart * Apart;
}
} // namespace

// One query.
template <typename Surface>
struct ClearanceProofOf<Surface>::Task
{
  struct Basin
  {
    Vector3 Direction;
    double Angle;
    double LowerDistance; // infinite around known minima
  };

  void Add(const typename ClosestPointDescentOf<Surface>::Basin& around, const Vector3& direction,
           double lowerDistance) noexcept
  {
    if (this->BasinCount < this->Basins.size())
    {
      constexpr double Widest = 2.0; // rad
      this->Basins[this->BasinCount++] = {direction, std::min(around.Angle, Widest), lowerDistance};
    }
  }
  // Lower bound of the cap's distance by the basins that cover it, mm.
  double LowerDistance(const SphericalCap& cap) const noexcept
  {
    double lower = 0.0;
    for (std::size_t i = 0; i < this->BasinCount; ++i)
    {
      const Basin& basin = this->Basins[i];
      const double margin = basin.Angle - cap.Radius;
      const double chord = (cap.Center - basin.Direction).norm();
      // An angle is less than this up to 2.6 rad.
      if (chord * (1.0 + 0.1 * chord * chord) < margin)
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
                       { return (basin.Direction - direction).norm() < basin.Angle + reach; });
  }
  bool IsKnown(const ClosestPoint& minimum) const noexcept
  {
    return std::any_of(this->Known, this->Known + this->KnownCount,
                       [&](const ClosestPoint& known) { return IsSame(known, minimum); });
  }

  Vector3 Query;
  const ClosestPoint* Known;
  std::size_t KnownCount;
  int EvaluationsLeft;
  double Rounding; // of distances, mm
  Answer Result;
  std::array<Basin, 2 * MostKnown> Basins;
  std::size_t BasinCount = 0;
};

template <typename Surface>
ClearanceProofOf<Surface>::ClearanceProofOf(const ClosestPointSearchOf<Surface>& search,
                                            double distance, double tolerance) noexcept
    : Search(&search), Needed(distance - tolerance)
{
  this->BeginAfresh();
}

template <typename Surface>
void ClearanceProofOf<Surface>::BeginAfresh() noexcept
{
  this->PathLength = 0.0;
  this->CellCount = SurfacePatchTreeOf<Surface>::RootCount;
  for (std::size_t root = 0; root < this->CellCount; ++root)
  {
    this->ClearUntil[root] = -Infinite;
    this->Cells[root].Node = static_cast<int>(root);
  }
}

template <typename Surface>
void ClearanceProofOf<Surface>::GoTo(const Vector3& query) noexcept
{
  this->PathLength += (query - this->Query).norm();
  this->Query = query;
  // Keeps the rounding of the path length far below any tolerance, and drops the many cells that
  // were split for places left behind.
  if (!(this->PathLength < 1e4 * this->Search->Tree().LargestRadius()) ||
      this->CellCount > CellCapacity * 3 / 4)
  {
    this->BeginAfresh();
  }
}

template <typename Surface>
typename ClearanceProofOf<Surface>::Answer
ClearanceProofOf<Surface>::Ask(const Vector3& queryWorld, const ClosestPoint* known,
                               std::size_t knownCount, int evaluationLimit) noexcept
{
  this->GoTo(queryWorld - this->Search->Model().CenterWorld());
  const ClosestPointDescentOf<Surface>& descent = this->Search->Descent();
  Task task;
  task.Known = known;
  task.KnownCount = std::min(knownCount, MostKnown);
  task.EvaluationsLeft = evaluationLimit;
  task.Rounding = descent.Rounding(this->Query);
  task.Result.State = Finding::Clear;
  task.Result.LowerDistance = this->Needed;
  for (std::size_t i = 0; i < task.KnownCount; ++i)
  {
    auto basin = descent.BasinAround(this->Query, known[i]);
    basin.Angle = std::max(basin.Angle, Apart);
    task.Add(basin, known[i].SampleDirection, Infinite);
  }
  for (std::size_t i = 0; i < this->CellCount && task.Result.State != Finding::Nearer; ++i)
  {
    this->Settle(task, i);
  }
  return task.Result;
}

template <typename Surface>
void ClearanceProofOf<Surface>::Settle(Task& task, std::size_t index) noexcept
{
  Step step = Step::Again;
  while (step == Step::Again)
  {
    const bool isClear = this->ClearUntil[index] >= this->PathLength;
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
  return until >= this->PathLength;
}

template <typename Surface>
typename ClearanceProofOf<Surface>::Step
ClearanceProofOf<Surface>::SettleNode(Task& task, std::size_t index) noexcept
{
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
typename ClearanceProofOf<Surface>::Step
ClearanceProofOf<Surface>::SettleTriangle(Task& task, std::size_t index) noexcept
{
  Cell& cell = this->Cells[index];
  const double inBasin = task.LowerDistance(cell.Cap);
  if (inBasin == Infinite || this->Clears(inBasin, index))
  {
    return Step::Settled;
  }
  if (!cell.IsEvaluated)
  {
    if (task.EvaluationsLeft <= 0)
    {
      return Step::Open;
    }
    --task.EvaluationsLeft;
    cell.Sample = this->Search->Model().EvaluateSecondOrder(cell.Cap.Center);
    cell.IsEvaluated = true;
  }
  const double lower = this->Search->Descent().LowerDistance(this->Query, cell.Cap.Center,
                                                             cell.Sample, cell.Cap.Radius);
  if (this->Clears(lower - task.Rounding, index))
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
  bool isWorthwhile = distance.Offset.norm() < this->Needed;
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
  if (task.EvaluationsLeft <= 0)
  {
    return Step::Open;
  }
  const ClosestPointDescentOf<Surface>& descent = this->Search->Descent();
  const ClosestPointOf<Surface> found = descent.Run(this->Query, cell.Cap.Center, cell.Sample,
                                                    MinimumTolerance, task.EvaluationsLeft);
  task.EvaluationsLeft -= found.Evaluations;
  if (std::abs(found.SignedDistance) < this->Needed && !task.IsKnown(found))
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
  this->CellCount += 3;
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
  this->CellCount += 3;
  return Step::Again;
}

template class ClearanceProofOf<SphericalHarmonicModel>;
template class ClearanceProofOf<ParametricShape>;
} // namespace palpate
