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

// Moves a unit vector along a tangent. Short steps, such as every step of a servo tick, need
// neither square root nor division.
Vector3 Moved(const Vector3& direction, const Vector3& step) noexcept
{
  const Vector3 end = direction + step;
  const double excess = end.squaredNorm() - 1.0;
  // The next term of the series is below rounding.
  const double scale = std::abs(excess) < 1e-5 ? 1.0 - excess * (0.5 - 0.375 * excess)
                                               : 1.0 / std::sqrt(1.0 + excess);
  return scale * end;
}

// Local bounds on f and on the surface at a sample.
struct LocalBounds
{
  double First;      // |x'|, mm/rad
  double Second;     // |x''|, mm/rad^2
  double Third;      // |x'''| everywhere, mm/rad^3
  double Distance;   // |x - q|, mm
  double Gradient;   // of f, mm^2/rad
  double Eigenvalue; // the smallest of the Hessian of f, mm^2/rad^2
  double Noise;      // rounding of the gradient of f, mm^2/rad

  // |f'''| on arcs through the sample up to this angle.
  double ThirdOfF(double angle) const noexcept
  {
    const double second = this->Second + angle * this->Third;
    const double first = this->First + angle * second;
    return 3.0 * first * second + (this->Distance + angle * first) * this->Third;
  }
  // f is above its quadratic expansion minus angle^3 / 6 times this. With e the quadratic expansion
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
  double Angle; // the minimum is within this of the end, rad; infinite if unknown
  double Drop;  // |x - q|^2 is at most this much above its minimum there, mm^2
};

LocalBounds BoundsAt(const SphericalHarmonicModel::SecondOrderSample& sample,
                     const SquaredDistance& distance, double third, double rounding) noexcept
{
  // Square roots are slow, and two take no longer than one.
  using Pair = Eigen::Array2d;
  const double slope = sample.SurfaceGradient.squaredNorm();
  const Pair sizes =
      Pair(sample.SurfaceHessian.squaredNorm(), sample.Radius * sample.Radius + slope).sqrt();
  const double bend = sizes[0] + std::abs(sample.Radius);
  const Pair roots = Pair(bend * bend + 4.0 * slope, distance.SquaredSpread()).sqrt();
  const Pair lengths = Pair(distance.Offset.squaredNorm(), distance.Gradient.squaredNorm()).sqrt();
  return {sizes[1],           roots[0],   third,
          lengths[0],         lengths[1], distance.SmallestEigenvalue(roots[1]),
          sizes[1] * rounding};
}

// Bounds after a last Newton step over the angle `step`.
Remainder After(double step, const LocalBounds& bounds) noexcept
{
  // The third covariant derivative is symmetric up to the curvature of the sphere times the
  // gradient; a symmetric form is largest with three equal arguments.
  const double third = bounds.ThirdOfF(2.0 * step) + 2.0 * bounds.Gradient;
  const double eigenvalue = bounds.Eigenvalue - step * third;
  const double left = bounds.Noise + (step > 0.0 ? 0.5 * step * step * third : bounds.Gradient);
  const double quotient = left / eigenvalue;
  const double angle = 4.0 * quotient;
  // Almost always the angle is much less than the step, and the existing bound suffices.
  const double thirdThere = angle <= step ? third : bounds.ThirdOfF(step + angle);
  const bool isKnown = eigenvalue > 0.0 && angle * thirdThere <= 1.5 * eigenvalue;
  return {isKnown ? angle : Infinite, 2.0 * left * quotient};
}

// Computes the point at the end of a last, short step.
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
    const double expansion = bounds.Third * angle * angle * angle * (1.0 / 6.0) + rounding;
    const double reach = angle + remainder.Angle;
    const double first = bounds.First + reach * (bounds.Second + reach * bounds.Third);
    point.PositionError = remainder.Angle * first + expansion;
    // d - sqrt(d^2 - drop) is at most drop / d.
    const bool isSmall = remainder.Drop < length * length;
    point.DistanceError = (isSmall ? remainder.Drop / length : length) + expansion;
  }
}

// The remaining angle to the minimum is at least the left side over the smallest eigenvalue, which
// is at most half the trace.
bool IsShort(double squaredStep, double tolerance, const SquaredDistance& distance,
             double radius) noexcept
{
  return 6.0 * squaredStep * radius * radius <= 0.5 * tolerance * distance.Trace;
}

// Far below any relevant eigenvalue; keeps steps finite.
double LeastEigenvalue(const SquaredDistance& distance, double radius, double rounding) noexcept
{
  return 1e-9 * (std::abs(distance.Trace) + radius * radius) + rounding * rounding;
}

// For a positive definite Hessian the quotient is less than the smallest eigenvalue.
bool IsWellConditioned(const SquaredDistance& distance, double least) noexcept
{
  return distance.IsConvex() && distance.Determinant >= least * distance.Trace;
}

// Moves to the end of a step if the distance decreases enough; `point` is then there. Otherwise its
// contents are undefined.
bool TryStep(const SphericalHarmonicModel& model, const Vector3& query, const Vector3& from,
             const SquaredDistance& here, const Vector3& step, double rounding,
             ClosestPoint& point) noexcept
{
  point.SampleDirection = Moved(from, step);
  point.Sample = model.EvaluateSecondOrder(point.SampleDirection);
  ++point.Evaluations;
  point.Expansion = SquaredDistance(point.SampleDirection, point.Sample, query);
  const Vector3& offset = point.Expansion.Offset;
  const double change = 0.5 * (offset - here.Offset).dot(offset + here.Offset);
  const double enough = 1e-4 * here.Gradient.dot(step);
  // The last term allows for rounding of the change.
  return change <= enough || change <= enough + here.Offset.norm() * rounding;
}

// One descent step of at most `longest` rad, Newton's if possible; false if none was found.
bool Advance(const SphericalHarmonicModel& model, double longest, const Vector3& query,
             const Vector3& newton, double rounding, int evaluationLimit,
             ClosestPoint& point) noexcept
{
  const double least = LeastEigenvalue(point.Expansion, point.Sample.Radius, rounding);
  Vector3 step = newton;
  if (!IsWellConditioned(point.Expansion, least))
  {
    const double smallest = point.Expansion.SmallestEigenvalue();
    step = point.Expansion.ShiftedStep(std::max(-smallest, least) - smallest);
  }
  const double square = step.squaredNorm();
  if (square > longest * longest)
  {
    step *= longest / std::sqrt(square);
  }
  const ClosestPoint start = point;
  while (point.Evaluations < evaluationLimit)
  {
    if (TryStep(model, query, start.SampleDirection, start.Expansion, step, rounding, point))
    {
      return true;
    }
    step *= 0.25;
  }
  const int evaluations = point.Evaluations;
  point = start;
  point.Evaluations = evaluations;
  return false;
}

// Takes a last step if the minimum is then known to be within `angle`.
bool EndWithin(double angle, const Vector3& query, const Vector3& centerWorld, const Vector3& step,
               double third, double rounding, ClosestPoint& point) noexcept
{
  const LocalBounds bounds = BoundsAt(point.Sample, point.Expansion, third, rounding);
  const Remainder remainder = After(step.norm(), bounds);
  if (!(remainder.Angle <= angle))
  {
    return false;
  }
  Finish(query, centerWorld, step, rounding, bounds, remainder, point);
  point.State = ClosestPoint::Outcome::Minimum;
  return true;
}

// Stops at the current point, or where the gradient cannot be distinguished from rounding.
void Stop(const Vector3& query, const Vector3& centerWorld, double third, double rounding,
          bool isStationary, ClosestPoint& point) noexcept
{
  const LocalBounds bounds = BoundsAt(point.Sample, point.Expansion, third, rounding);
  const Remainder remainder = After(0.0, bounds);
  Finish(query, centerWorld, Vector3::Zero(), rounding, bounds, remainder, point);
  point.State = isStationary ? ClosestPoint::Outcome::Stationary : ClosestPoint::Outcome::Limit;
}

bool IsStationary(const ClosestPoint& point, double rounding) noexcept
{
  const double radius = point.Sample.Radius;
  const double metric = radius * radius + point.Sample.SurfaceGradient.squaredNorm();
  return point.Expansion.Gradient.squaredNorm() <= metric * rounding * rounding;
}
} // namespace

ClosestPointDescent::ClosestPointDescent(const SphericalHarmonicModel& model, InstructionSet set)
    : Model(&model), Derivatives(model), Size(Derivatives.Radius[0] + model.CenterWorld().norm()),
      UnitRounding(4.0 * (model.Degree() + 4.0) * std::numeric_limits<double>::epsilon()),
      LongestStep(2.0 / (model.Degree() + 1.0)), Set(set)
{
}

ClosestPoint ClosestPointDescent::Run(const Vector3& query, const Vector3& direction,
                                      const SphericalHarmonicModel::SecondOrderSample& sample,
                                      double tolerance, int evaluationLimit) const noexcept
{
  ClosestPoint point;
  point.SampleDirection = direction;
  point.Sample = sample;
  point.Expansion = SquaredDistance(direction, sample, query);
  this->Descend(query, tolerance, evaluationLimit, this->Rounding(query), point);
  return point;
}

ClosestPoint ClosestPointDescent::Continue(const Vector3& query, const ClosestPoint& previous,
                                           double tolerance, int evaluationLimit) const noexcept
{
  return this->Set == InstructionSet::Avx2
             ? this->ContinueByAvx2(query, previous, tolerance, evaluationLimit)
             : this->ContinuePortably(query, previous, tolerance, evaluationLimit);
}

// A servo tick in one function, so that intermediate results stay in registers: compiled portably
// and for AVX2. No function that another file might share is compiled for AVX2, since everything is
// inlined here.
[[gnu::flatten]] ClosestPoint
ClosestPointDescent::ContinuePortably(const Vector3& query, const ClosestPoint& previous,
                                      double tolerance, int evaluationLimit) const noexcept
{
  return this->Follow(query, previous, tolerance, evaluationLimit);
}

#if defined(__x86_64__)
[[gnu::target("avx2,fma")]]
#endif
[[gnu::flatten]] ClosestPoint
ClosestPointDescent::ContinueByAvx2(const Vector3& query, const ClosestPoint& previous,
                                    double tolerance, int evaluationLimit) const noexcept
{
  return this->Follow(query, previous, tolerance, evaluationLimit);
}

ClosestPoint ClosestPointDescent::Follow(const Vector3& query, const ClosestPoint& previous,
                                         double tolerance, int evaluationLimit) const noexcept
{
  const double rounding = this->Rounding(query);
  ClosestPoint point;
  if (!this->Foresee(query, previous, tolerance, rounding, point))
  {
    point.SampleDirection = previous.SampleDirection;
    point.Sample = previous.Sample;
    point.Expansion = SquaredDistance(point.SampleDirection, point.Sample, query);
  }
  this->Descend(query, tolerance, evaluationLimit, rounding, point);
  return point;
}

// The curvature of the last tick predicts this tick's step nearly as well as its own, at a fraction
// of the cost; the last step corrects the error. Returns false if the step was not taken.
bool ClosestPointDescent::Foresee(const Vector3& query, const ClosestPoint& previous,
                                  double tolerance, double rounding,
                                  ClosestPoint& point) const noexcept
{
  SquaredDistance distance = previous.Expansion;
  distance.MoveQuery(previous.SampleDirection, previous.Sample, query);
  const double radius = previous.Sample.Radius;
  if (!IsWellConditioned(distance, LeastEigenvalue(distance, radius, rounding)))
  {
    return false;
  }
  const Vector3 step = distance.NewtonStep();
  const double square = step.squaredNorm();
  // A last step needs the true curvature.
  return square <= this->LongestStep * this->LongestStep &&
         !IsShort(square, tolerance, distance, radius) &&
         TryStep(*this->Model, query, previous.SampleDirection, distance, step, rounding, point);
}

void ClosestPointDescent::Descend(const Vector3& query, double tolerance, int evaluationLimit,
                                  double rounding, ClosestPoint& point) const noexcept
{
  const double third = this->Derivatives.PointThird;
  const Vector3& center = this->Model->CenterWorld();
  for (;;)
  {
    const Vector3 newton = point.Expansion.NewtonStep();
    const bool isConvex = point.Expansion.IsConvex();
    if (isConvex &&
        IsShort(newton.squaredNorm(), tolerance, point.Expansion, point.Sample.Radius) &&
        EndWithin(tolerance, query, center, newton, third, rounding, point))
    {
      break;
    }
    const bool isStationary = IsStationary(point, rounding);
    if (isConvex && isStationary &&
        EndWithin(std::numeric_limits<double>::max(), query, center, newton, third, rounding,
                  point))
    {
      break;
    }
    if (isStationary ||
        !Advance(*this->Model, this->LongestStep, query, newton, rounding, evaluationLimit, point))
    {
      Stop(query, center, third, rounding, isStationary, point);
      break;
    }
  }
  if (!std::isfinite(point.SignedDistance))
  {
    point.State = ClosestPoint::Outcome::BadInput;
  }
}

ClosestPointDescent::Basin
ClosestPointDescent::BasinAround(const Vector3& query, const ClosestPoint& point) const noexcept
{
  const SquaredDistance& distance = point.Expansion;
  if (!distance.IsConvex())
  {
    return {};
  }
  const LocalBounds bounds =
      BoundsAt(point.Sample, distance, this->Derivatives.PointThird, this->Rounding(query));
  const double smallest = bounds.Eigenvalue;
  const Vector3 step = distance.NewtonStep();
  const double away = step.norm();
  // At the distance a from the expansion's minimum, itself s from the sample, f is above that by
  // smallest a^2 / 2 - Fall (a + s)^3 / 6: positive from a = 10 s on to where a * Fall is 2.25
  // times the eigenvalue, and to 2.7 times where that is beyond 30 s; and no less than this before.
  const auto angleWithin = [&](double part)
  {
    // Where angle * Fall(angle) is that fraction of the eigenvalue; the last step ensures at most
    // that.
    double angle = part * smallest / bounds.Fall(0.0);
    for (int i = 0; i < 4; ++i)
    {
      angle = std::sqrt(angle * part * smallest / bounds.Fall(angle));
    }
    return std::min(angle, part * smallest / bounds.Fall(angle));
  };
  double angle = angleWithin(2.6);
  if (angle < 30.0 * away)
  {
    angle = angleWithin(1.5);
  }
  const double length = 11.0 * away;
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
  const double change = distance.LeastChange(reach, bounds.Eigenvalue, bounds.Gradient);
  const double least = 0.5 * distance.Offset.squaredNorm() + change -
                       reach * reach * reach * bounds.Fall(reach) / 6.0;
  return std::sqrt(std::max(0.0, 2.0 * least));
}
} // namespace palpate
