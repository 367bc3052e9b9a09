#include "ConditionEstimate.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace palpate
{
namespace
{
constexpr int MostProducts = 16;

// A fixed asymmetric start vector, in practice orthogonal to no eigenvector.
CacheLineVector<double> Start(const PackedTriangle& factor)
{
  CacheLineVector<double> v = factor.MakeVector();
  Eigen::Map<Eigen::VectorXd> head(v.data(), factor.Size());
  for (Eigen::Index i = 0; i < head.size(); ++i)
  {
    head[i] = 1.0 + std::sin(1.0 + 1.7 * static_cast<double>(i * i % 1009));
  }
  head.normalize();
  return v;
}

double LargestRitzValue(const std::vector<double>& diagonal, const std::vector<double>& offDiagonal)
{
  const auto size = static_cast<Eigen::Index>(diagonal.size());
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(Eigen::Map<const Eigen::VectorXd>(diagonal.data(), size),
                                Eigen::Map<const Eigen::VectorXd>(offDiagonal.data(), size - 1),
                                Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[size - 1];
}

// Largest eigenvalue of the symmetric map that `apply` applies in place. Each vector is
// orthogonalised against all previous ones, which are few.
template <typename Apply>
double LargestEigenvalue(const PackedTriangle& factor, const Apply& apply)
{
  std::vector<CacheLineVector<double>> basis{Start(factor)};
  std::vector<double> diagonal;
  std::vector<double> offDiagonal;
  double value = 0.0;
  const int steps = std::min(MostProducts, factor.Size());
  for (int step = 0; step < steps; ++step)
  {
    CacheLineVector<double> next = basis.back();
    apply(next.data());
    Eigen::Map<Eigen::VectorXd> w(next.data(), factor.PaddedSize());
    for (std::size_t k = basis.size(); k-- > 0;)
    {
      const Eigen::Map<const Eigen::VectorXd> v(basis[k].data(), factor.PaddedSize());
      const double along = v.dot(w);
      w -= along * v;
      if (k + 1 == basis.size())
      {
        diagonal.push_back(along);
      }
    }
    const double norm = w.norm();
    if (!std::isfinite(norm))
    {
      return std::numeric_limits<double>::infinity();
    }
    const double before = value;
    value = LargestRitzValue(diagonal, offDiagonal);
    if ((step > 2 && value - before <= 1e-3 * value) || norm <= 1e-12 * value)
    {
      break;
    }
    w /= norm;
    offDiagonal.push_back(norm);
    basis.push_back(std::move(next));
  }
  return value;
}
} // namespace

double EstimateCondition(const PackedTriangle& factor)
{
  for (int i = 0; i < factor.Size(); ++i)
  {
    if (!(std::abs(factor.At(i, i)) > 0.0))
    {
      return std::numeric_limits<double>::infinity();
    }
  }
  CacheLineVector<double> work = factor.MakeVector();
  const double largest = LargestEigenvalue(factor,
                                           [&factor, &work](double* x)
                                           {
                                             factor.MultiplyUpper(x, work.data());
                                             factor.MultiplyLower(work.data(), x);
                                           });
  const double inverse = LargestEigenvalue(factor, [&factor](double* x) { factor.Solve(x); });
  return std::sqrt(largest * inverse);
}
} // namespace palpate
