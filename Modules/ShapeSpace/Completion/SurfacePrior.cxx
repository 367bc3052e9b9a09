#include "SurfacePrior.h"

#include "IcosahedronDirections.h"
#include "ShapeMirror.h"
#include "ShapeModes.h"
#include "ShapePrior.h"
#include "ShapeVector.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace palpate
{
namespace
{
constexpr double RestFloor = 1e-6;           // mm^2
constexpr double SmallestSurface = 0.1;      // mm, RMS of the mean about its centroid
constexpr double LargestSurface = 1000.0;    // mm
constexpr double LargestScoreVariance = 1e7; // mm^2

SurfacePrior::Case MirrorOf(const SurfacePrior::Case& one)
{
  SurfacePrior::Case mirrored{std::get<SurfaceModel>(MirrorShape(one.Surface)), one.CentroidWorld,
                              one.Known};
  mirrored.CentroidWorld.x() *= -1.0;
  if (mirrored.Known)
  {
    const int degree = ShapePrior::UsualDegree;
    const RadialModel known(
        degree, {mirrored.Known->Coefficients.begin(), mirrored.Known->Coefficients.end()},
        mirrored.Known->CenterWorld);
    const OrganModel other = MirrorShape(known);
    mirrored.Known->Coefficients = VectorOf(other);
    mirrored.Known->CenterWorld.x() *= -1.0;
  }
  return mirrored;
}

Eigen::MatrixXd RowsOf(const std::vector<SurfacePrior::Case>& cases)
{
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(cases.size()),
                       static_cast<Eigen::Index>(CoefficientCountOf(cases.front().Surface)));
  for (std::size_t n = 0; n < cases.size(); ++n)
  {
    rows.row(static_cast<Eigen::Index>(n)) = VectorOf(cases[n].Surface);
  }
  return rows;
}

// Whether mirroring changes the mean by less than half of the cases' own spread.
bool IsSymmetric(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& mirrored)
{
  const Eigen::RowVectorXd mean = rows.colwise().mean();
  const double spread =
      (rows.rowwise() - mean).squaredNorm() / static_cast<double>(rows.rows() - 1);
  const double odd = 0.25 * (mean - mirrored.colwise().mean()).squaredNorm();
  return odd <= 0.25 * spread;
}

// The mean square of each degree of what the modes leave, of three coordinates.
Eigen::VectorXd RestOf(const Eigen::MatrixXd& rest, int degree)
{
  const Eigen::Index count = rest.cols() / 3;
  Eigen::VectorXd variances(degree + 1);
  for (int l = 0; l <= degree; ++l)
  {
    double sum = 0.0;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
    {
      sum += rest.middleCols(axis * count + l * l, 2 * l + 1).squaredNorm();
    }
    variances[l] = RestFloor + SurfacePrior::RestFactor * sum /
                                   static_cast<double>(3 * (2 * l + 1) * rest.rows());
  }
  return variances;
}

// The distances of a case's surface from its known organ.
Eigen::RowVectorXd WallsOf(const SurfacePrior::Case& one)
{
  const std::vector<Vector3> places =
      IcosahedronDirections(OrganRelation::WallFrequency).Directions();
  Eigen::Matrix3Xd points(3, OrganRelation::WallCount);
  for (Eigen::Index n = 0; n < OrganRelation::WallCount; ++n)
  {
    points.col(n) = one.CentroidWorld + one.Surface.Point(places[static_cast<std::size_t>(n)]);
  }
  LogSurfaceDistance distance(*one.Known);
  distance.Evaluate(points);
  return distance.Values().transpose();
}

OrganRelation RelationOf(const std::vector<SurfacePrior::Case>& cases,
                         const Eigen::MatrixXd& scores)
{
  const auto count = static_cast<Eigen::Index>(cases.size());
  Eigen::MatrixXd asked(count, scores.cols() + 3);
  Eigen::MatrixXd known(count, OrganRelation::ScoreCount);
  Eigen::MatrixXd walls(count, OrganRelation::WallCount);
  asked.leftCols(scores.cols()) = scores;
  for (Eigen::Index n = 0; n < count; ++n)
  {
    const SurfacePrior::Case& one = cases[static_cast<std::size_t>(n)];
    asked.row(n).tail<3>() = one.CentroidWorld - one.Known->CenterWorld;
    known.row(n) = one.Known->Coefficients.head(OrganRelation::ScoreCount);
    walls.row(n) = WallsOf(one);
  }
  OrganRelation relation;
  relation.Offset = asked.rightCols<3>().colwise().mean();
  asked.rightCols<3>().rowwise() -= relation.Offset.transpose();
  relation.Regress(asked, known);
  relation.TakeWalls(walls);
  return relation;
}
} // namespace

Status SurfacePrior::OfGroup(const std::vector<Case>& cases, SurfacePrior& prior)
{
  if (cases.size() < LeastCases)
  {
    return Status::Failure("a prior needs at least " + std::to_string(LeastCases) +
                           " surface models, but there are " + std::to_string(cases.size()));
  }
  std::vector<Case> all = cases;
  std::transform(cases.begin(), cases.end(), std::back_inserter(all), MirrorOf);
  Eigen::MatrixXd rows = RowsOf(all);
  const auto count = static_cast<Eigen::Index>(cases.size());
  if (!IsSymmetric(rows.topRows(count), rows.bottomRows(count)))
  {
    all.erase(all.begin() + count, all.end());
    rows.conservativeResize(count, Eigen::NoChange);
  }
  ShapeModes group;
  if (Status status = FindShapeModes(rows, group); !status.IsOk())
  {
    return status;
  }
  // A mode for every third case: the later ones are noise.
  const Eigen::Index modes = std::min({MostModes, group.Modes.cols(), 1 + count / 3});
  SurfacePrior made;
  made.Degree = cases.front().Surface.Degree();
  made.CaseCount = cases.size();
  made.Mean = group.Mean;
  made.Modes = group.Modes.leftCols(modes);
  made.Variances = group.Deviations.head(modes).cwiseAbs2();
  const Eigen::MatrixXd scores = group.Scores.leftCols(modes);
  made.Rest = RestOf((rows.rowwise() - group.Mean.transpose()) - scores * made.Modes.transpose(),
                     made.Degree);
  if (std::all_of(cases.begin(), cases.end(),
                  [](const Case& one) { return one.Known.has_value(); }))
  {
    made.Relation = RelationOf(all, scores);
  }
  Status status = made.Check();
  if (status.IsOk())
  {
    prior = std::move(made);
  }
  return status;
}

Status SurfacePrior::Check() const
{
  const Eigen::Index count = 3 * static_cast<Eigen::Index>(this->Degree + 1) * (this->Degree + 1);
  if (this->Degree < 1 || this->Degree > LargestDegree || this->Mean.size() != count ||
      this->Modes.rows() != count || this->Modes.cols() < 1 || this->Modes.cols() > MostModes ||
      this->Variances.size() != this->Modes.cols() || this->Rest.size() != this->Degree + 1)
  {
    return Status::Failure("has numbers of no degree from 1 to " + std::to_string(LargestDegree));
  }
  const double size = RmsOverSphere(this->Mean);
  if (!this->Mean.allFinite() || !(size > SmallestSurface) || !(size < LargestSurface))
  {
    return Status::Failure("has a mean surface outside of 0.1 to 1,000 mm");
  }
  // Single precision leaves 1e-7 of each number.
  const Eigen::MatrixXd products = this->Modes.transpose() * this->Modes;
  if (!this->Modes.allFinite() ||
      !(products - Eigen::MatrixXd::Identity(products.rows(), products.cols())).isZero(1e-4))
  {
    return Status::Failure("has modes that are not orthonormal");
  }
  if (!(this->Variances.minCoeff() > 0.0) || !(this->Variances.maxCoeff() < LargestScoreVariance) ||
      !(this->Rest.minCoeff() > 0.0) || !(this->Rest.maxCoeff() < LargestScoreVariance))
  {
    return Status::Failure("has variances that are none");
  }
  return this->Relation ? this->Relation->Check(this->Modes.cols() + 3) : Status::Success();
}

SurfaceDistribution SurfacePrior::About(const Vector3& clickWorld) const
{
  SurfaceDistribution made{this->Mean, clickWorld, {}};
  const Eigen::Index modes = this->Modes.cols();
  made.Covariance = Eigen::MatrixXd::Zero(modes + 3, modes + 3);
  made.Covariance.diagonal().head(modes) = this->Variances;
  made.Covariance.diagonal().tail<3>().setConstant(CentroidDeviation * CentroidDeviation);
  return made;
}

Status SurfacePrior::Given(const LogSurface& known, SurfaceDistribution& made) const
{
  if (!this->Relation)
  {
    return Status::Failure("the prior relates to no other organ");
  }
  Eigen::VectorXd expected;
  if (Status status = this->Relation->Predict(known, expected); !status.IsOk())
  {
    return status;
  }
  made.Mean = this->Mean + this->Modes * expected.head(this->Modes.cols());
  made.CentroidWorld = expected.tail<3>();
  made.Covariance = this->Relation->Covariance;
  return Status::Success();
}
} // namespace palpate
