#include "SurfaceModelSolver.h"

#include "IcosahedronDirections.h"
#include "SphericalHarmonicBasis.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace palpate::parametric_solver_test
{
namespace
{
using Coefficients = std::array<std::vector<double>, 3>;

// An ellipsoid with smooth bends of all degrees.
Coefficients BentEllipsoid(int degree)
{
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  Coefficients coefficients;
  for (std::vector<double>& axis : coefficients)
  {
    for (int l = 0; l <= degree; ++l)
    {
      for (int m = -l; m <= l; ++m)
      {
        axis.push_back(5.0 * normal(random) / (1.0 + l * l * l));
      }
    }
  }
  coefficients[0][3] += 60.0; // x, y and z of the parameter are of degree 1
  coefficients[1][1] += 50.0;
  coefficients[2][2] += 40.0;
  return coefficients;
}

SurfaceSamples SamplesOf(const SurfaceModel& surface, int frequency)
{
  SurfaceSamples samples;
  const IcosahedronDirections sphere(frequency);
  samples.Parameters = sphere.Directions();
  for (const Vector3& u : samples.Parameters)
  {
    samples.Points.push_back(surface.Point(u));
    samples.Normals.push_back(surface.Normal(u));
    samples.Weights.push_back(1.0 / static_cast<double>(samples.Parameters.size()));
  }
  return samples;
}

void AddNoise(SurfaceSamples& samples)
{
  std::mt19937 random(6);
  std::normal_distribution<double> normal;
  for (Vector3& point : samples.Points)
  {
    point += Vector3(normal(random), normal(random), normal(random));
  }
}

double Difference(const SurfaceModel& surface, const Coefficients& expected)
{
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::vector<double>& found = surface.Coefficients(axis);
    const std::vector<double>& wanted = expected[static_cast<std::size_t>(axis)];
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
      largest = std::max(largest, std::abs(found[i] - wanted[i]));
    }
  }
  return largest;
}

Coefficients CoefficientsOf(const SurfaceModel& surface)
{
  return {surface.Coefficients(0), surface.Coefficients(1), surface.Coefficients(2)};
}

// The minimum of FitNormals from the dense normal equations.
Coefficients DenseFit(int degree, const SurfaceSamples& samples, double tangentWeight)
{
  const SphericalHarmonicBasis basis(degree);
  const auto count = static_cast<Eigen::Index>(basis.Size());
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(3 * count, 3 * count);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(3 * count);
  Eigen::VectorXd values(count);
  for (std::size_t i = 0; i < samples.Points.size(); ++i)
  {
    basis.Evaluate(samples.Parameters[i], values.data());
    const Vector3& n = samples.Normals[i];
    const Matrix3 metric = samples.Weights[i] * (tangentWeight * Matrix3::Identity() +
                                                 (1.0 - tangentWeight) * n * n.transpose());
    const Vector3 pulled = metric * samples.Points[i];
    for (int a = 0; a < 3; ++a)
    {
      right.segment(a * count, count) += pulled[a] * values;
      for (int b = 0; b < 3; ++b)
      {
        matrix.block(a * count, b * count, count, count) +=
            metric(a, b) * values * values.transpose();
      }
    }
  }
  const Eigen::VectorXd solution = matrix.ldlt().solve(right);
  Coefficients coefficients;
  for (int a = 0; a < 3; ++a)
  {
    const double* first = solution.data() + a * count;
    coefficients[static_cast<std::size_t>(a)].assign(first, first + count);
  }
  return coefficients;
}

TEST(SurfaceModelSolver, RecoversCoefficientsFromExactSamples)
{
  for (const int degree : {1, 4, 12, 20})
  {
    const Coefficients exact = BentEllipsoid(degree);
    SurfaceModelSolver solver(degree, 0.0);
    ASSERT_TRUE(solver.FitPoints(SamplesOf({degree, exact}, 22)));
    // 200 mm, some hundred roundings.
    EXPECT_LT(Difference(solver.Surface(), exact), 1e-11) << degree;
  }
}

TEST(SurfaceModelSolver, ExactSamplesStayWhereTheyAre)
{
  const Coefficients exact = BentEllipsoid(8);
  const SurfaceSamples samples = SamplesOf({8, exact}, 12);
  SurfaceModelSolver solver(8, 0.0);
  ASSERT_TRUE(solver.FitPoints(samples));
  solver.SetTangentWeights(samples, std::vector<double>(samples.Points.size(), 0.05));
  solver.FitNormals(samples, 15);
  EXPECT_LT(Difference(solver.Surface(), exact), 1e-11);
}

TEST(SurfaceModelSolver, NormalFitIsTheMinimumOfItsFunction)
{
  SurfaceSamples samples = SamplesOf({4, BentEllipsoid(4)}, 8);
  AddNoise(samples);
  SurfaceModelSolver solver(4, 0.0);
  ASSERT_TRUE(solver.FitPoints(samples));
  // As many iterations as unknowns, so that only rounding remains.
  solver.SetTangentWeights(samples, std::vector<double>(samples.Points.size(), 0.05));
  solver.FitNormals(samples, 75);
  EXPECT_LT(Difference(solver.Surface(), DenseFit(4, samples, 0.05)), 1e-8);
}

TEST(SurfaceModelSolver, FullTangentWeightEqualsPointFit)
{
  SurfaceSamples samples = SamplesOf({6, BentEllipsoid(6)}, 10);
  AddNoise(samples);
  SurfaceModelSolver solver(6, 1e-4);
  ASSERT_TRUE(solver.FitPoints(samples));
  const Coefficients points = CoefficientsOf(solver.Surface());
  solver.SetTangentWeights(samples, std::vector<double>(samples.Points.size(), 1.0));
  solver.FitNormals(samples, 5);
  EXPECT_LT(Difference(solver.Surface(), points), 1e-11);
}

TEST(SurfaceModelSolver, TranslationMovesOnlyTheCenter)
{
  const Vector3 shift(4e3, -7e3, 1e4);
  SurfaceSamples samples = SamplesOf({6, BentEllipsoid(6)}, 10);
  AddNoise(samples);
  SurfaceModelSolver solver(6, 1e-4);
  ASSERT_TRUE(solver.FitPoints(samples));
  Coefficients moved = CoefficientsOf(solver.Surface());
  for (Vector3& point : samples.Points)
  {
    point += shift;
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    moved[axis][0] += shift[static_cast<long>(axis)] * std::sqrt(4.0 * M_PI);
  }
  ASSERT_TRUE(solver.FitPoints(samples));
  EXPECT_LT(Difference(solver.Surface(), moved), 1e-9); // 1e4 mm have an epsilon of 2e-12
}

TEST(SurfaceModelSolver, RejectsFewerPointsThanCoefficients)
{
  SurfaceModelSolver solver(12, 0.0);
  EXPECT_FALSE(solver.FitPoints(SamplesOf({1, BentEllipsoid(1)}, 2)));
}

TEST(SurfaceSamples, VerticesShareTheAreaAndPointOutwards)
{
  const IcosahedronDirections sphere(6);
  const SurfaceSamples samples =
      SampleMesh({sphere.Directions(), sphere.Triangles()}, sphere.Directions(), 1.0);
  ASSERT_EQ(samples.Points.size(), sphere.Directions().size());
  double sum = 0.0;
  for (std::size_t i = 0; i < samples.Points.size(); ++i)
  {
    sum += samples.Weights[i];
    EXPECT_GT(samples.Normals[i].dot(samples.Points[i]), 0.999); // triangles are 10 degrees wide
  }
  EXPECT_NEAR(sum, 1.0, 1e-13);
}

// Every triangle is divided; the samples' areas and moments are those of the triangles.
TEST(SurfaceSamples, DividesTrianglesThatAreWideOnTheSphere)
{
  const IcosahedronDirections sphere(2);
  const IndexedMesh mesh{sphere.Directions(), sphere.Triangles()};
  const SurfaceSamples samples = SampleMesh(mesh, sphere.Directions(), 0.1);
  ASSERT_EQ(samples.Points.size(), sphere.Directions().size() + samples.Triangles.size());
  ASSERT_GT(samples.Triangles.size(), 20 * mesh.Triangles.size());
  double sum = 0.0;
  Vector3 mean = Vector3::Zero();
  for (std::size_t i = 0; i < samples.Points.size(); ++i)
  {
    EXPECT_NEAR(samples.Parameters[i].norm(), 1.0, 1e-15);
    sum += samples.Weights[i];
    mean += samples.Weights[i] * samples.Points[i];
  }
  EXPECT_NEAR(sum, 1.0, 1e-13);
  EXPECT_LT(mean.norm(), 1e-14);
  EXPECT_EQ(samples.Weights.front(), 0.0) << "a vertex without an undivided triangle";
}
} // namespace
} // namespace palpate::parametric_solver_test
