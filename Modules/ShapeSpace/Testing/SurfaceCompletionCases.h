#pragma once

#include "RandomShapes.h"
#include "SurfaceCompletion.h"

#include <cmath>
#include <memory>
#include <random>
#include <vector>

namespace palpate::test
{
/// Bent plates about other bodies, which are nearly spheres: what is known of the body says where
/// the plate's outer side is. Half of them bend to the left, half to the right.
inline std::vector<SurfacePrior::Case> BentPlates(Random& random, int count, int degree = 6)
{
  std::normal_distribution<double> normal;
  const std::size_t size = SphericalHarmonicBasis::CoefficientCount(degree);
  std::vector<SurfacePrior::Case> cases;
  for (int n = 0; n < count; ++n)
  {
    const double radius = 22.0 * std::exp(0.1 * normal(random));
    const double bend = normal(random);
    std::array<std::vector<double>, 3> axes;
    for (std::vector<double>& axis : axes)
    {
      axis.assign(size, 0.0);
      for (std::size_t k = 4; k < size; ++k)
      {
        axis[k] = 0.6 * normal(random) / std::sqrt(static_cast<double>(k));
      }
    }
    const double scale = std::sqrt(4.0 * M_PI / 3.0);
    axes[0][3] += 0.9 * radius * scale;
    axes[1][1] += 5.0 * scale;
    axes[2][2] += 0.7 * radius * scale;
    axes[1][8] += 0.25 * radius * scale; // bent back at both ends
    axes[1][5] += bend;
    LogSurface known{Eigen::VectorXd::Zero(169), Vector3(10.0 * n, -3.0, 5.0)};
    known.Coefficients[0] = std::log(radius) / ShapePrior::ConstantHarmonic;
    known.Coefficients[6] = 0.05 * normal(random);
    const Vector3 behind(0.3 * normal(random), 0.5 * radius + 0.3 * normal(random), 0.0);
    cases.push_back({SurfaceModel(degree, axes), known.CenterWorld + behind, known});
  }
  return cases;
}

inline std::shared_ptr<const SurfacePrior> PlatePrior(std::uint64_t seed, bool isRelated)
{
  Random random(seed);
  std::vector<SurfacePrior::Case> cases = BentPlates(random, 24);
  for (SurfacePrior::Case& one : cases)
  {
    one.Known = isRelated ? one.Known : std::nullopt;
  }
  SurfacePrior prior;
  const Status status = SurfacePrior::OfGroup(cases, prior);
  return status.IsOk() ? std::make_shared<const SurfacePrior>(std::move(prior)) : nullptr;
}

/// Touches of a case's surface, with outward normals.
inline std::vector<SurfaceTouch> TouchesOn(const SurfacePrior::Case& one,
                                           const std::vector<Vector3>& parameters, double deviation)
{
  std::vector<SurfaceTouch> touches;
  for (const Vector3& parameter : parameters)
  {
    touches.push_back({one.CentroidWorld + one.Surface.Point(parameter), deviation,
                       one.Surface.Normal(parameter)});
  }
  return touches;
}

/// The prior's covariance of all coefficients and the centroid, as a matrix.
inline Eigen::MatrixXd DenseCovariance(const SurfacePrior& prior, const Eigen::MatrixXd& scores)
{
  const Eigen::Index size = prior.Mean.size();
  const Eigen::Index count = size / 3;
  Eigen::MatrixXd map = Eigen::MatrixXd::Zero(size + 3, scores.rows());
  map.topLeftCorner(size, prior.Modes.cols()) = prior.Modes;
  map.bottomRightCorner<3, 3>().setIdentity();
  Eigen::MatrixXd dense = map * scores * map.transpose();
  for (Eigen::Index k = 0; k < size; ++k)
  {
    const auto degree = static_cast<Eigen::Index>(std::sqrt(static_cast<double>(k % count) + 0.5));
    dense(k, k) += prior.Rest[degree];
  }
  return dense;
}

/// The rows by coefficients and centroid, a row each.
inline Eigen::MatrixXd DenseRows(const SurfaceRows& rows)
{
  const Eigen::Index count = rows.Harmonics.rows();
  Eigen::MatrixXd dense(rows.Count(), 3 * count + 3);
  for (Eigen::Index row = 0; row < rows.Count(); ++row)
  {
    for (Eigen::Index axis = 0; axis < 3; ++axis)
    {
      dense.row(row).segment(axis * count, count) =
          rows.Axes(axis, row) * rows.Harmonics.col(row).transpose();
    }
    dense.row(row).tail<3>() = rows.Moves[row] * rows.Axes.col(row).transpose();
  }
  return dense;
}
} // namespace palpate::test
