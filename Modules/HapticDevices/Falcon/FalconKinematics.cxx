#include "FalconKinematics.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr int LargestIterations = 30;
constexpr int LargestHalvings = 12;
constexpr double LongestMove = 20.0; // mm
constexpr double Converged = 1e-12;  // rad; a tenth of a millionth of a count
constexpr double Acceptable = 1e-9;  // rad, where rounding allows no better
// Relative to the centre's; within the workspace of 40 mm it falls to 0.8. Other assembly modes lie
// beyond poses where it vanishes.
constexpr double LeastDeterminant = 0.1;
constexpr double SmallestSine = 1e-3; // of angles in denominators
} // namespace

FalconKinematics::FalconKinematics(const FalconGeometry& geometry)
    : Lengths(geometry), Cosines(geometry.LegDirections.array().cos()),
      Sines(geometry.LegDirections.array().sin())
{
  Vector3 angles;
  Matrix3 jacobian;
  if (this->Evaluate(this->Center(), angles, jacobian))
  {
    this->Determinant = jacobian.determinant();
  }
}

bool FalconKinematics::Solve(int leg, const Vector3& position, Leg& solution) const noexcept
{
  const FalconGeometry& g = this->Lengths;
  const double cosine = this->Cosines[leg];
  const double sine = this->Sines[leg];
  const double u = position[0] * cosine + position[1] * sine - g.BaseRadial + g.PlatformRadial;
  const double v = position[1] * cosine - position[0] * sine - g.BaseTangential;
  const double w = position[2];

  // Cosine and sine of the shin's angle out of the leg's plane.
  const double aside = (v + g.PlatformTangential) / g.Shin;
  const double lean = std::sqrt(std::max(0.0, 1.0 - aside * aside));
  const double reach = g.KneeOffset + g.AnkleOffset + g.Shin * lean;
  const double length = std::hypot(u, w);
  const double k = (u * u + w * w + g.Thigh * g.Thigh - reach * reach) / (2.0 * g.Thigh);
  // Written so that NaN is refused.
  if (!(lean > SmallestSine && std::abs(k) < length))
  {
    return false;
  }
  const double thigh = std::atan2(w, u) - std::acos(k / length);
  const double thighCosine = std::cos(thigh);
  const double thighSine = std::sin(thigh);
  // Of the shin's angle in the leg's plane, and of the bend at the knee.
  const double shinCosine = (u - g.Thigh * thighCosine) / reach;
  const double shinSine = (w - g.Thigh * thighSine) / reach;
  const double bend = shinSine * thighCosine - shinCosine * thighSine;
  if (!(bend > SmallestSine))
  {
    return false;
  }
  const double d = g.Thigh * bend;
  solution = {thigh, shinCosine / d, aside / lean / d, shinSine / d};
  return true;
}

bool FalconKinematics::Evaluate(const Vector3& position, Vector3& angles,
                                Matrix3& jacobian) const noexcept
{
  for (int leg = 0; leg < 3; ++leg)
  {
    Leg solution;
    if (!this->Solve(leg, position, solution))
    {
      return false;
    }
    const double cosine = this->Cosines[leg];
    const double sine = this->Sines[leg];
    jacobian.row(leg) << cosine * solution.ByRadial - sine * solution.ByTangential,
        sine * solution.ByRadial + cosine * solution.ByTangential, solution.ByHeight;
    angles[leg] = solution.Thigh;
  }
  return true;
}

bool FalconKinematics::IsInside(const Vector3& position, const Vector3& angles,
                                const Matrix3& jacobian) const noexcept
{
  return position[2] > 0.0 && jacobian.determinant() / this->Determinant > LeastDeterminant &&
         angles.minCoeff() >= this->Lengths.LowestAngle &&
         angles.maxCoeff() <= this->Lengths.HighestAngle;
}

bool FalconKinematics::AnglesAt(const Vector3& position, Vector3& angles) const noexcept
{
  Vector3 found;
  Matrix3 jacobian;
  if (!this->Evaluate(position, found, jacobian) || !this->IsInside(position, found, jacobian))
  {
    return false;
  }
  angles = found;
  return true;
}

bool FalconKinematics::Jacobian(const Vector3& position, Matrix3& jacobian) const noexcept
{
  Vector3 angles;
  Matrix3 found;
  if (!this->Evaluate(position, angles, found) || !this->IsInside(position, angles, found))
  {
    return false;
  }
  jacobian = found;
  return true;
}

bool FalconKinematics::Descend(const Vector3& angles, Vector3& position) const noexcept
{
  Vector3 reached;
  Matrix3 jacobian;
  if (!this->Evaluate(position, reached, jacobian))
  {
    return false;
  }
  double error = (angles - reached).cwiseAbs().maxCoeff();
  for (int iteration = 0; iteration < LargestIterations && !(error <= Converged); ++iteration)
  {
    Vector3 step = jacobian.inverse() * (angles - reached);
    step *= std::min(1.0, LongestMove / step.norm());
    bool isNearer = false;
    for (int halving = 0; halving < LargestHalvings && !isNearer; ++halving)
    {
      const Vector3 next = position + step;
      Matrix3 nextJacobian;
      Vector3 nextReached;
      const bool isReachable = this->Evaluate(next, nextReached, nextJacobian);
      const double nextError = (angles - nextReached).cwiseAbs().maxCoeff();
      isNearer = isReachable && nextError < error;
      if (isNearer)
      {
        position = next;
        jacobian = nextJacobian;
        reached = nextReached;
        error = nextError;
      }
      step *= 0.5;
    }
    if (!isNearer)
    {
      break;
    }
  }
  return error <= Acceptable && this->IsInside(position, angles, jacobian);
}

bool FalconKinematics::PositionAt(const Vector3& angles, const Vector3& start,
                                  Vector3& position) const noexcept
{
  if (!angles.allFinite())
  {
    return false;
  }
  for (const Vector3& first : {start, this->Center()})
  {
    Vector3 found = first;
    if (first.allFinite() && this->Descend(angles, found))
    {
      position = found;
      return true;
    }
  }
  return false;
}

bool FalconKinematics::TorquesFor(const Vector3& force, const Vector3& position,
                                  Vector3& torques) const noexcept
{
  Matrix3 jacobian;
  if (!this->Jacobian(position, jacobian) || !force.allFinite())
  {
    return false;
  }
  const Vector3 found = jacobian.inverse().transpose() * force;
  if (!found.allFinite())
  {
    return false;
  }
  torques = found;
  return true;
}

double FalconKinematics::LeastForce(double torque, const Vector3& position) const noexcept
{
  Matrix3 jacobian;
  if (!this->Jacobian(position, jacobian))
  {
    return 0.0;
  }
  const Matrix3 motion = jacobian.inverse();
  return motion.allFinite() ? torque / motion.colwise().norm().maxCoeff() : 0.0;
}
} // namespace palpate
