#include "SurfaceCompletion.h"

#include "DecimalText.h"
#include "DeviationMap.h"
#include "HarmonicTurns.h"
#include "IcosahedronDirections.h"
#include "ShapeVector.h"
#include "SphericalHarmonicBasis.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace palpate
{
namespace
{
constexpr int MostRounds = 15;
constexpr double LeastMove = 5e-3;   // mm: the last round
constexpr double LeastNormal = 1e-9; // mm^2
constexpr int DesignFrequency = 6;   // 362 candidates

Eigen::MatrixXd HarmonicsAt(const std::vector<Vector3>& parameters, int degree)
{
  const SphericalHarmonicBasis basis(degree);
  Eigen::MatrixXd made(static_cast<Eigen::Index>(basis.Size()),
                       static_cast<Eigen::Index>(parameters.size()));
  for (std::size_t n = 0; n < parameters.size(); ++n)
  {
    basis.Evaluate(parameters[n], made.col(static_cast<Eigen::Index>(n)).data());
  }
  return made;
}

// Of corners, by the areas of their triangles.
Eigen::Matrix3Xd NormalsOf(const Eigen::Matrix3Xd& points,
                           const std::vector<std::array<int, 3>>& triangles)
{
  Eigen::Matrix3Xd normals = Eigen::Matrix3Xd::Zero(3, points.cols());
  for (const std::array<int, 3>& corner : triangles)
  {
    const Vector3 first = points.col(corner[0]);
    const Vector3 area = (points.col(corner[1]) - first).cross(points.col(corner[2]) - first);
    for (const int at : corner)
    {
      normals.col(at) += area;
    }
  }
  for (Eigen::Index n = 0; n < normals.cols(); ++n)
  {
    normals.col(n) /= std::max(normals.col(n).norm(), LeastNormal);
  }
  return normals;
}

Eigen::Matrix3Xd PointsOf(const Eigen::VectorXd& coefficients, const Eigen::MatrixXd& harmonics,
                          const Vector3& centroid)
{
  const Eigen::Map<const Eigen::MatrixX3d> axes(coefficients.data(), harmonics.rows(), 3);
  Eigen::Matrix3Xd points(3, harmonics.cols());
  points.noalias() = axes.transpose() * harmonics;
  points.colwise() += centroid;
  return points;
}
// Of corners: a third of their triangles.
Eigen::VectorXd AreasOf(const Eigen::Matrix3Xd& points,
                        const std::vector<std::array<int, 3>>& triangles)
{
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(points.cols());
  for (const std::array<int, 3>& corner : triangles)
  {
    const Vector3 first = points.col(corner[0]);
    const Vector3 area = (points.col(corner[1]) - first).cross(points.col(corner[2]) - first);
    for (const int at : corner)
    {
      areas[at] += area.norm() / 6.0;
    }
  }
  return areas;
}
} // namespace

SurfaceCompletion::SurfaceCompletion(std::shared_ptr<const SurfacePrior> prior,
                                     SurfaceDistribution before)
    : Given(prior), Found(std::move(prior), std::move(before))
{
  const IcosahedronDirections sphere(PlaceFrequency);
  this->Parameters = sphere.Directions();
  this->Triangles = sphere.Triangles();
  this->Harmonics = HarmonicsAt(this->Parameters, this->Given->Degree);
  this->WallHarmonics = HarmonicsAt(
      IcosahedronDirections(OrganRelation::WallFrequency).Directions(), this->Given->Degree);
  this->Draw();
}

SurfaceCompletion::SurfaceCompletion(std::shared_ptr<const SurfacePrior> prior,
                                     const Vector3& clickWorld)
    : SurfaceCompletion(prior, prior->About(clickWorld))
{
}

Status SurfaceCompletion::WithKnown(std::shared_ptr<const SurfacePrior> prior,
                                    const LogSurface& known,
                                    std::unique_ptr<SurfaceCompletion>& made)
{
  SurfaceDistribution before;
  Status status = prior->Given(known, before);
  if (status.IsOk())
  {
    made.reset(new SurfaceCompletion(std::move(prior), std::move(before)));
    made->Wall.emplace(known);
    status = made->Update({});
  }
  return status;
}

void SurfaceCompletion::Draw()
{
  this->Points = PointsOf(this->Found.Coefficients(), this->Harmonics, this->Found.CentroidWorld());
  this->Normals = NormalsOf(this->Points, this->Triangles);
}

Eigen::Index SurfaceCompletion::NearestTo(const SurfaceTouch& touch) const
{
  Eigen::RowVectorXd squares = (this->Points.colwise() - touch.PointWorld).colwise().squaredNorm();
  if (touch.Normal)
  {
    const Vector3 normal = touch.Normal->normalized();
    squares.array() +=
        (NormalWeight * (1.0 - (normal.transpose() * this->Normals).array())).square();
  }
  Eigen::Index nearest = 0;
  squares.minCoeff(&nearest);
  return nearest;
}

void SurfaceCompletion::MatchTouches()
{
  this->PlaceOf.clear();
  for (const SurfaceTouch& touch : this->Touches)
  {
    const Eigen::Index place = this->NearestTo(touch);
    const bool isBeyond = touch.IsOutside && this->Normals.col(place).dot(
                                                 touch.PointWorld - this->Points.col(place)) >= 0.0;
    this->PlaceOf.push_back(isBeyond ? -1 : place); // -1: a point outside that is outside
  }
}

void SurfaceCompletion::AddPoint(std::size_t touch, Eigen::Index& row)
{
  const Eigen::Index place = this->PlaceOf[touch];
  const Vector3 normal = this->Normals.col(place);
  this->Observed.Harmonics.col(row) = this->Harmonics.col(place);
  this->Observed.Axes.col(row) = normal;
  this->Observed.Moves[row] = 1.0;
  this->Measured[row] = normal.dot(this->Touches[touch].PointWorld);
  const double left = TouchEquations::ModelDeviation;
  this->Uncertainty(row, row) = std::pow(this->Touches[touch].Deviation, 2) + left * left;
  ++row;
}

// The touch's normal is perpendicular to both tangents, in units of their lengths.
void SurfaceCompletion::AddTangents(std::size_t touch, Eigen::Index& row)
{
  const Eigen::Index place = this->PlaceOf[touch];
  const HarmonicTurns turns(this->Given->Degree);
  const Vector3& u = this->Parameters[static_cast<std::size_t>(place)];
  const Vector3 first = u.unitOrthogonal();
  const Vector3 normal = this->Touches[touch].Normal->normalized();
  for (const Vector3& along : {first, Vector3(u.cross(first))})
  {
    // The derivative of a harmonic along a tangent a is -(u x a) . (u x grad) of its coefficients.
    auto slopes = this->Observed.Harmonics.col(row);
    turns.Turn(-u.cross(along), this->Harmonics.col(place).data(), slopes.data());
    const Eigen::VectorXd& all = this->Found.Coefficients();
    const Eigen::Map<const Eigen::MatrixX3d> axes(all.data(), slopes.size(), 3);
    const double length = std::max((axes.transpose() * slopes).norm(), 1e-3);
    this->Observed.Axes.col(row) = normal / length;
    this->Observed.Moves[row] = 0.0;
    this->Measured[row] = 0.0;
    this->Uncertainty(row, row) = TouchEquations::NormalDeviation * TouchEquations::NormalDeviation;
    ++row;
  }
}

// The distances from the other organ, to first order about the surface as it is.
void SurfaceCompletion::AddWalls(Eigen::Index& row)
{
  const Eigen::Matrix3Xd points =
      PointsOf(this->Found.Coefficients(), this->WallHarmonics, this->Found.CentroidWorld());
  this->Wall->Evaluate(points);
  const Eigen::Matrix3Xd gradients = this->Wall->Gradients();
  const Eigen::Index count = points.cols();
  this->Observed.Harmonics.middleCols(row, count) = this->WallHarmonics;
  this->Observed.Axes.middleCols(row, count) = gradients;
  this->Observed.Moves.segment(row, count).setOnes();
  this->Measured.segment(row, count) = this->Given->Relation->WallMean - this->Wall->Values() +
                                       gradients.cwiseProduct(points).colwise().sum().transpose();
  this->Uncertainty.block(row, row, count, count) =
      WallFactor * WallFactor * this->Given->Relation->WallCovariance;
  row += count;
}

void SurfaceCompletion::AddStrokes(const std::vector<Eigen::Index>& rowOf)
{
  const double variance = TouchEquations::StrokeDeviation * TouchEquations::StrokeDeviation;
  for (std::size_t i = 0; i < rowOf.size(); ++i)
  {
    for (std::size_t j = 0; j < rowOf.size(); ++j)
    {
      const SurfaceTouch& one = this->Touches[i];
      const bool isShared = one.Stroke > 0 && one.Stroke == this->Touches[j].Stroke &&
                            !one.IsOutside && !this->Touches[j].IsOutside;
      if (isShared)
      {
        this->Uncertainty(rowOf[i], rowOf[j]) += variance;
      }
    }
  }
}

void SurfaceCompletion::Observe()
{
  this->MatchTouches();
  Eigen::Index count = this->Wall ? this->WallHarmonics.cols() : 0;
  for (std::size_t n = 0; n < this->Touches.size(); ++n)
  {
    const bool hasTangents = this->Touches[n].Normal && !this->Touches[n].IsOutside;
    count += this->PlaceOf[n] < 0 ? 0 : hasTangents ? 3 : 1;
  }
  this->Observed.Resize(this->Harmonics.rows(), count);
  this->Measured.resize(count);
  this->Uncertainty = Eigen::MatrixXd::Zero(count, count);
  std::vector<Eigen::Index> rowOf(this->Touches.size(), 0);
  Eigen::Index row = 0;
  for (std::size_t n = 0; n < this->Touches.size(); ++n)
  {
    rowOf[n] = row;
    if (this->PlaceOf[n] >= 0)
    {
      this->AddPoint(n, row);
      if (this->Touches[n].Normal && !this->Touches[n].IsOutside)
      {
        this->AddTangents(n, row);
      }
    }
  }
  this->AddStrokes(rowOf);
  if (this->Wall)
  {
    this->AddWalls(row);
  }
}

void SurfaceCompletion::MeasureDistance()
{
  double sum = 0.0;
  double count = 0.0;
  for (const SurfaceTouch& touch : this->Touches)
  {
    const Eigen::Index place = this->NearestTo(touch);
    const double distance =
        this->Normals.col(place).dot(touch.PointWorld - this->Points.col(place));
    sum += touch.IsOutside ? 0.0 : distance * distance;
    count += touch.IsOutside ? 0.0 : 1.0;
  }
  this->TouchDistance = count > 0.0 ? std::sqrt(sum / count) : 0.0;
}

Status SurfaceCompletion::Update(const std::vector<SurfaceTouch>& touches)
{
  if (Status status = CheckTouches(touches, this->Found.CentroidWorld()); !status.IsOk())
  {
    return status;
  }
  this->Touches = touches;
  this->RoundCount = 0;
  double move = 1.0;
  while (this->RoundCount < MostRounds && move > LeastMove)
  {
    const Eigen::VectorXd before = this->Found.Coefficients();
    const Vector3 centroid = this->Found.CentroidWorld();
    this->Observe();
    this->Found.Condition(this->Observed, this->Measured, this->Uncertainty);
    move = RmsOverSphere(this->Found.Coefficients() - before) +
           (this->Found.CentroidWorld() - centroid).norm();
    this->Draw();
    ++this->RoundCount;
  }
  this->MeasureDistance();
  return Status::Success();
}

SurfaceModel SurfaceCompletion::Model() const
{
  const Eigen::VectorXd& all = this->Found.Coefficients();
  const Eigen::Index count = all.size() / 3;
  std::array<std::vector<double>, 3> axes;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    const auto part = all.segment(axis * count, count);
    axes[static_cast<std::size_t>(axis)] = {part.begin(), part.end()};
  }
  return SurfaceModel(this->Given->Degree, axes)
      .Transformed(Matrix3::Identity(), this->Found.CentroidWorld());
}

double SurfaceCompletion::LargestDistance() const noexcept
{
  return 1.2 * ExpectedDistance(this->Touches) + TouchEquations::ModelDeviation;
}

Status SurfaceCompletion::Judge() const
{
  if (this->Distance() <= this->LargestDistance())
  {
    return Status::Success();
  }
  return Status::Failure("the touched points are " + FixedText(this->Distance(), 2) +
                         " mm (RMS) from any likely surface, more than " +
                         FixedText(this->LargestDistance(), 2) +
                         ": the organ is unlike those of the prior, or points are not on it");
}

Eigen::VectorXd SurfaceCompletion::Deviations(int frequency) const
{
  const IcosahedronDirections sphere(frequency);
  SurfaceRows rows;
  rows.Harmonics = HarmonicsAt(sphere.Directions(), this->Given->Degree);
  const Eigen::Matrix3Xd points =
      PointsOf(this->Found.Coefficients(), rows.Harmonics, this->Found.CentroidWorld());
  rows.Axes = NormalsOf(points, sphere.Triangles());
  rows.Moves = Eigen::RowVectorXd::Ones(points.cols());
  return (this->Found.Variances(rows).array().max(0.0) + LeftOut * LeftOut).sqrt();
}

std::vector<Vector3> SurfaceCompletion::NextTouches(int count) const
{
  const IcosahedronDirections sphere(DesignFrequency);
  SurfaceRows rows;
  rows.Harmonics = HarmonicsAt(sphere.Directions(), this->Given->Degree);
  const Eigen::Matrix3Xd points =
      PointsOf(this->Found.Coefficients(), rows.Harmonics, this->Found.CentroidWorld());
  rows.Axes = NormalsOf(points, sphere.Triangles());
  rows.Moves = Eigen::RowVectorXd::Ones(points.cols());
  std::vector<Vector3> places;
  for (const Eigen::Index best :
       ChooseTouches(this->Found.Covariance(rows), AreasOf(points, sphere.Triangles()), count))
  {
    places.emplace_back(points.col(best));
  }
  return places;
}
} // namespace palpate
