#include "IncrementalFit.h"

#include "ConditionEstimate.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace palpate
{
namespace
{
// Largest condition number of the (penalised) problem to start from.
constexpr double HighestCondition = 1e4;

bool IsSane(double value)
{
  return std::abs(value) < 1e100; // false for NaN
}
} // namespace

IncrementalFit::IncrementalFit(int degree)
    : Solver(degree), Basis(degree), Inverse(Solver.Triangle()), Values(Inverse.MakeVector()),
      Harmonics(Inverse.MakeVector()), Gain(Inverse.MakeVector())
{
}

Status IncrementalFit::ToStatus(Change change)
{
  switch (change)
  {
  case Change::Made:
    return Status::Success();
  case Change::NotFinite:
    return Status::Failure(
        "a sample needs a unit direction, a finite radius and a positive weight");
  case Change::Full:
    return Status::Failure("the fit has no room for another sample; remove one or start it again "
                           "with a larger capacity");
  case Change::Unknown:
    return Status::Failure("the fit has no sample of this number");
  case Change::Singular:
    break;
  }
  return Status::Failure("without this sample the others would not determine the coefficients");
}

Status IncrementalFit::Start(const RadialSamples& samples, double strength, std::size_t capacity)
{
  Status status = CheckSamples(samples, this->Degree());
  if (!status.IsOk())
  {
    return status;
  }
  if (!(strength >= 0.0) || !std::isfinite(strength))
  {
    return Status::Failure("the strength of the penalty must not be negative");
  }
  this->Strength = strength;
  this->WeightScale =
      4.0 * M_PI / std::accumulate(samples.Weights.begin(), samples.Weights.end(), 0.0);
  this->Samples = samples;
  const std::size_t count = samples.Radii.size();
  const std::size_t room = std::max(capacity, count);
  this->Samples.Directions.resize(room, Vector3::UnitZ());
  this->Samples.Radii.resize(room, 0.0);
  this->Samples.Weights.resize(room, 0.0);
  this->Used.assign(room, 0);
  std::fill_n(this->Used.begin(), count, 1);
  this->Free.clear();
  this->Free.reserve(room);
  for (std::size_t number = room; number-- > count;)
  {
    this->Free.push_back(number);
  }
  return this->Restart();
}

Status IncrementalFit::Restart()
{
  std::vector<double> weights = this->Samples.Weights;
  for (double& weight : weights)
  {
    weight *= this->WeightScale;
  }
  if (weights.empty() ||
      (!this->Solver.Reduce({this->Samples.Directions.front().data(), weights.data(),
                             this->Samples.Radii.data(), static_cast<long>(weights.size())}) &&
       this->Strength == 0.0) ||
      !this->Solver.Solve(this->Strength) ||
      !(EstimateCondition(this->Solver.System()) <= HighestCondition))
  {
    return Status::Failure("the samples leave the degree undetermined; take more directions, a "
                           "roughness penalty or a lower degree");
  }
  this->Values = this->Solver.Coefficients();
  this->Inverse.Clear();
  CacheLineVector<double> column = this->Inverse.MakeVector();
  for (int i = 0; i < this->Inverse.Size(); ++i)
  {
    std::fill(column.begin(), column.end(), 0.0);
    column[static_cast<std::size_t>(i)] = 1.0;
    this->Solver.System().Solve(column.data());
    for (int row = i; row < this->Inverse.Size(); ++row)
    {
      this->Inverse.At(row, i) = column[static_cast<std::size_t>(row)];
    }
  }
  this->Inverse.MirrorDiagonal();
  return Status::Success();
}

bool IncrementalFit::Knows(std::size_t number) const noexcept
{
  return number < this->Used.size() && this->Used[number] != 0;
}

double IncrementalFit::Weight(std::size_t number) const noexcept
{
  return this->WeightScale * this->Samples.Weights[number];
}

// Harmonics y and g = P y of a direction; returns y.g.
double IncrementalFit::FindGain(const Vector3& direction) noexcept
{
  this->Basis.Evaluate(direction, this->Harmonics.data());
  this->Inverse.MultiplySymmetric(this->Harmonics.data(), this->Gain.data());
  const auto size = static_cast<Eigen::Index>(this->Gain.size());
  return Eigen::Map<const Eigen::VectorXd>(this->Harmonics.data(), size)
      .dot(Eigen::Map<const Eigen::VectorXd>(this->Gain.data(), size));
}

double IncrementalFit::Predict() const noexcept
{
  const auto size = static_cast<Eigen::Index>(this->Values.size());
  return Eigen::Map<const Eigen::VectorXd>(this->Harmonics.data(), size)
      .dot(Eigen::Map<const Eigen::VectorXd>(this->Values.data(), size));
}

void IncrementalFit::Move(double step) noexcept
{
  for (std::size_t i = 0; i < this->Values.size(); ++i)
  {
    this->Values[i] += step * this->Gain[i];
  }
}

IncrementalFit::Change IncrementalFit::Add(const Vector3& direction, double radius, double weight,
                                           std::size_t& number) noexcept
{
  // Single precision may have rounded the direction.
  if (!IsSane(radius) || !IsSane(weight) || !(weight > 0.0) ||
      !(std::abs(direction.squaredNorm() - 1.0) <= 1e-5))
  {
    return Change::NotFinite;
  }
  if (this->Free.empty())
  {
    return Change::Full;
  }
  const double scaled = this->WeightScale * weight;
  const double factor = scaled / (1.0 + scaled * this->FindGain(direction));
  this->Move(factor * (radius - this->Predict()));
  this->Inverse.AddSquare(-factor, this->Gain.data());
  number = this->Free.back();
  this->Free.pop_back();
  this->Used[number] = 1;
  this->Samples.Directions[number] = direction;
  this->Samples.Radii[number] = radius;
  this->Samples.Weights[number] = weight;
  return Change::Made;
}

IncrementalFit::Change IncrementalFit::SetRadius(std::size_t number, double radius) noexcept
{
  if (!this->Knows(number))
  {
    return Change::Unknown;
  }
  if (!IsSane(radius))
  {
    return Change::NotFinite;
  }
  this->FindGain(this->Samples.Directions[number]);
  this->Move(this->Weight(number) * (radius - this->Samples.Radii[number]));
  this->Samples.Radii[number] = radius;
  return Change::Made;
}

IncrementalFit::Change IncrementalFit::Remove(std::size_t number) noexcept
{
  if (!this->Knows(number))
  {
    return Change::Unknown;
  }
  const double weight = this->Weight(number);
  const double remainder = 1.0 - weight * this->FindGain(this->Samples.Directions[number]);
  if (!(remainder >= LeastRemainder))
  {
    return Change::Singular;
  }
  const double factor = weight / remainder;
  this->Move(-factor * (this->Samples.Radii[number] - this->Predict()));
  this->Inverse.AddSquare(factor, this->Gain.data());
  this->Used[number] = 0;
  this->Free.push_back(number);
  this->Samples.Weights[number] = 0.0;
  return Change::Made;
}
} // namespace palpate
