#include "ClosestPointDescent.h"

#include "SampleGeometry.h"
#include "SquaredDistance.h"
#include "TangentQuadratic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace palpate
{
namespace
{
constexpr double Unbounded = std::numeric_limits<double>::infinity();

// Of a descent, that rounding may take without getting nearer. Newton's last ones are two or three;
// along a rim that is equally far all around there is no end of them.
constexpr int MostIdleSteps = 16;

// Local bounds on f and on the surface at a sample.
template <typename Surface>
struct LocalBounds
{
  double First;      // |x'|, mm/rad
  double Second;     // |x''|, mm/rad^2
  double Product;    // 3 |x'.x''|, mm^2/rad^3
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
    double product = 3.0 * first * second;
    if constexpr (std::is_same_v<Surface, CenteredSurface>)
    {
      const double change = second * second + first * this->Third;
      product = std::min(product, this->Product + 3.0 * angle * change);
    }
    return product + (this->Distance + angle * first) * this->Third;
  }
  // f is above its quadratic expansion minus angle^3 / 6 times this. With e the quadratic expansion
  // of x - q, f = |e|^2 / 2 + e.r + |r|^2 / 2 with |r| <= angle^3 |x'''| / 6, and the first term
  // has only x'.x'' at third order and a square at fourth.
  double Fall(double angle) const noexcept
  {
    return this->Product +
           (this->Distance + angle * (this->First + 0.5 * angle * this->Second)) * this->Third;
  }
};

struct Remainder
{
  double Angle; // the minimum is within this of the end, rad; infinite if unknown
  double Drop;  // |x - q|^2 is at most this much above its minimum there, mm^2
};

template <typename Surface>
LocalBounds<Surface> BoundsAt(const SampleOf<Surface>& sample, const SquaredDistance& distance,
                              double third, double rounding) noexcept
{
  const SampleSizes sizes = SizesOf(sample, distance);
  return {sizes.First,
          sizes.Second,
          sizes.Product,
          third,
          sizes.Distance,
          sizes.Gradient,
          distance.SmallestEigenvalue(sizes.Spread),
          sizes.First * rounding};
}

// A tracked point of a surface model stays on its side of the surface.
template <typename Surface>
void KeepSide(const ClosestPointOf<Surface>& previous, ClosestPointOf<Surface>& point) noexcept
{
  if constexpr (std::is_same_v<Surface, CenteredSurface>)
  {
    if (previous.Normal.dot(AreaVector(previous.Sample)) < 0.0)
    {
      point.Normal = -point.Normal;
      point.SignedDistance = -point.SignedDistance;
    }
  }
}

// Bounds after a last Newton step over the angle `step`.
template <typename Surface>
Remainder After(double step, const LocalBounds<Surface>& bounds) noexcept
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
  return {isKnown ? angle : Unbounded, 2.0 * left * quotient};
}

// Computes the point at the end of a last, short step.
template <typename Surface>
void Finish(const Vector3& query, const Vector3& centerWorld, const Vector3& step, double rounding,
            const LocalBounds<Surface>& bounds, const Remainder& remainder,
            ClosestPointOf<Surface>& point) noexcept
{
  const auto [direction, surface, normal] = Expanded(point.SampleDirection, point.Sample, step);
  point.Direction = direction;
  const double size = normal.norm();
  point.Normal = size > 0.0 ? Vector3((1.0 / size) * normal) : point.Direction;
  point.PointWorld = centerWorld + surface;
  const Vector3 offset = query - surface;
  const double length = offset.norm();
  point.SignedDistance = std::copysign(length, offset.dot(normal));

  point.PositionError = Unbounded;
  point.DistanceError = Unbounded;
  if (remainder.Angle < Unbounded)
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
template <typename Surface>
bool TryStep(const Surface& model, const Vector3& query, const Vector3& from,
             const SquaredDistance& here, const Vector3& step, double rounding,
             ClosestPointOf<Surface>& point) noexcept
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
template <typename Surface>
bool Advance(const Surface& model, double longest, const Vector3& query, const Vector3& newton,
             double rounding, int evaluationLimit, ClosestPointOf<Surface>& point) noexcept
{
  const double least = LeastEigenvalue(point.Expansion, ScaleOf(point.Sample), rounding);
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
  const ClosestPointOf<Surface> start = point;
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
template <typename Surface>
bool EndWithin(double angle, const Vector3& query, const Vector3& centerWorld, const Vector3& step,
               double third, double rounding, ClosestPointOf<Surface>& point) noexcept
{
  const LocalBounds<Surface> bounds =
      BoundsAt<Surface>(point.Sample, point.Expansion, third, rounding);
  const Remainder remainder = After(step.norm(), bounds);
  if (!(remainder.Angle <= angle))
  {
    return false;
  }
  Finish(query, centerWorld, step, rounding, bounds, remainder, point);
  point.State = ClosestPointOf<Surface>::Outcome::Minimum;
  return true;
}

// Stops at the current point, or where the gradient cannot be distinguished from rounding.
template <typename Surface>
void Stop(const Vector3& query, const Vector3& centerWorld, double third, double rounding,
          bool isStationary, ClosestPointOf<Surface>& point) noexcept
{
  const LocalBounds<Surface> bounds =
      BoundsAt<Surface>(point.Sample, point.Expansion, third, rounding);
  const Remainder remainder = After(0.0, bounds);
  Finish(query, centerWorld, Vector3::Zero(), rounding, bounds, remainder, point);
  using Outcome = typename ClosestPointOf<Surface>::Outcome;
  point.State = isStationary ? Outcome::Stationary : Outcome::Limit;
}

template <typename Surface>
bool IsStationary(const ClosestPointOf<Surface>& point, double rounding) noexcept
{
  const double metric = SquaredStretch(point.Sample);
  return point.Expansion.Gradient.squaredNorm() <= metric * rounding * rounding;
}

// Of the surface over a cap, from the distance of its centre and the least change of the half
// squared distance's quadratic expansion, all mm.
template <typename Bounds>
double DistanceWithin(double reach, double length, double change, const Bounds& cap) noexcept
{
  const double fall =
      cap.Product + (length + reach * (cap.First + 0.5 * reach * cap.Second)) * cap.Third;
  const double least = 0.5 * length * length + change - reach * reach * reach * fall / 6.0;
  return std::sqrt(std::max(0.0, 2.0 * least));
}
} // namespace

template <typename Surface>
ClosestPointDescentOf<Surface>::ClosestPointDescentOf(const Surface& model, InstructionSet set)
    : Model(&model), Derivatives(model), Size(Derivatives.Largest() + model.CenterWorld().norm()),
      UnitRounding(4.0 * (model.Degree() + 4.0) * std::numeric_limits<double>::epsilon()),
      LongestStep(2.0 / (model.Degree() + 1.0)), Set(set)
{
}

template <typename Surface>
ClosestPointOf<Surface> ClosestPointDescentOf<Surface>::Run(const Vector3& query,
                                                            const Vector3& direction,
                                                            const Sample& sample, double tolerance,
                                                            int evaluationLimit) const noexcept
{
  ClosestPoint point;
  point.SampleDirection = direction;
  point.Sample = sample;
  point.Expansion = SquaredDistance(direction, sample, query);
  this->Descend(query, tolerance, evaluationLimit, this->Rounding(query), point);
  return point;
}

template <typename Surface>
ClosestPointOf<Surface>
ClosestPointDescentOf<Surface>::Continue(const Vector3& query, const ClosestPoint& previous,
                                         double tolerance, int evaluationLimit) const noexcept
{
  return this->Set == InstructionSet::Avx2
             ? this->ContinueByAvx2(query, previous, tolerance, evaluationLimit)
             : this->ContinuePortably(query, previous, tolerance, evaluationLimit);
}

// A servo tick in one function, so that intermediate results stay in registers: compiled portably
// and for AVX2. No function that another file might share is compiled for AVX2, since everything is
// inlined here.
template <typename Surface>
[[gnu::flatten]] ClosestPointOf<Surface>
ClosestPointDescentOf<Surface>::ContinuePortably(const Vector3& query, const ClosestPoint& previous,
                                                 double tolerance,
                                                 int evaluationLimit) const noexcept
{
  return this->Follow(query, previous, tolerance, evaluationLimit);
}

template <typename Surface>
#if defined(__x86_64__)
[[gnu::target("avx2,fma")]]
#endif
[[gnu::flatten]] ClosestPointOf<Surface>
ClosestPointDescentOf<Surface>::ContinueByAvx2(const Vector3& query, const ClosestPoint& previous,
                                               double tolerance, int evaluationLimit) const noexcept
{
  return this->Follow(query, previous, tolerance, evaluationLimit);
}

template <typename Surface>
ClosestPointOf<Surface>
ClosestPointDescentOf<Surface>::Follow(const Vector3& query, const ClosestPoint& previous,
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
  KeepSide(previous, point);
  return point;
}

// The curvature of the last tick predicts this tick's step nearly as well as its own, at a fraction
// of the cost; the last step corrects the error. Returns false if the step was not taken.
template <typename Surface>
bool ClosestPointDescentOf<Surface>::Foresee(const Vector3& query, const ClosestPoint& previous,
                                             double tolerance, double rounding,
                                             ClosestPoint& point) const noexcept
{
  SquaredDistance distance = previous.Expansion;
  distance.MoveQuery(previous.SampleDirection, previous.Sample, query);
  const double radius = ScaleOf(previous.Sample);
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

template <typename Surface>
void ClosestPointDescentOf<Surface>::Descend(const Vector3& query, double tolerance,
                                             int evaluationLimit, double rounding,
                                             ClosestPoint& point) const noexcept
{
  const double third = this->Derivatives.PointThird;
  const Vector3& center = this->Model->CenterWorld();
  double nearest = point.Expansion.Offset.squaredNorm();
  int idle = 0; // steps since it got nearer by more than rounding
  for (;;)
  {
    const Vector3 newton = point.Expansion.NewtonStep();
    const bool isConvex = point.Expansion.IsConvex();
    if (isConvex &&
        IsShort(newton.squaredNorm(), tolerance, point.Expansion, ScaleOf(point.Sample)) &&
        EndWithin(tolerance, query, center, newton, third, rounding, point))
    {
      break;
    }
    const bool isStationary = idle > MostIdleSteps || IsStationary(point, rounding);
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
    const double square = point.Expansion.Offset.squaredNorm();
    const bool isNearer = nearest - square > 2.0 * rounding * std::sqrt(nearest);
    idle = isNearer ? 0 : idle + 1;
    nearest = std::min(nearest, square);
  }
  if (!std::isfinite(point.SignedDistance))
  {
    point.State = ClosestPoint::Outcome::BadInput;
  }
}

template <>
RoundBasin ClosestPointDescent::BasinAround(const Vector3& query,
                                            const ClosestPoint& point) const noexcept
{
  const SquaredDistance& distance = point.Expansion;
  if (!distance.IsConvex())
  {
    return {};
  }
  const LocalBounds<RadialModel> bounds = BoundsAt<RadialModel>(
      point.Sample, distance, this->Derivatives.PointThird, this->Rounding(query));
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

template <>
StretchedBasin
ClosestPointDescentOf<CenteredSurface>::BasinAround(const Vector3& query,
                                                    const ClosestPoint& point) const noexcept
{
  return StretchedBasinAround(point.SampleDirection, point.Sample, point.Expansion.Offset,
                              this->Derivatives, this->Rounding(query));
}

template <typename Surface>
typename ClosestPointDescentOf<Surface>::CapBounds
ClosestPointDescentOf<Surface>::BoundsWithin(const DerivativeBounds& bounds,
                                             const Vector3& direction, const Sample& sample,
                                             double reach) noexcept
{
  const CurveSizes sizes = CurveSizesOf(sample);
  return {sizes.First, sizes.Second, sizes.Product, bounds.ThirdWithin(direction, reach)};
}

template <>
double ClosestPointDescent::LowerDistance(const Vector3& query, const Vector3& direction,
                                          const Sample& sample, double reach,
                                          const CapBounds& cap) const noexcept
{
  const SquaredDistance distance(direction, sample, query);
  const double length = distance.Offset.norm();
  const double change =
      distance.LeastChange(reach, distance.SmallestEigenvalue(), distance.Gradient.norm());
  return DistanceWithin(reach, length, change, cap);
}

// Along the sample's own tangents, which takes half as long.
template <>
double ClosestPointDescentOf<CenteredSurface>::LowerDistance(const Vector3& query, const Vector3&,
                                                             const Sample& sample, double reach,
                                                             const CapBounds& cap) const noexcept
{
  const Vector3 offset = query - sample.Point;
  const auto& [first, second] = sample.First;
  const double aa = first.squaredNorm() - offset.dot(sample.Second[0]);
  const double ab = first.dot(second) - offset.dot(sample.Second[1]);
  const double bb = second.squaredNorm() - offset.dot(sample.Second[2]);
  const TangentQuadratic quadratic{aa, ab, bb, -offset.dot(first), -offset.dot(second)};
  return DistanceWithin(reach, offset.norm(), quadratic.LeastChange(reach), cap);
}

template class ClosestPointDescentOf<RadialModel>;
template class ClosestPointDescentOf<CenteredSurface>;
} // namespace palpate
