#include "PackedCompliance.h"

#include "SphericalHarmonicBasis.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace palpate
{
PackedCompliance PackedCompliance::Of(const ReducedCompliance& compliance, int degree)
{
  const ReducedCompliance kept = compliance.Truncated(std::min(degree, compliance.Degree()));
  const Eigen::MatrixXd& matrix = kept.Matrix();
  PackedCompliance packed;
  packed.Degree = kept.Degree();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
  {
    constexpr double Digits = 1e9; // of mm/N sr, so that files are short
    packed.Roots.push_back(std::round(Digits * std::sqrt(matrix(i, i))) / Digits);
    for (Eigen::Index j = 0; j < i; ++j)
    {
      const double relative = matrix(i, j) / std::sqrt(matrix(i, i) * matrix(j, j));
      packed.Relative.push_back(
          static_cast<std::int16_t>(std::lround(Whole * std::clamp(relative, -1.0, 1.0))));
    }
  }
  return packed;
}

ReducedCompliance PackedCompliance::Unpacked() const
{
  const auto rows = static_cast<Eigen::Index>(this->Roots.size());
  Eigen::MatrixXd matrix(rows, rows);
  std::size_t next = 0;
  for (Eigen::Index i = 0; i < rows; ++i)
  {
    const double root = this->Roots[static_cast<std::size_t>(i)];
    matrix(i, i) = root * root;
    for (Eigen::Index j = 0; j < i; ++j)
    {
      matrix(i, j) = matrix(j, i) =
          root * this->Roots[static_cast<std::size_t>(j)] * this->Relative[next++] / Whole;
    }
  }
  return ReducedCompliance::Of(this->Degree, std::move(matrix));
}

Status PackedCompliance::Check() const
{
  const bool isDegree = this->Degree >= 0 && this->Degree <= ReducedCompliance::MostDegree;
  const std::size_t rows =
      isDegree ? 3 * SphericalHarmonicBasis::CoefficientCount(this->Degree) : 0;
  const bool isComplete =
      isDegree && this->Roots.size() == rows && this->Relative.size() == rows * (rows - 1) / 2 &&
      std::all_of(this->Roots.begin(), this->Roots.end(),
                  [](double root) { return root > 0.0 && std::isfinite(root * root); }) &&
      std::all_of(this->Relative.begin(), this->Relative.end(),
                  [](int value) { return std::abs(value) <= Whole; });
  return isComplete ? Status::Success()
                    : Status::Failure("The compliance to long waves is incomplete.");
}
} // namespace palpate
