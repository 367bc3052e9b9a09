#include "ElasticCases.h"
#include "SphereQuadrature.h"
#include "SymmetricEigen.h"

#include <gtest/gtest.h>

#include <future>
#include <vector>

namespace palpate::reduced_compliance_test
{
namespace
{
// Coefficients of f(d) e_r for a zonal harmonic f, by quadrature.
Eigen::VectorXd RadialField(int degree, int bandLimit)
{
  const SphericalHarmonicBasis basis(bandLimit);
  const SphereQuadrature sphere(2 * bandLimit + 2);
  const auto size = static_cast<Eigen::Index>(basis.Size());
  Eigen::VectorXd field = Eigen::VectorXd::Zero(3 * size);
  Eigen::VectorXd values(size);
  for (std::size_t i = 0; i < sphere.Directions.size(); ++i)
  {
    basis.Evaluate(sphere.Directions[i], values.data());
    const double zonal =
        values[static_cast<Eigen::Index>(SphericalHarmonicBasis::Index(degree, 0))];
    for (Eigen::Index component = 0; component < 3; ++component)
    {
      field.segment(component * size, size) +=
          sphere.Weights[i] * zonal * sphere.Directions[i][component] * values;
    }
  }
  return field;
}

// Elements of 2.4 mm err with the square of the degree; those that the core's surface cuts are too
// stiff by parts of the contrast.
TEST(ReducedCompliance, AnswersPressureLikeTheExactSphere)
{
  for (const double depth : {0.0, 5.0})
  {
    const test::ElasticCase& sphere = test::SphereCase(depth);
    const LayeredSphere truth = test::SphereTruth(depth);
    for (const int degree : {0, 2, 4, 6, 8, 10})
    {
      // Per solid angle, hence the square of the radius.
      const Eigen::VectorXd traction = RadialField(degree, 12) * test::Radius * test::Radius;
      const double moved = RadialField(degree, 12).dot(sphere.Reduced.Matrix() * traction);
      const double exact = truth.Response(degree)(0, 0);
      const double tolerance = depth > 0.0 ? 0.045 : 0.004 + 0.00025 * degree * degree;
      EXPECT_NEAR(moved, exact, tolerance * exact) << degree << " core " << depth;
    }
  }
}

TEST(ReducedCompliance, IsSymmetricAndPositive)
{
  std::mt19937_64 random(7);
  for (const double nu : {0.0, 0.4999})
  {
    test::ElasticCase organ;
    organ.Model = test::RandomModel(random);
    organ.Solid.PoissonRatio = nu;
    organ.Solid.Tissue.AddInclusion(
        test::BallFraction(organ.Model.CenterWorld() + Vector3(8.0, 0.0, 0.0), 6.0), 20.0);
    ASSERT_NO_FATAL_FAILURE(organ.Build(6, 6));
    const Eigen::MatrixXd& c = organ.Reduced.Matrix();
    EXPECT_EQ(c.rows(), 3 * 49);
    EXPECT_EQ((c - c.transpose()).norm(), 0.0);
    EXPECT_GT(SymmetricEigen(c, false).Values[0], 0.0) << nu;
  }
}

TEST(ReducedCompliance, IsTheSameFromSeveralThreads)
{
  std::mt19937_64 random(7);
  test::ElasticCase organ;
  organ.Model = test::RandomModel(random);
  ASSERT_NO_FATAL_FAILURE(organ.Build(6, 4));
  const auto differences = [&organ]
  {
    int count = 0;
    for (int repeat = 0; repeat < 8; ++repeat)
    {
      ReducedCompliance again;
      const bool isMade = ReducedCompliance::Make(organ.Mesh, organ.Stiffness, 4, {}, again).IsOk();
      count += isMade && again.Matrix() == organ.Reduced.Matrix() ? 0 : 1;
    }
    return count;
  };
  std::vector<std::future<int>> threads;
  for (int thread = 0; thread < 4; ++thread)
  {
    threads.push_back(std::async(std::launch::async, differences));
  }
  for (std::future<int>& thread : threads)
  {
    EXPECT_EQ(thread.get(), 0);
  }
}

TEST(ReducedCompliance, RefusesAnOrganThatNothingHolds)
{
  StarMesh mesh;
  StiffnessMatrix stiffness;
  const ElasticSolid afloat{TissueMap(0.02), 0.49, ElasticBed(0.0)};
  ASSERT_TRUE(StarMesh::Make(test::SphereModel(), 4, mesh).IsOk());
  ASSERT_TRUE(AssembleStiffness(mesh, Vector3::Zero(), afloat, stiffness).IsOk());
  ReducedCompliance reduced;
  EXPECT_FALSE(ReducedCompliance::Make(mesh, stiffness, 4, {}, reduced).IsOk());
}

TEST(ReducedCompliance, StopsWhenCancelled)
{
  StarMesh mesh;
  StiffnessMatrix stiffness;
  ASSERT_TRUE(StarMesh::Make(test::SphereModel(), 4, mesh).IsOk());
  ASSERT_TRUE(AssembleStiffness(mesh, Vector3::Zero(), test::PlainSolid(), stiffness).IsOk());
  ReducedCompliance reduced;
  int steps = 0;
  for (bool isDone = false; !isDone; ++steps)
  {
    double last = -1.0;
    int calls = 0;
    const auto progress = [&](double fraction)
    {
      EXPECT_GE(fraction, last);
      last = fraction;
      return ++calls <= steps;
    };
    isDone = ReducedCompliance::Make(mesh, stiffness, 12, progress, reduced).IsOk();
    EXPECT_EQ(calls, isDone ? steps : steps + 1) << "it ends at once";
  }
  EXPECT_GT(steps, 10);
}

// Against the displacement under the patch's traction, of which it is the mean.
TEST(ReducedCompliance, PatchesYieldByTheMeanOfTheirDisplacement)
{
  std::mt19937_64 random(7);
  test::ElasticCase organ;
  organ.Model = test::RandomModel(random);
  ASSERT_NO_FATAL_FAILURE(organ.Build(6, 6));
  const ComplianceSampler sampler(organ.Model, organ.Solid, organ.Reduced);
  const SphericalHarmonicBasis basis(6);
  for (const Vector3& direction : test::RandomDirections(random, 5))
  {
    const std::vector<HertzPatch> patches{sampler.PatchAt(direction, 2.0),
                                          sampler.PatchAt(direction, 5.0)};
    const std::vector<double> found = organ.Reduced.Compliances(patches.front().Normal, patches);
    ASSERT_EQ(found.size(), patches.size());
    for (std::size_t i = 0; i < patches.size(); ++i)
    {
      Eigen::VectorXd pressure(static_cast<Eigen::Index>(basis.Size()));
      patches[i].Project(basis, pressure.data());
      const Eigen::MatrixX3d moved = organ.Reduced.Displacement(patches[i]);
      const double mean = -pressure.dot(moved * patches[i].Normal);
      EXPECT_NEAR(found[i], mean, 1e-12 * mean);
    }
  }
}

TEST(ReducedCompliance, RefusesOtherDegrees)
{
  StarMesh mesh;
  StiffnessMatrix stiffness;
  ASSERT_TRUE(StarMesh::Make(test::SphereModel(), 4, mesh).IsOk());
  ASSERT_TRUE(AssembleStiffness(mesh, Vector3::Zero(), test::PlainSolid(), stiffness).IsOk());
  ReducedCompliance reduced;
  for (const int degree : {-1, ReducedCompliance::MostDegree + 1})
  {
    EXPECT_FALSE(ReducedCompliance::Make(mesh, stiffness, degree, {}, reduced).IsOk());
  }
}

TEST(ReducedCompliance, WindowFallsFromOneToZero)
{
  EXPECT_EQ(ReducedCompliance::Window(6.0, 12), 1.0);
  EXPECT_EQ(ReducedCompliance::Window(12.5, 12), 0.0);
  double last = 1.0;
  for (int halves = 13; halves < 25; ++halves)
  {
    const double value = ReducedCompliance::Window(0.5 * halves, 12);
    EXPECT_LT(value, last);
    last = value;
  }
}
} // namespace
} // namespace palpate::reduced_compliance_test
