#include "ShapeSuperposition.h"

#include "ShapeVector.h"
#include "SingularValues.h"
#include "SphericalHarmonicProjection.h"
#include "SymmetricEigen.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace palpate
{
namespace
{
constexpr int MostTurns = 100;
constexpr double SmallestTurn = 1e-11; // rad
constexpr double LargestTurn = 0.5;    // rad
constexpr int MostTurnHalvings = 30;
// Curvatures below this fraction of the largest are rounding.
constexpr double SmallestCurvature = 1e-9;

std::vector<RadialModel> SeriesOf(const OrganModel& shape)
{
  if (const auto* radial = std::get_if<RadialModel>(&shape))
  {
    return {*radial};
  }
  const auto& surface = std::get<SurfaceModel>(shape);
  std::vector<RadialModel> series;
  for (int axis = 0; axis < 3; ++axis)
  {
    series.emplace_back(surface.Degree(), surface.Coefficients(axis), Vector3::Zero());
  }
  return series;
}

Matrix3 RotationBy(const Vector3& turn)
{
  const double angle = turn.norm();
  return angle > 0.0 ? Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix()
                     : Matrix3(Matrix3::Identity());
}

SphereRotation TurnedBy(const SphereRotation& rotation, const Eigen::VectorXd& turn)
{
  SphereRotation turned = rotation;
  turned.Parameters = RotationBy(turn.head<3>()) * rotation.Parameters;
  if (turn.size() > 3)
  {
    turned.Body = RotationBy(turn.tail<3>()) * rotation.Body;
  }
  return turned;
}

// Uphill in every direction, also where the product is not concave.
Eigen::VectorXd NewtonTurn(const Eigen::VectorXd& gradient, const Eigen::MatrixXd& hessian)
{
  const SymmetricEigen parts(hessian);
  const double largest = parts.Values.cwiseAbs().maxCoeff();
  Eigen::VectorXd turn = Eigen::VectorXd::Zero(gradient.size());
  for (Eigen::Index k = 0; k < gradient.size(); ++k)
  {
    const double curvature = std::abs(parts.Values[k]);
    if (curvature > SmallestCurvature * largest)
    {
      const auto direction = parts.Vectors.col(k);
      turn += direction * (direction.dot(gradient) / curvature);
    }
  }
  const double length = turn.norm();
  return length > LargestTurn ? Eigen::VectorXd(turn * (LargestTurn / length)) : turn;
}

// Columns: the derivatives of the point by the parameter, from the harmonics of degree 1, which are
// y, z and x up to a factor.
Matrix3 LinearPart(const OrganModel& shape)
{
  const auto& surface = std::get<SurfaceModel>(shape);
  Matrix3 linear = Matrix3::Zero();
  for (int axis = 0; axis < 3 && surface.Degree() > 0; ++axis)
  {
    const std::vector<double>& c = surface.Coefficients(axis);
    linear.row(axis) << c[3], c[1], c[2];
  }
  return linear;
}
} // namespace

OrganModel TurnShape(const OrganModel& shape, const SphereRotation& rotation)
{
  const Matrix3 back = rotation.Parameters.transpose();
  if (const auto* radial = std::get_if<RadialModel>(&shape))
  {
    const auto radius = [&](const Vector3& u) { return radial->Radius(back * u); };
    return RadialModel(radial->Degree(),
                       ProjectOnHarmonics(radial->Degree(), 2 * radial->Degree(), radius),
                       Vector3::Zero());
  }
  return std::get<SurfaceModel>(shape)
      .Transformed(rotation.Body, Vector3::Zero())
      .Reparametrized(back);
}

double AngleOf(const Matrix3& rotation)
{
  return Eigen::AngleAxisd(rotation).angle();
}

double RmsSizeOf(const OrganModel& shape)
{
  return RmsOverSphere(VectorOf(shape));
}

ShapeSuperposition::ShapeSuperposition(const OrganModel& target)
    : Sphere(2 * DegreeOf(target)),
      Weights(Eigen::Map<const Eigen::VectorXd>(Sphere.Weights.data(),
                                                static_cast<Eigen::Index>(Sphere.Weights.size()))),
      Target(FieldOf(SeriesOf(target), {})), Shape(target)
{
}

ShapeSuperposition::Field ShapeSuperposition::FieldOf(const std::vector<RadialModel>& series,
                                                      const SphereRotation& rotation) const
{
  const std::size_t count = this->Sphere.Directions.size();
  std::vector<Vector3> directions(count);
  std::transform(this->Sphere.Directions.begin(), this->Sphere.Directions.end(), directions.begin(),
                 [&](const Vector3& u) { return Vector3(rotation.Parameters.transpose() * u); });
  const auto rows = static_cast<Eigen::Index>(count);
  const auto columns = static_cast<Eigen::Index>(series.size());
  Field own{Eigen::MatrixXd(rows, columns), {}};
  std::vector<RadialModel::Sample> samples(count);
  for (Eigen::Index c = 0; c < columns; ++c)
  {
    series[static_cast<std::size_t>(c)].EvaluateBatch(directions.data(), count, samples.data());
    Eigen::MatrixXd turns(rows, 3);
    for (std::size_t i = 0; i < count; ++i)
    {
      const auto row = static_cast<Eigen::Index>(i);
      own.Values(row, c) = samples[i].Radius;
      // A turn about a moves f(u) to f(u - a x u).
      turns.row(row) =
          (rotation.Parameters * samples[i].SurfaceGradient.cross(directions[i])).transpose();
    }
    own.Turns.push_back(std::move(turns));
  }
  if (columns == 1)
  {
    return own;
  }
  Field turned{own.Values * rotation.Body.transpose(), {}};
  for (Eigen::Index c = 0; c < columns; ++c)
  {
    turned.Turns.emplace_back(rotation.Body(c, 0) * own.Turns[0] +
                              rotation.Body(c, 1) * own.Turns[1] +
                              rotation.Body(c, 2) * own.Turns[2]);
  }
  return turned;
}

ShapeSuperposition::Product ShapeSuperposition::ProductWith(const Field& field,
                                                            bool turnsBody) const
{
  const Eigen::Index columns = field.Values.cols();
  const Eigen::Index turns = columns == 1 || !turnsBody ? 3 : 6;
  Product product{0.0, Eigen::VectorXd::Zero(turns), Eigen::MatrixXd::Zero(turns, turns)};
  for (Eigen::Index c = 0; c < columns; ++c)
  {
    const auto k = static_cast<std::size_t>(c);
    const Eigen::VectorXd weighted = this->Weights.cwiseProduct(this->Target.Values.col(c));
    product.Value += weighted.dot(field.Values.col(c));
    product.Gradient.head<3>() += field.Turns[k].transpose() * weighted;
    const Eigen::Matrix3d mixed =
        this->Target.Turns[k].transpose() * this->Weights.asDiagonal() * field.Turns[k];
    product.Hessian.topLeftCorner<3, 3>() -= 0.5 * (mixed + mixed.transpose());
  }
  if (turns == 6)
  {
    this->AddBodyTurns(field, product);
  }
  return product;
}

void ShapeSuperposition::AddBodyTurns(const Field& field, Product& product) const
{
  // Of the products g m^T the antisymmetric part is g x m.
  const auto cross = [](const Eigen::Matrix3d& gm)
  { return Vector3(gm(1, 2) - gm(2, 1), gm(2, 0) - gm(0, 2), gm(0, 1) - gm(1, 0)); };
  const Eigen::MatrixXd weighted = this->Weights.asDiagonal() * this->Target.Values;
  const Eigen::Matrix3d products = field.Values.transpose() * weighted;
  product.Gradient.tail<3>() = cross(products);
  product.Hessian.bottomRightCorner<3, 3>() =
      0.5 * (products + products.transpose()) - product.Value * Eigen::Matrix3d::Identity();
  for (Eigen::Index a = 0; a < 3; ++a)
  {
    Eigen::Matrix3d turned;
    for (Eigen::Index c = 0; c < 3; ++c)
    {
      turned.row(c) = field.Turns[static_cast<std::size_t>(c)].col(a).transpose() * weighted;
    }
    product.Hessian.block<3, 1>(3, a) = cross(turned);
    product.Hessian.block<1, 3>(a, 3) = cross(turned).transpose();
  }
}

SuperposedShape ShapeSuperposition::Fit(const OrganModel& shape, const SphereRotation& start) const
{
  return this->Climb(shape, start, true);
}

SuperposedShape ShapeSuperposition::FitParameters(const OrganModel& shape,
                                                  const SphereRotation& start) const
{
  return this->Climb(shape, start, false);
}

SuperposedShape ShapeSuperposition::Climb(const OrganModel& shape, const SphereRotation& start,
                                          bool turnsBody) const
{
  const std::vector<RadialModel> series = SeriesOf(shape);
  SphereRotation rotation = start;
  Field field = this->FieldOf(series, rotation);
  Product product = this->ProductWith(field, turnsBody);
  for (int step = 0; step < MostTurns; ++step)
  {
    Eigen::VectorXd turn = NewtonTurn(product.Gradient, product.Hessian);
    bool isBetter = false;
    for (int halving = 0; halving < MostTurnHalvings && !isBetter && turn.norm() > SmallestTurn;
         ++halving, turn *= 0.5)
    {
      const SphereRotation next = TurnedBy(rotation, turn);
      Field nextField = this->FieldOf(series, next);
      Product nextProduct = this->ProductWith(nextField, turnsBody);
      isBetter = nextProduct.Value > product.Value;
      // The last turns change the product by less than its rounding, but still the gradient.
      const bool isEqual = nextProduct.Value > product.Value * (1.0 - 1e-14) &&
                           nextProduct.Gradient.norm() < 0.5 * product.Gradient.norm();
      if (isBetter || isEqual)
      {
        isBetter = true;
        rotation = next;
        field = std::move(nextField);
        product = std::move(nextProduct);
      }
    }
    if (!isBetter)
    {
      break;
    }
  }
  return this->Compare(field, rotation);
}

SuperposedShape ShapeSuperposition::Compare(const Field& field,
                                            const SphereRotation& rotation) const
{
  const auto rms = [&](double size)
  {
    const Eigen::MatrixXd difference = size * field.Values - this->Target.Values;
    return std::sqrt(this->Weights.dot(difference.rowwise().squaredNorm()) / (4.0 * M_PI));
  };
  const double product =
      this->Weights.dot(field.Values.cwiseProduct(this->Target.Values).rowwise().sum());
  const double square = this->Weights.dot(field.Values.rowwise().squaredNorm());
  return {rotation, rms(1.0), rms(square > 0.0 ? product / square : 1.0)};
}

SuperposedShape ShapeSuperposition::At(const OrganModel& shape,
                                       const SphereRotation& rotation) const
{
  return this->Compare(this->FieldOf(SeriesOf(shape), rotation), rotation);
}

SphereRotation ShapeSuperposition::StartFor(const OrganModel& shape, const Matrix3& body) const
{
  if (std::holds_alternative<RadialModel>(shape))
  {
    return {Matrix3::Identity(), body};
  }
  const Matrix3 product = LinearPart(this->Shape).transpose() * body * LinearPart(shape);
  const SingularValues parts = SingularValuesOf(product);
  const Vector3 signs(1.0, 1.0, parts.NearestOrthogonal().determinant() < 0.0 ? -1.0 : 1.0);
  return {body, parts.Left * signs.asDiagonal() * parts.Right.transpose()};
}
} // namespace palpate
