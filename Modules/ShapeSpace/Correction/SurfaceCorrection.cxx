#include "SurfaceCorrection.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
constexpr double KernelReach = 4.5; // widths: beyond, the displacement is below 5e-5 of the pull's
constexpr double PinReach = 9.0;    // widths: pins act on each other over several kernels
constexpr double ReleasedShare = 0.5; // of the width
constexpr double Ridge = 1e-6;        // against places that nearly coincide

double WidestOf(double width, double second)
{
  return std::max(width, second);
}

double GaussianOf(double square, double width)
{
  return std::exp(-0.5 * square / (width * width));
}

double KernelOf(const Vector3& a, const Vector3& wayOfA, const Vector3& b, const Vector3& wayOfB,
                double width, double second)
{
  const double square = (a - b).squaredNorm();
  const double reach = KernelReach * WidestOf(width, second);
  if (!(square < reach * reach))
  {
    return 0.0;
  }
  const double facing = 0.5 * (1.0 + wayOfA.dot(wayOfB));
  const double gaussian = second > 0.0
                              ? 0.5 * (GaussianOf(square, width) + GaussianOf(square, second))
                              : GaussianOf(square, width);
  return facing * gaussian;
}
} // namespace

SurfaceCorrection::SurfaceCorrection(std::vector<Vector3> points, std::vector<Vector3> directions,
                                     Motion motion)
    : Places(std::move(points)), Ways(std::move(directions)),
      Moved(Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(Places.size()))), Rule(motion)
{
}

Status SurfaceCorrection::Check(const SurfacePull& pull) const
{
  const auto isWidth = [](double width) { return width >= LeastWidth && width <= LargestWidth; };
  if (this->Places.empty())
  {
    return Status::Failure("there is no surface to pull");
  }
  if (this->List.size() >= MostPulls)
  {
    return Status::Failure("there are more than 1,000 pulls");
  }
  if (!pull.PlaceWorld.allFinite() || (pull.TargetWorld && !pull.TargetWorld->allFinite()) ||
      !(std::abs(pull.Displacement) <= LargestDisplacement))
  {
    return Status::Failure("a pull's place is not finite, or it is of more than 200 mm");
  }
  if (!isWidth(pull.Width) || (pull.SecondWidth != 0.0 && !isWidth(pull.SecondWidth)))
  {
    return Status::Failure("a pull's width is not from 0.5 to 200 mm");
  }
  return Status::Success();
}

Vector3 SurfaceCorrection::PointNow(std::size_t number) const
{
  return this->Places[number] + this->Moved.col(static_cast<Eigen::Index>(number));
}

std::size_t SurfaceCorrection::NearestNow(const Vector3& place) const
{
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < this->Places.size(); ++n)
  {
    const double square = (this->PointNow(n) - place).squaredNorm();
    if (square < least)
    {
      least = square;
      nearest = n;
    }
  }
  return nearest;
}

SurfaceCorrection::Field SurfaceCorrection::FieldOf(const SurfacePull& pull) const
{
  const std::size_t pulled = this->NearestNow(pull.PlaceWorld);
  Field field{pull.Width, pull.SecondWidth, pull.Displacement * this->Ways[pulled], {pulled}, {}};
  if (pull.TargetWorld)
  {
    field.Along = *pull.TargetWorld - this->PointNow(pulled);
    field.Along *= std::min(1.0, LargestDisplacement / std::max(field.Along.norm(), 1.0));
  }
  const double widest = WidestOf(pull.Width, pull.SecondWidth);
  const double narrowest =
      pull.SecondWidth > 0.0 ? std::min(pull.Width, pull.SecondWidth) : pull.Width;
  for (const Field& former : this->Fields)
  {
    const std::size_t center = former.Centers.front();
    const double distance = (this->Places[center] - this->Places[pulled]).norm();
    if (distance >= ReleasedShare * narrowest && distance < PinReach * widest &&
        std::find(field.Centers.begin(), field.Centers.end(), center) == field.Centers.end())
    {
      field.Centers.push_back(center);
    }
  }
  const auto count = static_cast<Eigen::Index>(field.Centers.size());
  Eigen::MatrixXd kernel(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    for (Eigen::Index j = 0; j < count; ++j)
    {
      const std::size_t a = field.Centers[static_cast<std::size_t>(i)];
      const std::size_t b = field.Centers[static_cast<std::size_t>(j)];
      kernel(i, j) = KernelOf(this->Places[a], this->Ways[a], this->Places[b], this->Ways[b],
                              pull.Width, pull.SecondWidth);
    }
  }
  kernel.diagonal().array() += Ridge;
  field.Weights = kernel.ldlt().solve(Eigen::VectorXd::Unit(count, 0));
  return field;
}

Vector3 SurfaceCorrection::ValueOf(const Field& field, const Vector3& point,
                                   const Vector3& direction) const noexcept
{
  double sum = 0.0;
  for (std::size_t i = 0; i < field.Centers.size(); ++i)
  {
    const std::size_t center = field.Centers[i];
    sum += field.Weights[static_cast<Eigen::Index>(i)] *
           KernelOf(point, direction, this->Places[center], this->Ways[center], field.Width,
                    field.SecondWidth);
  }
  return this->Rule == Motion::AlongDirections
             ? Vector3(sum * field.Along.dot(direction) * direction)
             : Vector3(sum * field.Along);
}

void SurfaceCorrection::Add(const Field& field, Eigen::Matrix3Xd& displacements) const noexcept
{
  for (std::size_t n = 0; n < this->Places.size(); ++n)
  {
    displacements.col(static_cast<Eigen::Index>(n)) +=
        this->ValueOf(field, this->Places[n], this->Ways[n]);
  }
}

Status SurfaceCorrection::Preview(const SurfacePull& pull, Eigen::Matrix3Xd& displacements) const
{
  const Status status = this->Check(pull);
  if (status.IsOk())
  {
    displacements = this->Moved;
    this->Add(this->FieldOf(pull), displacements);
  }
  return status;
}

Status SurfaceCorrection::Pull(const SurfacePull& pull)
{
  const Status status = this->Check(pull);
  if (status.IsOk())
  {
    Field field = this->FieldOf(pull);
    this->Add(field, this->Moved);
    this->Fields.push_back(std::move(field));
    this->List.push_back(pull);
  }
  return status;
}

void SurfaceCorrection::Undo()
{
  if (this->List.empty())
  {
    return;
  }
  this->List.pop_back();
  this->Fields.pop_back();
  // Again from the start, since a difference would not have the same bits.
  this->Moved.setZero();
  for (const Field& field : this->Fields)
  {
    this->Add(field, this->Moved);
  }
}

Vector3 SurfaceCorrection::DisplacementAt(const Vector3& point,
                                          const Vector3& direction) const noexcept
{
  Vector3 sum = Vector3::Zero();
  for (const Field& field : this->Fields)
  {
    sum += this->ValueOf(field, point, direction);
  }
  return sum;
}
} // namespace palpate
