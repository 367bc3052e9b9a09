#pragma once

#include "Vector3.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace palpate::test
{
/// Accuracy of rendered forces relative to ideal ones, tick by tick, in N and rad. A NaN force
/// makes error and angles NaN.
class ForceQuality
{
public:
  /// Starts a new path: the next force is not a jump from the last one.
  void BeginPath() { this->HasLast = false; }

  /// Adds one tick of a path in which both are in contact.
  void Add(const Vector3& force, const Vector3& ideal)
  {
    this->SquaredErrors += (force - ideal).squaredNorm();
    this->Angles.push_back(std::atan2(force.cross(ideal).norm(), force.dot(ideal)));
    this->IsFinite = this->IsFinite && force.allFinite() && ideal.allFinite();
    if (this->HasLast)
    {
      this->Felt.Add(force, this->LastForce);
      this->Ideal.Add(ideal, this->LastIdeal);
    }
    this->LastForce = force;
    this->LastIdeal = ideal;
    this->HasLast = true;
  }

  /// Differences from one tick to the next.
  class Jumps
  {
  public:
    void Add(const Vector3& force, const Vector3& before)
    {
      const double jump = (force - before).norm();
      const double relative = jump / std::max(force.norm(), before.norm());
      this->Sum += jump;
      this->Largest = std::max(this->Largest, jump);
      this->RelativeSum += relative;
      this->RelativeLargest = std::max(this->RelativeLargest, relative);
      ++this->Count;
    }
    double Mean() const { return this->Sum / static_cast<double>(this->Count); }
    double Maximum() const { return this->Largest; }
    /// Relative to the larger of both forces.
    double RelativeMean() const { return this->RelativeSum / static_cast<double>(this->Count); }
    double RelativeMaximum() const { return this->RelativeLargest; }

  private:
    double Sum = 0.0;
    double Largest = 0.0;
    double RelativeSum = 0.0;
    double RelativeLargest = 0.0;
    std::size_t Count = 0;
  };

  std::size_t Ticks() const { return this->Angles.size(); }
  double ErrorRms() const
  {
    return std::sqrt(this->SquaredErrors / static_cast<double>(this->Ticks()));
  }
  double MeanAngle() const
  {
    double sum = 0.0;
    for (const double angle : this->Angles)
    {
      sum += angle;
    }
    return sum / static_cast<double>(this->Ticks());
  }
  /// The angle that a fraction `part` (0 to 1) of the ticks does not exceed.
  double AngleQuantile(double part) const
  {
    if (!this->IsFinite || this->Angles.empty())
    {
      return NAN;
    }
    std::vector<double> sorted = this->Angles;
    const double last = static_cast<double>(sorted.size() - 1);
    const auto place = sorted.begin() + static_cast<std::ptrdiff_t>(part * last);
    std::nth_element(sorted.begin(), place, sorted.end());
    return *place;
  }
  const Jumps& FeltJumps() const { return this->Felt; }
  const Jumps& IdealJumps() const { return this->Ideal; }

private:
  bool IsFinite = true;
  double SquaredErrors = 0.0;
  std::vector<double> Angles;
  Jumps Felt;
  Jumps Ideal;
  bool HasLast = false;
  Vector3 LastForce = Vector3::Zero();
  Vector3 LastIdeal = Vector3::Zero();
};
} // namespace palpate::test
