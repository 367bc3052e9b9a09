#include "TouchEquations.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double LeastDistance = 1e-3; // mm, of a point from the centre, which has no direction

Matrix3 CrossMatrix(const Vector3& a)
{
  Matrix3 matrix;
  matrix << 0.0, -a[2], a[1], a[2], 0.0, -a[0], -a[1], a[0], 0.0;
  return matrix;
}
} // namespace

// A touch seen from the centre.
struct TouchEquations::Place
{
  Vector3 Direction;   // u
  double Distance;     // r, mm
  double Excess;       // ln r - f(u)
  Vector3 Normal;      // v / |v|
  double Slant;        // |v|
  Matrix3 NormalSlope; // of v by the centre
};

TouchEquations::TouchEquations(int degree)
    : Basis(degree), Turns(degree), Harmonics(static_cast<Eigen::Index>(Basis.Size())),
      Turned(Harmonics.size())
{
  std::fill(this->First.begin(), this->First.end(), this->Harmonics);
  std::fill(this->Second.begin(), this->Second.end(), this->Harmonics);
  this->SetTouches({});
}

void TouchEquations::SetTouches(const std::vector<SurfaceTouch>& touches)
{
  this->Touches = touches;
  this->StrokeOf.clear();
  Eigen::Index rows = 0;
  for (const SurfaceTouch& touch : touches)
  {
    rows += touch.Normal && !touch.IsOutside ? 3 : 1;
  }
  this->Values.resize(rows);
  this->Variances.resize(rows);
  this->Weighted.resize(rows);
  this->Slopes.resize(this->Harmonics.size(), rows);
  this->CenterSlopes.resize(3, rows);
  std::vector<int> numbers;
  Eigen::Index row = 0;
  for (const SurfaceTouch& touch : touches)
  {
    const bool isOfStroke = touch.Stroke > 0 && !touch.IsOutside;
    const auto found = std::find(numbers.begin(), numbers.end(), touch.Stroke);
    this->StrokeOf.push_back(isOfStroke ? static_cast<int>(found - numbers.begin()) : -1);
    if (isOfStroke && found == numbers.end())
    {
      numbers.push_back(touch.Stroke);
    }
    this->Variances[row++] = touch.Deviation * touch.Deviation + ModelDeviation * ModelDeviation;
    for (int tangent = 0; touch.Normal && !touch.IsOutside && tangent < 2; ++tangent)
    {
      this->Variances[row++] = NormalDeviation * NormalDeviation;
      this->StrokeOf.push_back(-1);
    }
  }
  this->StrokeCount = static_cast<Eigen::Index>(numbers.size());
}

void TouchEquations::PrepareDerivatives(const LogSurface& surface) noexcept
{
  for (std::size_t k = 0; k < 3; ++k)
  {
    const Vector3 axis = Vector3::Unit(static_cast<Eigen::Index>(k));
    this->Turns.Turn(axis, surface.Coefficients.data(), this->First[k].data());
  }
  for (std::size_t k = 0; k < 9; ++k)
  {
    const Vector3 axis = Vector3::Unit(static_cast<Eigen::Index>(k % 3));
    this->Turns.Turn(axis, this->First[k / 3].data(), this->Second[k].data());
  }
}

TouchEquations::Place TouchEquations::PlaceOf(const SurfaceTouch& touch,
                                              const LogSurface& surface) noexcept
{
  Place place;
  const Vector3 arm = touch.PointWorld - surface.CenterWorld;
  place.Distance = arm.norm();
  place.Direction = Vector3::UnitZ();
  if (place.Distance > LeastDistance)
  {
    place.Direction = arm / place.Distance;
  }
  place.Distance = std::max(place.Distance, LeastDistance);
  const Vector3& u = place.Direction;
  this->Basis.Evaluate(u, this->Harmonics.data());
  place.Excess = std::log(place.Distance) - surface.Coefficients.dot(this->Harmonics);
  Vector3 turn;
  Matrix3 bend; // of the turns, by a turn of the direction
  for (Eigen::Index k = 0; k < 3; ++k)
  {
    turn[k] = this->First[static_cast<std::size_t>(k)].dot(this->Harmonics);
    for (Eigen::Index j = 0; j < 3; ++j)
    {
      bend(k, j) = this->Second[static_cast<std::size_t>(3 * k + j)].dot(this->Harmonics);
    }
  }
  const Vector3 v = u + u.cross(turn);
  place.Slant = v.norm();
  place.Normal = v / place.Slant;
  const Matrix3 cross = CrossMatrix(u);
  const Matrix3 byDirection = Matrix3::Identity() - CrossMatrix(turn) + cross * bend * cross;
  place.NormalSlope = byDirection * (u * u.transpose() - Matrix3::Identity()) / place.Distance;
  return place;
}

void TouchEquations::PointRow(const Place& place, Eigen::Index row) noexcept
{
  const double scale = place.Distance / place.Slant;
  this->Values[row] = scale * place.Excess;
  const double bent = scale * place.Excess / place.Slant; // as |v| changes
  const Vector3& n = place.Normal;
  this->Turns.Turn(-bent * place.Direction.cross(n), this->Harmonics.data(), this->Turned.data());
  this->Slopes.col(row) = this->Turned - scale * this->Harmonics;
  this->CenterSlopes.col(row) =
      -n - place.Excess / place.Slant * place.Direction - bent * place.NormalSlope.transpose() * n;
}

void TouchEquations::TangentRow(const Place& place, const Vector3& tangent,
                                Eigen::Index row) noexcept
{
  this->Values[row] = tangent.dot(place.Normal);
  const Vector3 part = (tangent - this->Values[row] * place.Normal) / place.Slant;
  this->Turns.Turn(place.Direction.cross(part), this->Harmonics.data(), this->Turned.data());
  this->Slopes.col(row) = this->Turned;
  this->CenterSlopes.col(row) = place.NormalSlope.transpose() * part;
}

void TouchEquations::Evaluate(const LogSurface& surface) noexcept
{
  this->PrepareDerivatives(surface);
  Eigen::Index row = 0;
  for (const SurfaceTouch& touch : this->Touches)
  {
    const Place place = this->PlaceOf(touch, surface);
    this->PointRow(place, row);
    if (touch.IsOutside && this->Values[row] > 0.0)
    {
      this->Values[row] = 0.0;
      this->Slopes.col(row).setZero();
      this->CenterSlopes.col(row).setZero();
    }
    ++row;
    if (touch.Normal && !touch.IsOutside)
    {
      const Vector3 tangent = touch.Normal->unitOrthogonal();
      this->TangentRow(place, tangent, row++);
      this->TangentRow(place, touch.Normal->normalized().cross(tangent), row++);
    }
  }
  this->Weigh();
}

void TouchEquations::AddCovariance(Eigen::MatrixXd& matrix) const noexcept
{
  matrix.diagonal() += this->Variances;
  for (Eigen::Index i = 0; i < this->Rows(); ++i)
  {
    for (Eigen::Index j = 0; this->StrokeOf[static_cast<std::size_t>(i)] >= 0 && j < this->Rows();
         ++j)
    {
      const bool isOfStroke = this->StrokeOf[static_cast<std::size_t>(i)] ==
                              this->StrokeOf[static_cast<std::size_t>(j)];
      matrix(i, j) += isOfStroke ? StrokeDeviation * StrokeDeviation : 0.0;
    }
  }
}

// The inverse of a diagonal plus an offset in common: Sherman and Morrison.
void TouchEquations::Weigh() noexcept
{
  this->Weighted = this->Values.cwiseQuotient(this->Variances);
  for (Eigen::Index stroke = 0; stroke < this->StrokeCount; ++stroke)
  {
    double sum = 0.0;
    double weight = 1.0 / (StrokeDeviation * StrokeDeviation);
    for (Eigen::Index row = 0; row < this->Rows(); ++row)
    {
      const bool isOfIt = this->StrokeOf[static_cast<std::size_t>(row)] == stroke;
      sum += isOfIt ? this->Weighted[row] : 0.0;
      weight += isOfIt ? 1.0 / this->Variances[row] : 0.0;
    }
    for (Eigen::Index row = 0; row < this->Rows(); ++row)
    {
      const bool isOfIt = this->StrokeOf[static_cast<std::size_t>(row)] == stroke;
      this->Weighted[row] -= isOfIt ? sum / (weight * this->Variances[row]) : 0.0;
    }
  }
}

double TouchEquations::Distance() const noexcept
{
  double sum = 0.0;
  double count = 0.0;
  Eigen::Index row = 0;
  for (const SurfaceTouch& touch : this->Touches)
  {
    sum += touch.IsOutside ? 0.0 : this->Values[row] * this->Values[row];
    count += touch.IsOutside ? 0.0 : 1.0;
    row += touch.Normal && !touch.IsOutside ? 3 : 1;
  }
  return count > 0.0 ? std::sqrt(sum / count) : 0.0;
}
} // namespace palpate
