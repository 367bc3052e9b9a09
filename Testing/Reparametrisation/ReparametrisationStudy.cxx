#include "ReparametrisationStudy.h"

#include "IcosahedronDirections.h"
#include "InputError.h"
#include "MeshDistances.h"
#include "ModelSurface.h"
#include "NearestOnMesh.h"
#include "ShapeModelQuality.h"
#include "ShapeVector.h"
#include "SphericalHarmonicBasis.h"
#include "SurfaceTessellation.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
constexpr int StudyFrequency = 12; // 1,442 points
constexpr int Searches = 8;
constexpr std::size_t Candidates = 8; // the nearest at equal parameters

IndexedMesh MeshOf(const OrganModel& surface)
{
  return Tessellated(std::get<SurfaceModel>(surface), IcosahedronDirections(StudyFrequency));
}

double RmsBetween(const OrganModel& one, const OrganModel& other)
{
  MeshDistances distances;
  const Status status = MeasureMeshDistances(MeshOf(one), MeshOf(other), distances);
  if (!status.IsOk())
  {
    throw InputError(status.Message());
  }
  return distances.Both.Rms;
}

// From a shape's coefficients to its coordinates at the points, x of all, then y, then z.
Eigen::MatrixXd Spread(const Eigen::MatrixXd& coefficients, const IcosahedronDirections& sphere)
{
  const Eigen::Index size = coefficients.rows() / 3;
  const auto points = static_cast<Eigen::Index>(sphere.Directions().size());
  int degree = 0;
  while ((degree + 1) * (degree + 1) < size)
  {
    ++degree;
  }
  const SphericalHarmonicBasis basis(degree);
  Eigen::MatrixXd harmonics(size, points);
  for (Eigen::Index k = 0; k < points; ++k)
  {
    basis.Evaluate(sphere.Directions()[static_cast<std::size_t>(k)], harmonics.col(k).data());
  }
  Eigen::MatrixXd spread(3 * points, coefficients.cols());
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    spread.middleRows(axis * points, points) =
        harmonics.transpose() * coefficients.middleRows(axis * size, size);
  }
  return spread;
}
} // namespace

ShapeModes ModesOf(const std::vector<OrganModel>& shapes)
{
  Eigen::MatrixXd matrix(static_cast<Eigen::Index>(shapes.size()), VectorOf(shapes.front()).size());
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    matrix.row(static_cast<Eigen::Index>(i)) = VectorOf(shapes[i]);
  }
  ShapeModes modes;
  const Status status = FindShapeModes(matrix, modes);
  if (!status.IsOk())
  {
    throw InputError(status.Message());
  }
  return modes;
}

double DistanceFromModel(const ShapeModes& modes, Eigen::Index count, const OrganModel& surface)
{
  count = std::min(count, modes.Modes.cols());
  const IcosahedronDirections sphere(StudyFrequency);
  const auto points = static_cast<Eigen::Index>(sphere.Directions().size());
  const Eigen::MatrixXd used = modes.Modes.leftCols(count);
  const Eigen::VectorXd mean = Spread(modes.Mean, sphere);
  const Eigen::MatrixXd spread = Spread(used, sphere);
  const IndexedMesh target = MeshOf(surface);
  NearestOnMesh nearest;
  if (!NearestOnMesh::Make(target, nearest).IsOk())
  {
    throw InputError("a surface has no triangles");
  }
  Eigen::VectorXd scores = used.transpose() * (VectorOf(surface) - modes.Mean);
  double least = std::numeric_limits<double>::infinity();
  for (int search = 0; search <= Searches; ++search)
  {
    if (search == 0 || search >= Searches - 1)
    {
      least = std::min(least, RmsBetween(ShapeFrom(modes.Mean + used * scores, surface), surface));
    }
    const Eigen::VectorXd shape = mean + spread * scores;
    Eigen::MatrixXd rows(points, count);
    Eigen::VectorXd left(points);
    for (Eigen::Index k = 0; k < points; ++k)
    {
      const Vector3 here(shape[k], shape[points + k], shape[2 * points + k]);
      const NearestOnMesh::Result found = nearest.Find(here);
      const std::array<int, 3>& t = target.Triangles[static_cast<std::size_t>(found.Triangle)];
      const auto corner = [&](int i) -> const Vector3&
      { return target.Points[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])]; };
      const Vector3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
      rows.row(k) = normal[0] * spread.row(k) + normal[1] * spread.row(points + k) +
                    normal[2] * spread.row(2 * points + k);
      left[k] = normal.dot(found.Point - here);
    }
    Eigen::MatrixXd normal = rows.transpose() * rows;
    normal.diagonal().array() += 1e-4 * normal.trace() / static_cast<double>(count);
    scores += normal.llt().solve(rows.transpose() * left);
  }
  return least;
}

double SpecificityOf(const ShapeModes& modes, Eigen::Index count,
                     const std::vector<OrganModel>& cases, int random)
{
  count = std::min(count, modes.Modes.cols());
  double sum = 0.0;
  for (int shape = 0; shape < random; ++shape)
  {
    const Eigen::VectorXd scores = RandomScores(modes, 1, static_cast<std::uint64_t>(shape));
    const Eigen::VectorXd values = modes.Mean + modes.Modes.leftCols(count) * scores.head(count);
    const OrganModel drawn = ShapeFrom(values, cases.front());
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < cases.size(); ++i)
    {
      order.emplace_back((VectorOf(cases[i]) - values).norm(), i);
    }
    std::sort(order.begin(), order.end());
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < std::min(Candidates, order.size()); ++k)
    {
      least = std::min(least, RmsBetween(drawn, cases[order[k].second]));
    }
    sum += least;
  }
  return sum / random;
}
} // namespace palpate
