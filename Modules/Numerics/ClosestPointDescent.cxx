#include "ClosestPointDescent.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr double Infinite = std::numeric_limits<double>::infinity();
} // namespace

struct ClosestPointDescent::LocalBounds
{
  double First;    // |x'|, mm/rad
  double Second;   // |x''|, mm/rad^2
  double Third;    // |x'''| everywhere, mm/rad^3
  double Distance; // |x - q|, mm
  double Noise;    // rounding of the gradient of f, mm^2/rad

  // |f'''| on arcs through the sample up to this angle.
  double ThirdOfF(double angle) const noexcept
  {
    const double second = this->Second + angle * this->Third;
    const double first = this->First + angle * second;
    return 3.0 * first * second + (this->Distance + angle * first) * this->Third;
  }
  // f is above its quadratic expansion less angle^3 / 6 times this. With e the quadratic expansion
  // of x - q, f = |e|^2 / 2 + e.r + |r|^2 / 2 with |r| <= angle^3 |x'''| / 6, and the first term
  // has only x'.x'' at third order and a square at fourth.
  double Fall(double angle) const noexcept
  {
    return 3.0 * this->First * this->Second +
           (this->Distance + angle * (this->First + 0.5 * angle * this->Second)) * this->Third;
  }
};

struct ClosestPointDescent::Remainder
{
  double Eigenvalue; // lower bound of the Hessian's at the end of the step, mm^2/rad^2
  double Gradient;   // upper bound of what is left of it there, mm^2/rad
  double Angle;      // the minimum is within this of the end, rad; infinite if not known
};

ClosestPointDescent::ClosestPointDescent(const SphericalHarmonicModel& model)
    : Model(&model), Derivatives(model), Size(Derivatives.Radius[0] + model.CenterWorld().norm()),
      UnitRounding(4.0 * (model.Degree() + 4.0) * std::numeric_limits<double>::epsilon()),
      LongestStep(2.0 / (model.Degree() + 1.0))
{
}

ClosestPointDescent::LocalBounds
ClosestPointDescent::BoundsAt(const SphericalHarmonicModel::SecondOrderSample& sample,
                              const SquaredDistance& distance, const Vector3& query) const noexcept
{
  const double slope = sample.SurfaceGradient.squaredNorm();
  const double bend = sample.SurfaceHessian.norm() + std::abs(sample.Radius);
  const double first = std::sqrt(sample.Radius * sample.Radius + slope);
  return {first, std::sqrt(bend * bend + 4.0 * slope), this->Derivatives.PointThird,
          distance.Offset.norm(), first * this->Rounding(query)};
}

ClosestPointDescent::Remainder ClosestPointDescent::After(double step,
                                                          const SquaredDistance& distance,
                                                          const LocalBounds& bounds) const noexcept
{
  const double gradient = distance.Gradient.norm();
  // The third covariant derivative is symmetric up to the curvature of the sphere times the
  // gradient; a symmetric form is largest with three equal arguments.
  const double third = bounds.ThirdOfF(step) + 2.0 * gradient;
  const double eigenvalue = distance.SmallestEigenvalue - step * third;
  const double left = bounds.Noise + (step > 0.0 ? 0.5 * step * step * third : gradient);
  const double angle = 4.0 * left / eigenvalue;
  const bool known = eigenvalue > 0.0 && angle * bounds.ThirdOfF(step + angle) <= 1.5 * eigenvalue;
  return {eigenvalue, left, known ? angle : Infinite};
}

void ClosestPointDescent::Finish(const Vector3& query, const Vector3& step,
                                 const SquaredDistance& distance, const Remainder& remainder,
                                 ClosestPoint& point) const noexcept
{
  const auto& sample = point.Sample;
  const Vector3& u = point.SampleDirection;
  const Vector3& g = sample.SurfaceGradient;
  const Vector3 bent = sample.SurfaceHessian * step;
  const double slope = g.dot(step);
  const double radius = sample.Radius + slope + 0.5 * step.dot(bent);
  point.Direction = (u + step).normalized();
  const Vector3 surface = radius * point.Direction;
  const Vector3 normal = surface - (g + bent - slope * u);
  const double size = normal.norm();
  point.Normal = size > 0.0 ? Vector3(normal / size) : point.Direction;
  point.PointWorld = this->Model->CenterWorld() + surface;
  const Vector3 offset = query - surface;
  const double length = offset.norm();
  point.SignedDistance = std::copysign(length, offset.dot(point.Normal));

  point.PositionError = Infinite;
  point.DistanceError = Infinite;
  if (remainder.Angle < Infinite)
  {
    const double angle = step.norm();
    const double expansion =
        this->Derivatives.PointThird * angle * angle * angle / 6.0 + this->Rounding(query);
    const LocalBounds bounds = this->BoundsAt(sample, distance, query);
    const double reach = angle + remainder.Angle;
    const double first = bounds.First + reach * (bounds.Second + reach * bounds.Third);
    point.PositionError = remainder.Angle * first + expansion;
    const double drop = 2.0 * remainder.Gradient * remainder.Gradient / remainder.Eigenvalue;
    const double square = length * length;
    point.DistanceError =
        (drop < square ? drop / (length + std::sqrt(square - drop)) : length) + expansion;
  }
}

bool ClosestPointDescent::Advance(const Vector3& query, double noise, int evaluationLimit,
                                  ClosestPoint& point, SquaredDistance& distance) const noexcept
{
  // Far below any eigenvalue that matters; keeps the step finite.
  const double metric = point.Sample.Radius * point.Sample.Radius;
  const double least = 1e-9 * (std::abs(distance.Trace) + metric) + noise;
  const double smallest = distance.SmallestEigenvalue;
  const double shift = smallest >= least ? 0.0 : std::max(-smallest, least) - smallest;
  Vector3 step = distance.Step(shift);
  const double length = step.norm();
  step *= length > this->LongestStep ? this->LongestStep / length : 1.0;
  const Vector3 from = point.Sample.Radius * point.SampleDirection;
  const double unresolved = distance.Offset.norm() * this->Rounding(query);
  while (point.Evaluations < evaluationLimit)
  {
    const Vector3 direction = (point.SampleDirection + step).normalized();
    const auto sample = this->Model->EvaluateSecondOrder(direction);
    ++point.Evaluations;
    const SquaredDistance there(direction, sample, query);
    const double change =
        0.5 * (from - sample.Radius * direction).dot(there.Offset + distance.Offset);
    if (change <= 1e-4 * distance.Gradient.dot(step) + unresolved)
    {
      point.SampleDirection = direction;
      point.Sample = sample;
      distance = there;
      return true;
    }
    step *= 0.25;
  }
  return false;
}

ClosestPoint ClosestPointDescent::Run(const Vector3& query, const Vector3& direction,
                                      const SphericalHarmonicModel::SecondOrderSample& sample,
                                      double tolerance, int evaluationLimit) const noexcept
{
  ClosestPoint point;
  point.SampleDirection = direction;
  point.Sample = sample;
  SquaredDistance distance(direction, sample, query);
  for (;;)
  {
    const LocalBounds bounds = this->BoundsAt(point.Sample, distance, query);
    const bool stationary = distance.Gradient.norm() <= bounds.Noise;
    if (distance.SmallestEigenvalue > 0.0)
    {
      const Vector3 step = distance.Step(0.0);
      const Remainder remainder = this->After(step.norm(), distance, bounds);
      if (remainder.Angle <= tolerance || (stationary && remainder.Angle < Infinite))
      {
        this->Finish(query, step, distance, remainder, point);
        point.State = ClosestPoint::Outcome::Minimum;
        return point;
      }
    }
    if (stationary || !this->Advance(query, bounds.Noise, evaluationLimit, point, distance))
    {
      const LocalBounds last = this->BoundsAt(point.Sample, distance, query);
      this->Finish(query, Vector3::Zero(), distance, this->After(0.0, distance, last), point);
      point.State = stationary ? ClosestPoint::Outcome::Stationary : ClosestPoint::Outcome::Limit;
      break;
    }
  }
  if (!std::isfinite(point.SignedDistance))
  {
    point.State = ClosestPoint::Outcome::BadInput;
  }
  return point;
}

ClosestPointDescent::Basin
ClosestPointDescent::BasinAround(const Vector3& query, const ClosestPoint& point) const noexcept
{
  const SquaredDistance distance(point.SampleDirection, point.Sample, query);
  const double smallest = distance.SmallestEigenvalue;
  if (!(smallest > 0.0))
  {
    return {};
  }
  const LocalBounds bounds = this->BoundsAt(point.Sample, distance, query);
  // Where angle * Fall(angle) is 1.5 times the eigenvalue; the last step makes it no more.
  double angle = 1.5 * smallest / bounds.Fall(0.0);
  for (int i = 0; i < 4; ++i)
  {
    angle = std::sqrt(angle * 1.5 * smallest / bounds.Fall(angle));
  }
  angle = std::min(angle, 1.5 * smallest / bounds.Fall(angle));
  // At the distance a from the expansion's minimum, itself s from the sample, f is above that by
  // smallest a^2 / 2 - Fall (a + s)^3 / 6: positive for a > 10 s, and no less than this before.
  const Vector3 step = distance.Step(0.0);
  const double length = 11.0 * step.norm();
  const double least = 0.5 * (distance.Offset.squaredNorm() + distance.Gradient.dot(step)) -
                       length * length * length * bounds.Fall(length) / 6.0;
  return {angle, std::sqrt(std::max(0.0, 2.0 * least)) - this->Rounding(query)};
}

double ClosestPointDescent::LowerDistance(const Vector3& query, const Vector3& direction,
                                          const SphericalHarmonicModel::SecondOrderSample& sample,
                                          double reach) const noexcept
{
  const SquaredDistance distance(direction, sample, query);
  const LocalBounds bounds = this->BoundsAt(sample, distance, query);
  const double smallest = distance.SmallestEigenvalue;
  double change = 0.0; // of the quadratic expansion, at least
  if (smallest > 0.0)
  {
    const Vector3 step = distance.Step(0.0);
    const double beyond = std::max(0.0, step.norm() - reach);
    change = 0.5 * (distance.Gradient.dot(step) + smallest * beyond * beyond);
  }
  else
  {
    change = reach * (0.5 * reach * smallest - distance.Gradient.norm());
  }
  const double least = 0.5 * distance.Offset.squaredNorm() + change -
                       reach * reach * reach * bounds.Fall(reach) / 6.0;
  return std::sqrt(std::max(0.0, 2.0 * least));
}
} // namespace palpate
