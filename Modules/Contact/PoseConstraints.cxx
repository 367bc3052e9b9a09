#include "PoseConstraints.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr std::size_t MostHeld = 6; // more depend on each other
using HeldSystem = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, MostHeld, MostHeld>;
using HeldPushes = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, MostHeld, 1>;

void Apply(const Vector3& shift, const Vector3& arm, double perTurn, Twist& twist) noexcept
{
  twist.Shift += shift;
  twist.Turn += perTurn * arm.cross(shift);
}

double GapAfter(const PoseConstraint& at, const Twist& twist) noexcept
{
  return at.Normal.dot(twist.Shift + twist.Turn.cross(at.Arm)) + at.Gap;
}

// The multipliers of few constraints with which all of them just hold; empty if they depend on each
// other, or one of them would have to pull.
HeldPushes PushesThatHold(const std::array<PoseConstraint*, MostHeld>& held, Eigen::Index count,
                          const Twist& wanted, double perTurn)
{
  constexpr double LeastPivot = 1e-8;
  HeldSystem system(count, count);
  HeldPushes lacking(count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const PoseConstraint& at = *held[static_cast<std::size_t>(i)];
    lacking[i] = -GapAfter(at, wanted);
    for (Eigen::Index j = 0; j <= i; ++j)
    {
      const PoseConstraint& other = *held[static_cast<std::size_t>(j)];
      system(i, j) = system(j, i) =
          at.Normal.dot(other.Normal) +
          perTurn * at.Arm.cross(at.Normal).dot(other.Arm.cross(other.Normal));
    }
  }
  const Eigen::LDLT<HeldSystem> solver(system);
  if (!(solver.vectorD().minCoeff() > LeastPivot))
  {
    return HeldPushes(0);
  }
  const HeldPushes pushes = solver.solve(lacking);
  return pushes.minCoeff() >= 0.0 ? pushes : HeldPushes(0);
}
} // namespace

void PoseConstraints::Add(const PoseConstraint& constraint) noexcept
{
  PoseConstraint* place = this->All.data() + this->Count;
  if (this->Count < Most)
  {
    ++this->Count;
  }
  else
  {
    place = std::max_element(this->All.data(), place,
                             [](const auto& a, const auto& b) { return a.Gap < b.Gap; });
    if (constraint.Gap >= place->Gap)
    {
      return;
    }
  }
  *place = constraint;
  place->Owner = this->Owner;
}

void PoseConstraints::StartFrom(const PoseConstraints& solved) noexcept
{
  for (std::size_t n = 0; n < this->Count; ++n)
  {
    PoseConstraint& at = this->All[n];
    const auto* const same = std::find_if(
        solved.begin(), solved.end(),
        [&](const auto& one) { return one.Source == at.Source && one.Owner == at.Owner; });
    if (same != solved.end())
    {
      at.Push = same->Push;
      at.IsSlipping = same->IsSlipping;
      at.Drag = same->Drag - same->Drag.dot(at.Normal) * at.Normal;
    }
  }
}

void PoseConstraints::ForgetPushes() noexcept
{
  for (std::size_t n = 0; n < this->Count; ++n)
  {
    this->All[n].Push = 0.0;
    this->All[n].Drag.setZero();
    this->All[n].Friction = {};
  }
}

// What a push does, in the units of a sweep: its lever, and by how much its point moves for a unit.
struct PoseConstraints::PushRow
{
  Vector3 Lever;
  double PerGap = 0.0;
};

// Returns by how much the multiplier changes, mm.
double PoseConstraints::PushOne(PoseConstraint& at, const PushRow& row, double perTurn,
                                Twist& twist) noexcept
{
  const double gap = at.Normal.dot(twist.Shift) + row.Lever.dot(twist.Turn) + at.Gap;
  const double by = std::max(-at.Push, -gap * row.PerGap);
  at.Push += by;
  twist.Shift += by * at.Normal;
  twist.Turn += by * perTurn * row.Lever;
  return std::abs(by);
}

double PoseConstraints::DragOne(PoseConstraint& at, Twist& twist, double perTurn) const noexcept
{
  const Vector3 motion = twist.Shift + twist.Turn.cross(at.Arm);
  const Vector3 along = motion - motion.dot(at.Normal) * at.Normal;
  Vector3 drag = at.Drag - along / (1.0 + perTurn * at.Arm.squaredNorm());
  const double size = drag.norm();
  const double holds = at.IsSlipping ? at.Friction.Dynamic : at.Friction.Static;
  at.IsSlipping = size > holds * at.Push;
  if (at.IsSlipping)
  {
    drag *= at.Friction.Dynamic * at.Push / size;
  }
  const Vector3 by = drag - at.Drag;
  at.Drag = drag;
  Apply(by, at.Arm, perTurn, twist);
  return by.norm();
}

// The solution in which those that push now hold, and no others, if it is allowed: there is only
// one.
bool PoseConstraints::SolveHeld(const Twist& wanted, double perTurn, Twist& twist) noexcept
{
  constexpr double Touching = 1e-9; // mm
  std::array<PoseConstraint*, MostHeld> held{};
  std::size_t count = 0;
  for (std::size_t n = 0; n < this->Count; ++n)
  {
    if (this->All[n].Push > 0.0 && count == MostHeld)
    {
      return false;
    }
    if (this->All[n].Push > 0.0)
    {
      held[count++] = &this->All[n];
    }
  }
  const HeldPushes pushes =
      count > 0 ? PushesThatHold(held, static_cast<Eigen::Index>(count), wanted, perTurn)
                : HeldPushes(0);
  Twist solved = wanted;
  for (Eigen::Index i = 0; i < pushes.size(); ++i)
  {
    const PoseConstraint& at = *held[static_cast<std::size_t>(i)];
    Apply(pushes[i] * at.Normal, at.Arm, perTurn, solved);
  }
  const bool isAllowed =
      pushes.size() == static_cast<Eigen::Index>(count) &&
      std::all_of(this->begin(), this->end(),
                  [&](const PoseConstraint& at) { return GapAfter(at, solved) > -Touching; });
  for (Eigen::Index i = 0; isAllowed && i < pushes.size(); ++i)
  {
    held[static_cast<std::size_t>(i)]->Push = pushes[i];
  }
  twist = isAllowed ? solved : twist;
  return isAllowed;
}

Twist PoseConstraints::Solve(const Twist& wanted, double length) noexcept
{
  constexpr int MostSweeps = 60;
  constexpr int SweepsToTry = 4;
  constexpr double Settled = 1e-9; // mm, of the multipliers
  const double perTurn = 1.0 / (length * length);
  Twist twist = wanted;
  for (const PoseConstraint& at : *this)
  {
    Apply(at.Shift(), at.Arm, perTurn, twist);
  }
  const bool isSlippery =
      std::all_of(this->begin(), this->end(),
                  [](const PoseConstraint& at) { return at.Friction.Static == 0.0; });
  std::array<PushRow, Most> rows;
  for (std::size_t n = 0; n < this->Count; ++n)
  {
    rows[n].Lever = this->All[n].Arm.cross(this->All[n].Normal);
    rows[n].PerGap = 1.0 / (1.0 + perTurn * rows[n].Lever.squaredNorm());
  }
  for (int sweep = 0; sweep < MostSweeps; ++sweep)
  {
    double change = 0.0;
    for (std::size_t n = 0; n < this->Count; ++n)
    {
      PoseConstraint& at = this->All[n];
      change = std::max(change, PushOne(at, rows[n], perTurn, twist));
      if (at.Friction.Static > 0.0)
      {
        change = std::max(change, this->DragOne(at, twist, perTurn));
      }
    }
    const bool isTried = isSlippery && sweep % SweepsToTry == SweepsToTry - 1;
    if (change < Settled || (isTried && this->SolveHeld(wanted, perTurn, twist)))
    {
      break;
    }
  }
  return twist;
}
} // namespace palpate
