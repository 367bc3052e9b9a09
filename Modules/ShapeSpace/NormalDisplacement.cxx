#include "NormalDisplacement.h"

#include "IcosahedronDirections.h"
#include "SphericalHarmonicBasis.h"

#include <cstddef>

namespace palpate
{
namespace
{
struct MovablePoint
{
  Vector3 Point;
  Vector3 Normal;
  /// By what a harmonic's value counts, for each series of coefficients.
  std::array<double, 3> Factors;
};

MovablePoint PointAt(const RadialModel& model, const Vector3& direction)
{
  const auto sample = model.EvaluateSecondOrder(direction);
  const Vector3 normal = (sample.Radius * direction - sample.SurfaceGradient).normalized();
  return {sample.Radius * direction, normal, {normal.dot(direction), 0.0, 0.0}};
}

MovablePoint PointAt(const SurfaceModel& surface, const Vector3& parameter)
{
  const Vector3 normal = surface.Normal(parameter);
  return {surface.Point(parameter), normal, {normal.x(), normal.y(), normal.z()}};
}

void AddPoints(const OrganModel& shape, const IcosahedronDirections& sphere,
               NormalDisplacement& result)
{
  const SphericalHarmonicBasis basis(DegreeOf(shape));
  const auto harmonics = static_cast<Eigen::Index>(basis.Size());
  const auto columns = static_cast<Eigen::Index>(CoefficientCountOf(shape));
  result.PerCoefficient.resize(static_cast<Eigen::Index>(sphere.Directions().size()), columns);
  Eigen::RowVectorXd values(harmonics);
  Eigen::Index row = 0;
  for (const Vector3& direction : sphere.Directions())
  {
    const MovablePoint point =
        std::visit([&](const auto& one) { return PointAt(one, direction); }, shape);
    basis.Evaluate(direction, values.data());
    for (Eigen::Index series = 0; series < columns / harmonics; ++series)
    {
      result.PerCoefficient.block(row, series * harmonics, 1, harmonics) =
          point.Factors[static_cast<std::size_t>(series)] * values;
    }
    result.Points.push_back(point.Point);
    result.Normals.push_back(point.Normal);
    ++row;
  }
}

void AddAreasAndEdges(NormalDisplacement& result)
{
  result.Areas.assign(result.Points.size(), 0.0);
  for (const std::array<int, 3>& triangle : result.Triangles)
  {
    const auto point = [&](std::size_t corner) -> const Vector3&
    { return result.Points[static_cast<std::size_t>(triangle[corner])]; };
    const double third = (point(1) - point(0)).cross(point(2) - point(0)).norm() / 6.0;
    for (std::size_t corner = 0; corner < 3; ++corner)
    {
      const int from = triangle[corner];
      const int to = triangle[(corner + 1) % 3];
      result.Areas[static_cast<std::size_t>(from)] += third;
      if (from < to) // the other triangle has it the other way round
      {
        result.Edges.emplace_back(from, to);
      }
    }
  }
}
} // namespace

NormalDisplacement FindNormalDisplacement(const OrganModel& shape, int frequency)
{
  const IcosahedronDirections sphere(frequency);
  NormalDisplacement result;
  result.Triangles = sphere.Triangles();
  AddPoints(shape, sphere, result);
  AddAreasAndEdges(result);
  return result;
}
} // namespace palpate
