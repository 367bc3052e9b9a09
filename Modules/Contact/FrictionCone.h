#pragma once

#include "Status.h"
#include "SurfaceFriction.h"
#include "Vector3.h"

#include <cmath>

namespace palpate
{
/// Coulomb's law for a proxy that the probe pulls by a spring: the pull's component along the
/// surface against the component into it, so that the stiffness cancels (Zilles and Salisbury, "A
/// constraint-based god-object method for haptic display", IROS 1995).
class FrictionCone
{
public:
  /// The probe's pull on its proxy, mm.
  struct Pull
  {
    double Into;  ///< the surface; negative if it lifts off
    double Along; ///< the surface; at least 0

    Pull(const Vector3& proxyToProbe, const Vector3& normal) noexcept
        : Into(-proxyToProbe.dot(normal)), Along((proxyToProbe + this->Into * normal).norm())
    {
    }
  };

  explicit FrictionCone(const SurfaceFriction& friction) noexcept : Friction(friction) {}

  /// Fails for coefficients that are negative or not finite, and for dynamic friction above static.
  static Status Check(const SurfaceFriction& friction)
  {
    const bool isFriction = friction.Dynamic >= 0.0 && friction.Dynamic <= friction.Static &&
                            std::isfinite(friction.Static);
    return isFriction ? Status::Success()
                      : Status::Failure("Friction must be finite and 0 <= dynamic <= static.");
  }

  bool IsFrictionless() const noexcept { return this->Friction.Static == 0.0; }
  bool Sticks(const Pull& pull) const noexcept
  {
    return pull.Along <= this->Friction.Static * pull.Into;
  }
  /// Amount (mm) by which the pull along the surface exceeds the resistance of a slipping proxy: 0
  /// where it comes to rest.
  double Excess(const Pull& pull) const noexcept
  {
    return pull.Along - this->Friction.Dynamic * pull.Into;
  }

  /// Goal of a proxy instead of the probe: the pull, reduced by friction. A sticking proxy is drawn
  /// straight into the surface.
  Vector3 DrawnTo(const Vector3& probe, const Vector3& proxy, const Vector3& normal) const noexcept
  {
    const Pull pull(probe - proxy, normal);
    if (this->IsFrictionless() || pull.Into <= 0.0)
    {
      return probe;
    }
    const double left = this->Sticks(pull) ? 0.0 : this->Excess(pull);
    const Vector3 into = proxy - pull.Into * normal;
    return into + (pull.Along > 0.0 ? left / pull.Along : 0.0) * (probe - into);
  }

  /// Finds where on a way a slipping proxy comes to rest again: calls `pullAt(part)`, which returns
  /// the pull there, for parts of the way that approach that place, the nearest one last. `before`
  /// and `after` are the pulls at its ends; without a place between them it is not called. A root
  /// by the Illinois form of the false position.
  template <typename PullAt>
  void FindRest(const Pull& before, const Pull& after, const PullAt& pullAt) const
  {
    constexpr int MostSteps = 12;
    constexpr double Enough = 1e-6; // relative to the pull
    double first = 0.0;
    double last = 1.0;
    double excessFirst = this->Excess(before);
    double excessLast = this->Excess(after);
    int lastSide = 0;
    for (int step = 0; step < MostSteps && excessFirst > 0.0 && excessLast < 0.0; ++step)
    {
      const double part = (first * excessLast - last * excessFirst) / (excessLast - excessFirst);
      const Pull pull = pullAt(part);
      const double excess = this->Excess(pull);
      if (std::abs(excess) <= Enough * pull.Along)
      {
        return;
      }
      const int side = excess > 0.0 ? 1 : -1;
      (side > 0 ? first : last) = part;
      (side > 0 ? excessFirst : excessLast) = excess;
      if (side == lastSide) // the other end has not moved: halved, it moves the next time
      {
        (side > 0 ? excessLast : excessFirst) *= 0.5;
      }
      lastSide = side;
    }
  }

private:
  SurfaceFriction Friction;
};
} // namespace palpate
