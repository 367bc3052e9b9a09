#pragma once

#include <cstddef>
#include <vector>

namespace palpate
{
/// Factors of a robust fit by iteratively reweighted least squares: a sample whose standardised
/// residual t is beyond +-1.345 gets the factor 1.345 / |t|, the others 1 (Huber, Ann. Math.
/// Statist. 35, 1964; Holland and Welsch, Comm. Statist. A 6, 1977). At 1.345 the fit keeps 95 % of
/// its efficiency for normal errors. Residuals are standardised by the square root of weight over
/// mean weight and by a scale: the median of their magnitudes over 0.6745, corrected for the number
/// of fitted coefficients.
class HuberWeights
{
public:
  static constexpr double Tuning = 1.345;

  /// `weights` of the samples; those of weight zero are ignored.
  explicit HuberWeights(const std::vector<double>& weights);

  /// Estimates the scale (mm, of a sample of mean weight) from residuals (mm), at least `smallest`;
  /// `fitted`: degrees of freedom that the fit used.
  void Rescale(const std::vector<double>& residuals, double fitted, double smallest);
  void Update(const std::vector<double>& residuals);

  double Scale() const noexcept { return this->Deviation; }
  /// In (0, 1], one per sample.
  const std::vector<double>& Factors() const noexcept { return this->Values; }
  /// Number of samples of positive weight with a factor below 1.
  std::size_t DownWeighted() const;
  /// Asymptotic variance of the coefficients relative to (A^T A)^-1, for samples of mean weight
  /// (mm^2): Huber, Robust Statistics (1981), 7.6.
  double Variance(const std::vector<double>& residuals, double fitted) const;

private:
  double Standardised(double residual, std::size_t sample) const
  {
    return residual * this->Roots[sample];
  }

  std::vector<double> Roots; // square roots of weight over mean weight
  std::vector<double> Values;
  std::vector<double> Work;
  double Deviation = 0.0;
  double Count = 0.0;
};
} // namespace palpate
