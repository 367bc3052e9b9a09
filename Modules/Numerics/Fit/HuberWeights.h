#pragma once

#include <cstddef>
#include <vector>

namespace palpate
{
/// Factors of a robust fit by iteratively reweighted least squares: a sample whose standardised
/// residual t is beyond +-1.345 counts 1.345 / |t| as much, the others fully (Huber, Ann. Math.
/// Statist. 35, 1964; Holland and Welsch, Comm. Statist. A 6, 1977). At 1.345 the fit keeps 95 % of
/// its efficiency where errors are normal. Residuals are standardised by the square root of weight
/// over mean weight and by a scale: the median of their magnitudes over 0.6745, with a correction
/// for the coefficients fitted.
class HuberWeights
{
public:
  static constexpr double Tuning = 1.345;

  /// `weights` of the samples; those of weight zero count nowhere.
  explicit HuberWeights(const std::vector<double>& weights);

  /// Finds the scale (mm, of a sample of mean weight) from residuals (mm), not below `smallest`;
  /// `fitted`: degrees of freedom that the fit used.
  void Rescale(const std::vector<double>& residuals, double fitted, double smallest);
  /// Finds the factors for the scale.
  void Update(const std::vector<double>& residuals);

  double Scale() const noexcept { return this->Deviation; }
  /// In (0, 1], one a sample.
  const std::vector<double>& Factors() const noexcept { return this->Values; }
  /// How many samples of positive weight have a factor below 1.
  std::size_t DownWeighted() const;
  /// Asymptotic variance of the coefficients over (A^T A)^-1, for samples of mean weight (mm^2):
  /// Huber, Robust Statistics (1981), 7.6.
  double Variance(const std::vector<double>& residuals, double fitted) const;

private:
  double Standardised(double residual, std::size_t sample) const
  {
    return residual * this->Roots[sample];
  }

  std::vector<double> Roots; // of weight over mean weight
  std::vector<double> Values;
  std::vector<double> Work;
  double Deviation = 0.0;
  double Count = 0.0;
};
} // namespace palpate
