#include "CoefficientCovariance.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
Eigen::Map<const Eigen::VectorXd> AsVector(const CacheLineVector<double>& v, int size)
{
  return {v.data(), size};
}
} // namespace

double CoefficientCovariance::RadiusDeviation(const double* basisValues) const
{
  CacheLineVector<double> combination = this->Samples.MakeVector();
  std::copy_n(basisValues, this->Size(), combination.begin());
  if (this->System.Size() == 0)
  {
    this->Samples.SolveLower(combination.data());
    return std::sqrt(this->Variance) * AsVector(combination, this->Size()).norm();
  }
  this->System.Solve(combination.data());
  CacheLineVector<double> reached = this->Samples.MakeVector();
  this->Samples.MultiplyUpper(combination.data(), reached.data());
  return std::sqrt(this->Variance) * AsVector(reached, this->Size()).norm();
}

Eigen::MatrixXd CoefficientCovariance::Factor() const
{
  Eigen::MatrixXd factor(this->Size(), this->Size());
  CacheLineVector<double> column = this->Samples.MakeVector();
  CacheLineVector<double> unit = this->Samples.MakeVector();
  for (int i = 0; i < this->Size(); ++i)
  {
    std::fill(unit.begin(), unit.end(), 0.0);
    unit[static_cast<std::size_t>(i)] = 1.0;
    if (this->System.Size() == 0)
    {
      this->Samples.SolveUpper(unit.data());
      std::swap(unit, column);
    }
    else
    {
      this->Samples.MultiplyLower(unit.data(), column.data());
      this->System.Solve(column.data());
    }
    factor.col(i) = std::sqrt(this->Variance) * AsVector(column, this->Size());
  }
  return factor;
}

double CoefficientCovariance::DegreesOfFreedom() const
{
  if (this->System.Size() == 0)
  {
    return this->Size();
  }
  double trace = 0.0;
  CacheLineVector<double> unit = this->Samples.MakeVector();
  CacheLineVector<double> column = this->Samples.MakeVector();
  for (int i = 0; i < this->Size(); ++i)
  {
    std::fill(unit.begin(), unit.end(), 0.0);
    unit[static_cast<std::size_t>(i)] = 1.0;
    this->Samples.MultiplyLower(unit.data(), column.data());
    this->System.SolveLower(column.data());
    trace += AsVector(column, this->Size()).squaredNorm();
  }
  return trace;
}

double CoefficientCovariance::Trace() const
{
  double trace = 0.0;
  std::vector<double> unit(static_cast<std::size_t>(this->Size()));
  for (double& entry : unit)
  {
    entry = 1.0;
    const double deviation = this->RadiusDeviation(unit.data());
    trace += deviation * deviation;
    entry = 0.0;
  }
  return trace;
}
} // namespace palpate
