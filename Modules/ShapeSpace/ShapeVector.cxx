#include "ShapeVector.h"

#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
Eigen::VectorXd SeriesVector(const std::vector<double>& series)
{
  return Eigen::Map<const Eigen::VectorXd>(series.data(), static_cast<Eigen::Index>(series.size()));
}
} // namespace

Eigen::VectorXd VectorOf(const OrganModel& shape)
{
  if (const auto* radial = std::get_if<RadialModel>(&shape))
  {
    return SeriesVector(radial->Coefficients());
  }
  const auto& surface = std::get<SurfaceModel>(shape);
  const auto count = static_cast<Eigen::Index>(surface.Coefficients(0).size());
  Eigen::VectorXd all(3 * count);
  for (int axis = 0; axis < 3; ++axis)
  {
    all.segment(axis * count, count) = SeriesVector(surface.Coefficients(axis));
  }
  return all;
}

double RmsOverSphere(const Eigen::Ref<const Eigen::VectorXd>& coefficients)
{
  return coefficients.norm() / std::sqrt(4.0 * M_PI);
}

OrganModel ShapeFrom(const Eigen::Ref<const Eigen::VectorXd>& values, const OrganModel& like)
{
  const int degree = DegreeOf(like);
  if (std::holds_alternative<RadialModel>(like))
  {
    return RadialModel(degree, std::vector<double>(values.data(), values.data() + values.size()),
                       Vector3::Zero());
  }
  const Eigen::Index count = values.size() / 3;
  const auto series = [&](Eigen::Index axis)
  {
    const double* first = values.data() + axis * count;
    return std::vector<double>(first, first + count);
  };
  return SurfaceModel(degree, {series(0), series(1), series(2)});
}

OrganModel MeanShape(const std::vector<OrganModel>& shapes)
{
  Eigen::VectorXd sum = VectorOf(shapes.front());
  for (std::size_t i = 1; i < shapes.size(); ++i)
  {
    sum += VectorOf(shapes[i]);
  }
  return ShapeFrom(sum / static_cast<double>(shapes.size()), shapes.front());
}

OrganModel WithDegree(const OrganModel& shape, int degree)
{
  return std::visit([degree](const auto& one) -> OrganModel { return one.WithDegree(degree); },
                    shape);
}
} // namespace palpate
