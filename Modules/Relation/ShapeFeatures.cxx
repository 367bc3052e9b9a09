#include "ShapeFeatures.h"

#include "ConvexHull.h"
#include "PointDiameter.h"
#include "SurfaceTopology.h"
#include "Units.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace palpate
{
namespace
{
// The manual's sum for an ellipsoid with semi-axes a >= b >= c. It is less than the ellipsoid's
// area, by 4 % in the digital phantom, but the feature of this name and its reference values are
// made of it. Powers of x y times Legendre's polynomials of (x x + y y) / (2 x y), by recurrence.
double EnclosingArea(double a, double b, double c)
{
  const double one = 1.0 - b * b / (a * a);
  const double other = 1.0 - c * c / (a * a);
  constexpr int Terms = 20; // as the manual
  double before = 0.0;
  double term = 1.0;
  double sum = 0.0;
  for (int n = 0; n <= Terms; ++n)
  {
    sum += term / (1.0 - 4.0 * n * n);
    const double next =
        ((2 * n + 1) * 0.5 * (one + other) * term - n * one * other * before) / (n + 1);
    before = term;
    term = next;
  }
  return 4.0 * Pi * a * b * sum;
}

Eigen::AlignedBox3d BoxAround(const IndexedMesh& mesh)
{
  Eigen::AlignedBox3d box;
  for (const Vector3& point : mesh.Points)
  {
    box.extend(point);
  }
  return box;
}

// Compactness and what else compares area and volume with a sphere's.
void AddRoundness(double volume, double area, std::vector<ShapeFeature>& features)
{
  const double cubes = 36.0 * Pi * volume * volume;
  const double quotient = area * area * area / cubes; // 1 of a sphere
  features.insert(
      features.end(),
      {{"surface_to_volume_ratio", "Surface to volume ratio", "2PR5", "1/mm", area / volume},
       {"compactness_1", "Compactness 1", "SKGS", "", volume / std::sqrt(Pi * area * area * area)},
       {"compactness_2", "Compactness 2", "BQWJ", "", 1.0 / quotient},
       {"spherical_disproportion", "Spherical disproportion", "KRCK", "", std::cbrt(quotient)},
       {"sphericity", "Sphericity", "QCFX", "", 1.0 / std::cbrt(quotient)},
       {"asphericity", "Asphericity", "25C7", "", std::cbrt(quotient) - 1.0}});
}

void AddDensities(const IndexedMesh& mesh, const Vector3& lengths, double volume, double area,
                  std::vector<ShapeFeature>& features)
{
  const Vector3 box = BoxAround(mesh).sizes();
  const double boxArea = 2.0 * (box[0] * box[1] + box[1] * box[2] + box[2] * box[0]);
  const double ellipsoid = Pi / 6.0 * lengths.prod();
  const double ellipsoidArea = EnclosingArea(0.5 * lengths[0], 0.5 * lengths[1], 0.5 * lengths[2]);
  const EnclosedMeasure hull = MeasureEnclosed(ConvexHullOf(mesh.Points));
  features.insert(
      features.end(),
      {{"volume_density_aabb", "Volume density (axis-aligned bounding box)", "PBX1", "",
        volume / box.prod()},
       {"area_density_aabb", "Area density (axis-aligned bounding box)", "R59B", "",
        area / boxArea},
       {"volume_density_aee", "Volume density (approximate enclosing ellipsoid)", "6BDE", "",
        volume / ellipsoid},
       {"area_density_aee", "Area density (approximate enclosing ellipsoid)", "RDD2", "",
        area / ellipsoidArea},
       {"volume_density_convex_hull", "Volume density (convex hull)", "R3ER", "",
        volume / hull.Volume},
       {"area_density_convex_hull", "Area density (convex hull)", "7T7F", "", area / hull.Area}});
}
} // namespace

PointSpread PointSpread::OfInside(const IndexedMesh& mesh)
{
  if (mesh.Points.empty())
  {
    return {};
  }
  // Tetrahedra from one point: the integral of x x^T is volume / 20 times (s s^T + sum of p p^T).
  const Vector3 origin = BoxAround(mesh).center();
  double volume = 0.0;
  Vector3 moment = Vector3::Zero();
  Matrix3 second = Matrix3::Zero();
  for (const auto& [i, j, k] : mesh.Triangles)
  {
    const Vector3 a = mesh.Points[i] - origin;
    const Vector3 b = mesh.Points[j] - origin;
    const Vector3 c = mesh.Points[k] - origin;
    const double part = a.dot(b.cross(c)) / 6.0;
    const Vector3 sum = a + b + c;
    volume += part;
    moment += part / 4.0 * sum;
    second += part / 20.0 *
              (sum * sum.transpose() + a * a.transpose() + b * b.transpose() + c * c.transpose());
  }
  const Vector3 mean = moment / volume;
  return {origin + mean, second / volume - mean * mean.transpose()};
}

PointSpread PointSpread::OfPoints(const std::vector<Vector3>& points)
{
  PointSpread spread;
  for (const Vector3& point : points)
  {
    spread.Mean += point / static_cast<double>(points.size());
  }
  for (const Vector3& point : points)
  {
    const Vector3 off = point - spread.Mean;
    spread.Covariance += off * off.transpose() / static_cast<double>(points.size() - 1);
  }
  return spread;
}

Matrix3 PointSpread::Axes(Vector3* lengths) const
{
  const Eigen::SelfAdjointEigenSolver<Matrix3> solver(this->Covariance);
  if (lengths != nullptr)
  {
    *lengths = 4.0 * solver.eigenvalues().cwiseMax(0.0).cwiseSqrt().reverse();
  }
  Matrix3 axes = solver.eigenvectors().rowwise().reverse();
  for (int axis = 0; axis < 2; ++axis)
  {
    Eigen::Index largest = 0;
    axes.col(axis).cwiseAbs().maxCoeff(&largest);
    axes.col(axis) *= axes(largest, axis) < 0.0 ? -1.0 : 1.0;
  }
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

Status MeasureShapeFeatures(const IndexedMesh& mesh, const PointSpread& spread,
                            std::vector<ShapeFeature>& features)
{
  const auto [volume, area] = MeasureEnclosed(mesh);
  if (!(volume > 0.0) || !std::isfinite(volume))
  {
    return Status::Failure("encloses no volume");
  }
  Vector3 lengths;
  spread.Axes(&lengths);
  features = {{"volume_mesh", "Volume (mesh)", "RNU0", "mm3", volume},
              {"surface_area", "Surface area (mesh)", "C0JK", "mm2", area}};
  AddRoundness(volume, area, features);
  features.insert(
      features.end(),
      {{"maximum_3d_diameter", "Maximum 3D diameter", "L0JK", "mm", DiameterOf(mesh.Points)},
       {"major_axis_length", "Major axis length", "TDIC", "mm", lengths[0]},
       {"minor_axis_length", "Minor axis length", "P9VJ", "mm", lengths[1]},
       {"least_axis_length", "Least axis length", "7J51", "mm", lengths[2]},
       {"elongation", "Elongation", "Q3CK", "", lengths[1] / lengths[0]},
       {"flatness", "Flatness", "N17B", "", lengths[2] / lengths[0]}});
  AddDensities(mesh, lengths, volume, area, features);
  return Status::Success();
}

double ValueOf(const std::vector<ShapeFeature>& features, const char* key)
{
  const auto found =
      std::find_if(features.begin(), features.end(),
                   [key](const ShapeFeature& one) { return std::strcmp(one.Key, key) == 0; });
  return found != features.end() ? found->Value : std::numeric_limits<double>::quiet_NaN();
}
} // namespace palpate
