#include "ShapeCompletion.h"

#include "DecimalText.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace palpate
{
namespace
{
constexpr int MostSteps = 40;
constexpr int MostHalvings = 12;
constexpr double LargestCenterStep = 6.0; // mm
constexpr double LargestSizeStep = 0.28;  // of the logarithm of the mean radius
constexpr double LeastStep = 5e-3;        // mm: the last step, whose error is a tenth of it or less
constexpr double LeastCloser = 2e-3;      // mm: the same by a former factor
constexpr double LeastProgress = 0.5;     // of a step by a former factor, as a share of the last

// The middle of the box of the points on a surface, and the mean logarithm of their distances.
struct TouchExtent
{
  explicit TouchExtent(const std::vector<SurfaceTouch>& touches)
  {
    for (const SurfaceTouch& touch : touches)
    {
      this->Count += touch.IsOutside ? 0 : 1;
    }
    this->Middle = MiddleOf(touches).value_or(this->Middle);
    this->TakeDistances(touches, this->Middle);
  }

  void TakeDistances(const std::vector<SurfaceTouch>& touches, const Vector3& center)
  {
    this->LogDistance = 0.0;
    for (const SurfaceTouch& touch : touches)
    {
      const double distance = std::max((touch.PointWorld - center).norm(), 1.0);
      this->LogDistance += touch.IsOutside ? 0.0 : std::log(distance) / this->Count;
    }
  }

  int Count = 0;
  Vector3 Middle = Vector3::Zero();
  double LogDistance = 0.0; // ln(mm)
};
} // namespace

ShapeCompletion::ShapeCompletion(std::shared_ptr<const ShapePrior> prior, const Vector3& clickWorld)
    : Given(std::move(prior)), Click(clickWorld), Equations(this->Given->Degree()),
      Last(this->PriorState()), Target(this->Last), Trial(this->Last)
{
  this->CostOf(this->Last);
  this->Factorise();
}

ShapeCompletion::State ShapeCompletion::PriorState() const
{
  State state;
  state.Surface = {this->Given->Mean(), this->Click};
  state.Pull = Eigen::VectorXd::Zero(this->Given->Size());
  return state;
}

// The prior's shape in the middle of the touches and of their size, as far as the prior has it.
ShapeCompletion::State ShapeCompletion::SphereState(const std::vector<SurfaceTouch>& touches) const
{
  State state = this->PriorState();
  const TouchExtent extent(touches);
  const double excess = extent.LogDistance / ShapePrior::ConstantHarmonic - this->Given->Mean()[0];
  state.Pull[0] = excess / this->Given->Covariance()(0, 0);
  state.Surface.Coefficients += state.Pull[0] * this->Given->Covariance().col(0);
  state.Surface.CenterWorld = extent.Middle;
  state.CenterPull = (extent.Middle - this->Click) / (CenterDeviation * CenterDeviation);
  return state;
}

double ShapeCompletion::CostOf(const State& state)
{
  this->Equations.Evaluate(state.Surface);
  return state.Pull.dot(state.Surface.Coefficients - this->Given->Mean()) +
         state.CenterPull.dot(state.Surface.CenterWorld - this->Click) + this->Equations.Misfit();
}

// The factor of the covariance of the rows, at the surface of the last CostOf.
void ShapeCompletion::Factorise()
{
  this->Slopes = this->Equations.ByCoefficients();
  this->CenterSlopes = this->Equations.ByCenter();
  const Eigen::MatrixXd& slopes = this->Slopes;
  this->PriorBySlopes.resize(slopes.rows(), slopes.cols());
  this->PriorBySlopes.noalias() = this->Given->Covariance() * slopes;
  this->CenterBySlopes = CenterDeviation * CenterDeviation * this->Equations.ByCenter();
  this->System.resize(slopes.cols(), slopes.cols());
  this->System.noalias() = slopes.transpose() * this->PriorBySlopes;
  this->System.noalias() += this->Equations.ByCenter().transpose() * this->CenterBySlopes;
  this->Equations.AddCovariance(this->System);
  if (slopes.cols() > 0)
  {
    // In place; it is positive definite, since every row has a variance of its own.
    const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(this->System);
  }
}

// The optimum of the linearised equations.
void ShapeCompletion::FindTarget(const State& state)
{
  this->Factorise();
  const Eigen::MatrixXd& slopes = this->Equations.ByCoefficients();
  this->Weights.resize(slopes.cols());
  this->Weights.noalias() = slopes.transpose() * (state.Surface.Coefficients - this->Given->Mean());
  this->Weights.noalias() +=
      this->Equations.ByCenter().transpose() * (state.Surface.CenterWorld - this->Click);
  this->Weights -= this->Equations.Residuals();
  this->System.triangularView<Eigen::Lower>().solveInPlace(this->Weights);
  this->System.transpose().triangularView<Eigen::Upper>().solveInPlace(this->Weights);
  this->Target.Pull.noalias() = slopes * this->Weights;
  this->Target.CenterPull.noalias() = this->Equations.ByCenter() * this->Weights;
  this->Target.Surface.Coefficients = this->Given->Mean();
  this->Target.Surface.Coefficients.noalias() += this->PriorBySlopes * this->Weights;
  this->Target.Surface.CenterWorld = this->Click;
  this->Target.Surface.CenterWorld.noalias() += this->CenterBySlopes * this->Weights;
}

// A step closer to the optimum by the gradient there, but with the last factor (chord method): a
// tenth of the work of a new one.
void ShapeCompletion::FindCloser(const State& state)
{
  this->Gradient = state.Pull;
  this->Gradient.noalias() += this->Equations.ByCoefficients() * this->Equations.Weights();
  const Vector3 gradient =
      state.CenterPull + this->Equations.ByCenter() * this->Equations.Weights();
  this->Weights.resize(this->Slopes.cols());
  this->Weights.noalias() = this->PriorBySlopes.transpose() * this->Gradient;
  this->Weights.noalias() += this->CenterBySlopes.transpose() * gradient;
  this->System.triangularView<Eigen::Lower>().solveInPlace(this->Weights);
  this->System.transpose().triangularView<Eigen::Upper>().solveInPlace(this->Weights);
  this->Target.Pull = state.Pull - this->Gradient;
  this->Target.Pull.noalias() += this->Slopes * this->Weights;
  this->Target.CenterPull = state.CenterPull - gradient + this->CenterSlopes * this->Weights;
  this->Target.Surface.Coefficients = state.Surface.Coefficients;
  this->Target.Surface.Coefficients.noalias() -= this->Given->Covariance() * this->Gradient;
  this->Target.Surface.Coefficients.noalias() += this->PriorBySlopes * this->Weights;
  this->Target.Surface.CenterWorld = state.Surface.CenterWorld -
                                     CenterDeviation * CenterDeviation * gradient +
                                     this->CenterBySlopes * this->Weights;
}

// mm: RMS of the change of radius, and that of the centre.
double ShapeCompletion::ChangeBetween(const State& one, const State& other) const
{
  const double radius = std::exp(ShapePrior::ConstantHarmonic * one.Surface.Coefficients[0]);
  return radius * ShapePrior::ConstantHarmonic *
             (one.Surface.Coefficients - other.Surface.Coefficients).norm() +
         (one.Surface.CenterWorld - other.Surface.CenterWorld).norm();
}

// Towards the linearised optimum; false at the end.
bool ShapeCompletion::Step(State& state)
{
  this->FindTarget(state);
  if (this->ChangeBetween(this->Target, state) < LeastStep)
  {
    this->Target.Cost = state.Cost;
    std::swap(this->Target, state);
    return false;
  }
  return this->Approach(state);
}

// Steps by the last factor, as long as they become shorter fast.
void ShapeCompletion::Close(State& state)
{
  double last = std::numeric_limits<double>::infinity();
  bool goesOn = true;
  while (goesOn)
  {
    this->FindCloser(state);
    const double change = this->ChangeBetween(this->Target, state);
    goesOn = change > LeastCloser && change < LeastProgress * last && this->Approach(state);
    last = change;
  }
}

// As far towards the target as the cost falls; false if it does not.
bool ShapeCompletion::Approach(State& state)
{
  const double shift = (this->Target.Surface.CenterWorld - state.Surface.CenterWorld).norm();
  const double growth =
      ShapePrior::ConstantHarmonic *
      std::abs(this->Target.Surface.Coefficients[0] - state.Surface.Coefficients[0]);
  double share = std::min(
      {1.0, LargestCenterStep / std::max(shift, 1e-12), LargestSizeStep / std::max(growth, 1e-12)});
  for (int halving = 0; halving < MostHalvings; ++halving, share *= 0.5)
  {
    const auto between = [share](const auto& from, const auto& to)
    { return from + share * (to - from); };
    this->Trial.Surface.Coefficients =
        between(state.Surface.Coefficients, this->Target.Surface.Coefficients);
    this->Trial.Surface.CenterWorld =
        between(state.Surface.CenterWorld, this->Target.Surface.CenterWorld);
    this->Trial.Pull = between(state.Pull, this->Target.Pull);
    this->Trial.CenterPull = between(state.CenterPull, this->Target.CenterPull);
    this->Trial.Cost = this->CostOf(this->Trial);
    if (this->Trial.Cost < state.Cost)
    {
      std::swap(this->Trial, state);
      return true;
    }
  }
  state.Cost = this->CostOf(state);
  return false;
}

void ShapeCompletion::Descend(State& state)
{
  state.Cost = this->CostOf(state);
  int steps = 0;
  while (steps < MostSteps && this->Step(state))
  {
    ++steps;
    this->Close(state);
  }
  this->StepCount += steps;
}

bool ShapeCompletion::FitsBadly() const noexcept
{
  return this->Distance() > std::sqrt(2.0) * std::hypot(this->Equations.ExpectedDistance(),
                                                        TouchEquations::ModelDeviation);
}

Status ShapeCompletion::Update(const std::vector<SurfaceTouch>& touches)
{
  if (Status status = CheckTouches(touches, this->Click); !status.IsOk())
  {
    return status;
  }
  this->Equations.SetTouches(touches);
  this->StepCount = 0;
  // The last step leaves the factor of a surface within LeastStep of the last one.
  this->Descend(this->Last);
  if (this->FitsBadly())
  {
    for (State start : {this->PriorState(), this->SphereState(touches)})
    {
      this->Descend(start);
      if (start.Cost < this->Last.Cost)
      {
        std::swap(start, this->Last);
      }
    }
    this->CostOf(this->Last);
    this->Factorise();
  }
  return Status::Success();
}

Status ShapeCompletion::Judge() const
{
  if (this->Distance() <= this->LargestDistance())
  {
    return Status::Success();
  }
  return Status::Failure("the touched points are " + FixedText(this->Distance(), 2) +
                         " mm (RMS) from any likely radial surface, more than " +
                         FixedText(this->LargestDistance(), 2) +
                         ": the organ is not star-shaped, or points are not on it");
}

RadialModel ShapeCompletion::Model() const
{
  return RadialModelOf(this->Surface().Coefficients, this->Given->Degree(),
                       this->Surface().CenterWorld);
}

Status CompleteSurface(const std::vector<SurfaceTouch>& touches,
                       std::shared_ptr<const ShapePrior> priorOrNull,
                       const std::optional<Vector3>& clickWorld,
                       std::unique_ptr<ShapeCompletion>& made)
{
  TouchExtent extent(touches);
  if (clickWorld ? !clickWorld->allFinite() : extent.Count == 0)
  {
    return Status::Failure("there is no touched point and no centre");
  }
  const Vector3 click = clickWorld.value_or(extent.Middle);
  if (priorOrNull == nullptr)
  {
    extent.TakeDistances(touches, click);
    const double radius = std::exp(extent.LogDistance);
    priorOrNull = std::make_shared<const ShapePrior>(
        extent.Count > 0 && std::isfinite(radius) ? ShapePrior::Smooth(radius) : ShapePrior());
  }
  auto completion = std::make_unique<ShapeCompletion>(std::move(priorOrNull), click);
  const Status status = completion->Update(touches);
  if (status.IsOk())
  {
    made = std::move(completion);
  }
  return status;
}
} // namespace palpate
