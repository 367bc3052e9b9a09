#pragma once

#include "MaskStatistic.h"
#include "RadialProbe.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <string>
#include <vector>

namespace palpate
{
/// Changes of an outline that are looked for, each a list of coefficients: heat kernels of four
/// widths at 362 directions (bumps and dents).
struct OutlineTemplates
{
  OutlineTemplates();

  Eigen::MatrixXd Columns;         ///< heat kernels, then the six cuts
  std::vector<Vector3> Directions; ///< of the heat kernels: the widths run fastest
  static constexpr int Widths = 4;
};

/// The normal distribution of an organ's outlines over a group (CoefficientDistribution), and how
/// far an outline lies outside of it.
class ShapeGroup
{
public:
  ShapeGroup() = default;
  /// Of cases, a row of coefficients each; at least three.
  ShapeGroup(const Eigen::MatrixXd& cases, const OutlineTemplates& templates);
  /// Of a file. The covariance must be positive definite, which IsValid tells.
  ShapeGroup(Eigen::VectorXd mean, const Eigen::MatrixXd& covariance,
             const OutlineTemplates& templates);

  bool IsValid() const { return this->Factor.info() == Eigen::Success && this->Mean_.size() > 0; }
  const Eigen::VectorXd& Mean() const noexcept { return this->Mean_; }
  Eigen::MatrixXd Covariance() const { return this->Factor.reconstructedMatrix(); }

  /// "shape": the largest |t| = |g' P^-1 d| / sqrt(g' P^-1 g) over the heat kernels g, d the
  /// outline minus the mean, at the outline in that direction; Amount below 0: a dent. "band_2",
  /// "band_3_5", "band_6_12": root mean square of the whitened coefficients of these degrees.
  /// `templates` are those of the constructor.
  MaskStatistics Judge(const RadialOutline& outline, const OutlineTemplates& templates) const;

private:
  void Factorise(const Eigen::MatrixXd& covariance, const OutlineTemplates& templates);
  double Band(const Eigen::VectorXd& difference, int from, int to) const;

  Eigen::VectorXd Mean_;
  Eigen::LLT<Eigen::MatrixXd> Factor;
  Eigen::VectorXd Lengths; // of the templates over the covariance's root
};

/// The cases of a group that are odd: of those whose largest |t|, itself left out, exceeds 2.2
/// times the median, repeatedly without them. True for those that stay. `leftOut` gets the
/// statistics of each case against those that stay without itself. `atATime` threads.
std::vector<bool> TrimGroup(const std::vector<RadialOutline>& outlines,
                            const OutlineTemplates& templates, std::size_t atATime,
                            std::vector<MaskStatistics>& leftOut);

/// The coefficients of outlines, a row each.
Eigen::MatrixXd OutlineRows(const std::vector<RadialOutline>& outlines,
                            const std::vector<bool>& isTaken, std::size_t without);
} // namespace palpate
