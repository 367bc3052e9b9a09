#include "SurfacePosterior.h"

#include <Eigen/Cholesky>
#include <utility>

namespace palpate
{
namespace
{
Eigen::VectorXd SeenOf(const SurfaceRows& rows, const Eigen::VectorXd& coefficients,
                       const Vector3& centroid)
{
  const Eigen::Map<const Eigen::MatrixX3d> axes(coefficients.data(), rows.Harmonics.rows(), 3);
  const Eigen::Matrix3Xd points = axes.transpose() * rows.Harmonics + centroid * rows.Moves;
  return points.cwiseProduct(rows.Axes).colwise().sum().transpose();
}
} // namespace

void SurfaceRows::Resize(Eigen::Index size, Eigen::Index count)
{
  this->Harmonics.resize(size, count);
  this->Axes.resize(3, count);
  this->Moves.resize(count);
}

SurfacePosterior::SurfacePosterior(std::shared_ptr<const SurfacePrior> prior,
                                   SurfaceDistribution before)
    : Given(std::move(prior)), Start(std::move(before)), Mean(this->Start.Mean),
      Centroid(this->Start.CentroidWorld)
{
  this->RestVariances.resize(this->Mean.size() / 3);
  for (int degree = 0; degree <= this->Given->Degree; ++degree)
  {
    this->RestVariances.segment(degree * degree, 2 * degree + 1)
        .setConstant(this->Given->Rest[degree]);
  }
  this->Seen.Resize(this->RestVariances.size(), 0);
  this->SeenScores.resize(this->Start.Covariance.rows(), 0);
}

// Derivatives of the rows by scores and centroid, a column each row.
Eigen::MatrixXd SurfacePosterior::ScoresOf(const SurfaceRows& rows) const
{
  const Eigen::Index modes = this->Given->Modes.cols();
  Eigen::MatrixXd made = Eigen::MatrixXd::Zero(modes + 3, rows.Count());
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    const auto part =
        this->Given->Modes.middleRows(axis * rows.Harmonics.rows(), rows.Harmonics.rows());
    made.topRows(modes).noalias() +=
        part.transpose() * (rows.Harmonics * rows.Axes.row(axis).asDiagonal());
  }
  made.bottomRows<3>() = rows.Axes * rows.Moves.asDiagonal();
  return made;
}

Eigen::MatrixXd SurfacePosterior::RestBetween(const SurfaceRows& one,
                                              const SurfaceRows& other) const
{
  const Eigen::MatrixXd harmonics =
      one.Harmonics.transpose() * (this->RestVariances.asDiagonal() * other.Harmonics);
  return harmonics.cwiseProduct(one.Axes.transpose() * other.Axes);
}

Eigen::VectorXd SurfacePosterior::Before(const SurfaceRows& rows) const
{
  return SeenOf(rows, this->Start.Mean, this->Start.CentroidWorld);
}

Eigen::VectorXd SurfacePosterior::After(const SurfaceRows& rows) const
{
  return SeenOf(rows, this->Mean, this->Centroid);
}

void SurfacePosterior::Condition(const SurfaceRows& rows, const Eigen::VectorXd& values,
                                 const Eigen::MatrixXd& noise)
{
  this->Seen = rows;
  const Eigen::MatrixXd scores = this->ScoresOf(rows);
  this->SeenScores = this->Start.Covariance * scores;
  this->Factor = scores.transpose() * this->SeenScores + this->RestBetween(rows, rows) + noise;
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factor(this->Factor);
  const Eigen::VectorXd weights = factor.solve(values - this->Before(rows));
  const Eigen::VectorXd moved = this->SeenScores * weights;
  this->Mean = this->Start.Mean;
  this->Mean.noalias() += this->Given->Modes * moved.head(this->Given->Modes.cols());
  Eigen::Map<Eigen::MatrixX3d> axes(this->Mean.data(), this->RestVariances.size(), 3);
  axes.noalias() += this->RestVariances.asDiagonal() * rows.Harmonics *
                    (rows.Axes * weights.asDiagonal()).transpose();
  this->Centroid = this->Start.CentroidWorld + moved.tail<3>();
}

// L^-1 times the covariance of what was seen with what rows see.
Eigen::MatrixXd SurfacePosterior::Known(const SurfaceRows& rows,
                                        const Eigen::MatrixXd& scores) const
{
  Eigen::MatrixXd known =
      this->SeenScores.transpose() * scores + this->RestBetween(this->Seen, rows);
  if (known.rows() > 0)
  {
    this->Factor.triangularView<Eigen::Lower>().solveInPlace(known);
  }
  return known;
}

Eigen::MatrixXd SurfacePosterior::Covariance(const SurfaceRows& rows) const
{
  const Eigen::MatrixXd scores = this->ScoresOf(rows);
  const Eigen::MatrixXd known = this->Known(rows, scores);
  return scores.transpose() * this->Start.Covariance * scores + this->RestBetween(rows, rows) -
         known.transpose() * known;
}

Eigen::VectorXd SurfacePosterior::Variances(const SurfaceRows& rows) const
{
  const Eigen::MatrixXd scores = this->ScoresOf(rows);
  const Eigen::VectorXd rest = (rows.Harmonics.cwiseAbs2().transpose() * this->RestVariances)
                                   .cwiseProduct(rows.Axes.colwise().squaredNorm().transpose());
  return (this->Start.Covariance * scores).cwiseProduct(scores).colwise().sum().transpose() + rest -
         this->Known(rows, scores).colwise().squaredNorm().transpose();
}
} // namespace palpate
