#include "ClosestPointDescent.h"

#include "SquaredDistance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr double Infinite = std::numeric_limits<double>::infinity();

// The end of a step from a unit vector along a tangent. Short steps, and that is every step of a
// servo tick, need neither root nor division.
Vector3 Moved(const Vector3& direction, const Vector3& step) noexcept
{
  const Vector3 end = direction + step;
  const double excess = end.squaredNorm() - 1.0;
  // The next term of the series is below rounding.
  const double scale = std::abs(excess) < 1e-5 ? 1.0 - excess * (0.5 - 0.375 * excess)
                                               : 1.0 / std::sqrt(1.0 + excess);
  return scale * end;
}

struct LocalBounds
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

struct Remainder
{
  double Eigenvalue; // lower bound of the Hessian's at the end of the step, mm^2/rad^2
  double Gradient;   // upper bound of what is left of it there, mm^2/rad
  double Angle;      // the minimum is within this of the end, rad; infinite if not known
};

LocalBounds BoundsAt(const SphericalHarmonicModel::SecondOrderSample& sample,
                     const SquaredDistance& distance, double third, double rounding) noexcept
{
  const double slope = sample.SurfaceGradient.squaredNorm();
  const double bend = sample.SurfaceHessian.norm() + std::abs(sample.Radius);
  const double first = std::sqrt(sample.Radius * sample.Radius + slope);
  return {first, std::sqrt(bend * bend + 4.0 * slope), third, distance.Offset.norm(),
          first * rounding};
}

// What is known after a last step of Newton's over the angle `step`.
Remainder After(double step, const SquaredDistance& distance, const LocalBounds& bounds) noexcept
{
  const double gradient = distance.Gradient.norm();
  // The third covariant derivative is symmetric up to the curvature of the sphere times the
  // gradient; a symmetric form is largest with three equal arguments.
  const double third = bounds.ThirdOfF(2.0 * step) + 2.0 * gradient;
  const double eigenvalue = distance.SmallestEigenvalue() - step * third;
  const double left = bounds.Noise + (step > 0.0 ? 0.5 * step * step * third : gradient);
  const double angle = 4.0 * left / eigenvalue;
  // Almost always the angle is much less than the step, and the bound at hand will do.
  const double thirdThere = angle <= step ? third : bounds.ThirdOfF(step + angle);
  const bool isKnown = eigenvalue > 0.0 && angle * thirdThere <= 1.5 * eigenvalue;
  return {eigenvalue, left, isKnown ? angle : Infinite};
}

// Fills in the point at the end of a last, short step.
void Finish(const Vector3& query, const Vector3& centerWorld, const Vector3& step, double rounding,
            const LocalBounds& bounds, const Remainder& remainder, ClosestPoint& point) noexcept
{
  const auto& sample = point.Sample;
  const Vector3& u = point.SampleDirection;
  const Vector3& g = sample.SurfaceGradient;
  const Vector3 bent = sample.SurfaceHessian * step;
  const double slope = g.dot(step);
  const double radius = sample.Radius + slope + 0.5 * step.dot(bent);
  point.Direction = Moved(u, step);
  const Vector3 surface = radius * point.Direction;
  const Vector3 normal = surface - (g + bent - slope * u);
  const double size = normal.norm();
  point.Normal = size > 0.0 ? Vector3((1.0 / size) * normal) : point.Direction;
  point.PointWorld = centerWorld + surface;
  const Vector3 offset = query - surface;
  const double length = offset.norm();
  point.SignedDistance = std::copysign(length, offset.dot(normal));

  point.PositionError = Infinite;
  point.DistanceError = Infinite;
  if (remainder.Angle < Infinite)
  {
    const double angle = step.norm();
    const double expansion = bounds.Third * angle * angle * angle / 6.0 + rounding;
    const double reach = angle + remainder.Angle;
    const double first = bounds.First + reach * (bounds.Second + reach * bounds.Third);
    point.PositionError = remainder.Angle * first + expansion;
    // d - sqrt(d^2 - drop) is at most drop / d.
    const double drop = 2.0 * remainder.Gradient * remainder.Gradient / remainder.Eigenvalue;
    point.DistanceError = (drop < length * length ? drop / length : length) + expansion;
  }
}

// One step down of at most `longest` rad, Newton's if it can be; false if none was found.
bool Advance(const SphericalHarmonicModel& model, double longest, const Vector3& query,
             const Vector3& newton, double rounding, int evaluationLimit, ClosestPoint& point,
             SquaredDistance& distance) noexcept
{
  // Far below any eigenvalue that matters; keeps the step finite.
  const double radius = point.Sample.Radius;
  const double least = 1e-9 * (std::abs(distance.Trace) + radius * radius) + rounding * rounding;
  Vector3 step = newton;
  // For a positive definite Hessian the quotient is less than the smallest eigenvalue.
  if (!(distance.IsConvex() && distance.Determinant >= least * distance.Trace))
  {
    const double smallest = distance.SmallestEigenvalue();
    step = distance.Step(std::max(-smallest, least) - smallest);
  }
  const double square = step.squaredNorm();
  if (square > longest * longest)
  {
    step *= longest / std::sqrt(square);
  }
  const Vector3 from = radius * point.SampleDirection;
  while (point.Evaluations < evaluationLimit)
  {
    const Vector3 direction = Moved(point.SampleDirection, step);
    const auto sample = model.EvaluateSecondOrder(direction);
    ++point.Evaluations;
    const SquaredDistance there(direction, sample, query);
    const double change =
        0.5 * (from - sample.Radius * direction).dot(there.Offset + distance.Offset);
    const double enough = 1e-4 * distance.Gradient.dot(step);
    // The last term is what rounding leaves of the change.
    if (change <= enough || change <= enough + distance.Offset.norm() * rounding)
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
} // namespace

ClosestPointDescent::ClosestPointDescent(const SphericalHarmonicModel& model)
    : Model(&model), Derivatives(model), Size(Derivatives.Radius[0] + model.CenterWorld().norm()),
      UnitRounding(4.0 * (model.Degree() + 4.0) * std::numeric_limits<double>::epsilon()),
      LongestStep(2.0 / (model.Degree() + 1.0))
{
}

ClosestPoint ClosestPointDescent::Run(const Vector3& query, const Vector3& direction,
                                      const SphericalHarmonicModel::SecondOrderSample& sample,
                                      double tolerance, int evaluationLimit) const noexcept
{
  const double rounding = this->Rounding(query);
  ClosestPoint point;
  point.SampleDirection = direction;
  point.Sample = sample;
  SquaredDistance distance(direction, sample, query);
  for (;;)
  {
    const double radius = point.Sample.Radius;
    const double metric = radius * radius + point.Sample.SurfaceGradient.squaredNorm();
    const bool isStationary = distance.Gradient.squaredNorm() <= metric * rounding * rounding;
    const Vector3 newton = distance.Step(0.0);
    // The angle left is at least the left side over the smallest eigenvalue, and that is at most
    // half the trace.
    const double square = newton.squaredNorm();
    const bool isShort = 6.0 * square * radius * radius <= 0.5 * tolerance * distance.Trace;
    if (distance.IsConvex() && (isShort || isStationary))
    {
      const LocalBounds bounds =
          BoundsAt(point.Sample, distance, this->Derivatives.PointThird, rounding);
      const Remainder remainder = After(std::sqrt(square), distance, bounds);
      if (remainder.Angle <= tolerance || (isStationary && remainder.Angle < Infinite))
      {
        Finish(query, this->Model->CenterWorld(), newton, rounding, bounds, remainder, point);
        point.State = ClosestPoint::Outcome::Minimum;
        break;
      }
    }
    if (isStationary || !Advance(*this->Model, this->LongestStep, query, newton, rounding,
                                 evaluationLimit, point, distance))
    {
      const LocalBounds bounds =
          BoundsAt(point.Sample, distance, this->Derivatives.PointThird, rounding);
      const Remainder remainder = After(0.0, distance, bounds);
      Finish(query, this->Model->CenterWorld(), Vector3::Zero(), rounding, bounds, remainder,
             point);
      point.State = isStationary ? ClosestPoint::Outcome::Stationary : ClosestPoint::Outcome::Limit;
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
  if (!distance.IsConvex())
  {
    return {};
  }
  const double smallest = distance.SmallestEigenvalue();
  const LocalBounds bounds =
      BoundsAt(point.Sample, distance, this->Derivatives.PointThird, this->Rounding(query));
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
  const LocalBounds bounds =
      BoundsAt(sample, distance, this->Derivatives.PointThird, this->Rounding(query));
  const double smallest = distance.SmallestEigenvalue();
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
