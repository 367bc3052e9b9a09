#include "SphericalHarmonicRotation.h"

#include "RandomShapes.h"
#include "SphereQuadrature.h"
#include "SphericalHarmonicBasis.h"
#include "WorstCase.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <gtest/gtest.h>
#include <limits>

namespace palpate
{
namespace
{
using test::Random;
using test::WorstCase;

Eigen::Matrix3d RandomRotation(Random& random)
{
  std::normal_distribution<double> normal;
  const Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
  return q.normalized().toRotationMatrix();
}

Eigen::Matrix3d Turn(double angle, const Vector3& axis)
{
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

// Rotations where Euler angles are undefined or ill conditioned, and some ordinary ones.
std::vector<Eigen::Matrix3d> RemarkableRotations()
{
  return {
      Eigen::Matrix3d::Identity(), Turn(1e-9, {1, 2, 0.5}),      Turn(1e-3, {1, -1, 0}),
      Turn(M_PI, {1, 0, 0}),       Turn(M_PI, {1, 1, 0}),        Turn(M_PI - 1e-9, {0, 1, 1e-9}),
      Turn(0.7, {0, 0, 1}),        Turn(M_PI, {0, 0, 1}),        Turn(M_PI / 2, {0, 1, 0}),
      Turn(-M_PI / 2, {1, 0, 0}),  Turn(2 * M_PI / 3, {1, 1, 1})};
}

SphericalHarmonicRotation Rotation(int degree, const Eigen::Matrix3d& matrix)
{
  SphericalHarmonicRotation rotation;
  const Status status = SphericalHarmonicRotation::Make(degree, matrix, rotation);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return rotation;
}

std::vector<double> Apply(const SphericalHarmonicRotation& rotation, const std::vector<double>& c)
{
  std::vector<double> rotated(c.size(), std::nan(""));
  rotation.Apply(c.data(), rotated.data());
  return rotated;
}

double LargestDifference(const std::vector<double>& a, const std::vector<double>& b)
{
  WorstCase worst;
  for (std::size_t k = 0; k < a.size(); ++k)
  {
    worst.Add(a[k] - b[k]);
  }
  return worst.Value();
}

double LargestEntry(const Eigen::MatrixXd& matrix)
{
  WorstCase worst;
  for (Eigen::Index i = 0; i < matrix.size(); ++i)
  {
    worst.Add(matrix.data()[i]);
  }
  return worst.Value();
}

// Slow reference for the matrix: the integral of Y_lm(u) Y_lk(Q^-1 u), exact by quadrature.
Eigen::MatrixXd ProjectedBlock(int degree, const Eigen::Matrix3d& matrix)
{
  const int size = 2 * degree + 1;
  const SphericalHarmonicBasis basis(degree);
  const SphereQuadrature sphere(2 * degree);
  std::vector<double> here(basis.Size());
  std::vector<double> there(basis.Size());
  const auto first = static_cast<std::size_t>(degree) * static_cast<std::size_t>(degree);
  Eigen::MatrixXd block = Eigen::MatrixXd::Zero(size, size);
  for (std::size_t i = 0; i < sphere.Weights.size(); ++i)
  {
    basis.Evaluate(sphere.Directions[i], here.data());
    basis.Evaluate(matrix.transpose() * sphere.Directions[i], there.data());
    block += sphere.Weights[i] * Eigen::Map<const Eigen::VectorXd>(here.data() + first, size) *
             Eigen::Map<const Eigen::VectorXd>(there.data() + first, size).transpose();
  }
  return block;
}
} // namespace

TEST(SphericalHarmonicRotation, BlocksMatchProjection)
{
  Random random(301);
  std::vector<Eigen::Matrix3d> matrices = RemarkableRotations();
  matrices.push_back(RandomRotation(random));
  matrices.push_back(RandomRotation(random));
  for (const Eigen::Matrix3d& matrix : matrices)
  {
    const SphericalHarmonicRotation rotation = Rotation(13, matrix);
    for (const int degree : {0, 1, 2, 3, 4, 7, 12, 13})
    {
      // The sum of some 400 weighted products of total size 1, each accurate to 1e-14.
      EXPECT_LE(LargestEntry(rotation.Block(degree) - ProjectedBlock(degree, matrix)), 3e-14)
          << degree;
    }
  }
}

TEST(SphericalHarmonicRotation, BlockOfDegree1IsMatrix)
{
  Random random(302);
  for (int sample = 0; sample < 20; ++sample)
  {
    const Eigen::Matrix3d matrix = RandomRotation(random);
    const Eigen::MatrixXd block = Rotation(1, matrix).Block(1); // rows and columns y, z, x
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        EXPECT_NEAR(block(i, j), matrix((i + 1) % 3, (j + 1) % 3), 2e-15); // a few roundings
      }
    }
  }
}

TEST(SphericalHarmonicRotation, RotatesFunctionWithDirections)
{
  Random random(303);
  for (const int degree : {1, 5, 12, 40, 100})
  {
    const std::vector<double> c = test::RandomCoefficients(random, degree);
    const Eigen::Matrix3d matrix = RandomRotation(random);
    const SphericalHarmonicModel old(degree, c, Vector3::Zero());
    const SphericalHarmonicModel rotated(degree, Apply(Rotation(degree, matrix), c),
                                         Vector3::Zero());
    for (const Vector3& u : test::RandomDirections(random, 20))
    {
      // Values are about 0.3 (L + 1); rotating u rounds it, which changes them by about L
      // roundings.
      EXPECT_NEAR(rotated.Radius((matrix * u).normalized()), old.Radius(u),
                  1e-15 * (degree + 1) * (degree + 1) + 1e-14)
          << degree;
    }
  }
}

TEST(SphericalHarmonicRotation, BlocksAreOrthogonalTo13DigitsUpToDegree200)
{
  Random random(304);
  const SphericalHarmonicRotation rotation = Rotation(200, RandomRotation(random));
  for (const int degree : {1, 2, 10, 50, 100, 200})
  {
    const Eigen::MatrixXd block = rotation.Block(degree);
    const auto size = block.rows();
    EXPECT_LE(LargestEntry(block.transpose() * block - Eigen::MatrixXd::Identity(size, size)),
              1e-13)
        << degree;
  }
}

TEST(SphericalHarmonicRotation, CompositionIsMatrixProduct)
{
  Random random(305);
  for (const int degree : {2, 12, 60, 100, 200})
  {
    const std::vector<double> c = test::RandomCoefficients(random, degree);
    const Eigen::Matrix3d first = RandomRotation(random);
    const Eigen::Matrix3d second = RandomRotation(random);
    const std::vector<double> together = Apply(Rotation(degree, second * first), c);
    const std::vector<double> oneByOne =
        Apply(Rotation(degree, second), Apply(Rotation(degree, first), c));
    // The product of the matrices is rounded to about 2e-16 rad, by which a function of degree L
    // changes L times as much; coefficients are about 1 and at most 5.
    EXPECT_LE(LargestDifference(together, oneByOne), 2e-15 * (degree + 5)) << degree;
  }
}

TEST(SphericalHarmonicRotation, CompositionHoldsAtGimbalLock)
{
  Random random(306);
  const std::vector<double> c = test::RandomCoefficients(random, 20);
  for (const Eigen::Matrix3d& first : RemarkableRotations())
  {
    for (const Eigen::Matrix3d& second : RemarkableRotations())
    {
      const std::vector<double> together = Apply(Rotation(20, second * first), c);
      const std::vector<double> oneByOne =
          Apply(Rotation(20, second), Apply(Rotation(20, first), c));
      EXPECT_LE(LargestDifference(together, oneByOne), 5e-14); // as above, L = 20
    }
  }
}

TEST(SphericalHarmonicRotation, InverseIsTranspose)
{
  Random random(307);
  const Eigen::Matrix3d matrix = RandomRotation(random);
  const SphericalHarmonicRotation there = Rotation(40, matrix);
  const SphericalHarmonicRotation back = Rotation(40, matrix.transpose());
  for (const int degree : {1, 3, 12, 40})
  {
    // 81 products of size 1/9 at most and the angles' rounding times 40.
    EXPECT_LE(LargestEntry(there.Block(degree).transpose() - back.Block(degree)), 2e-14) << degree;
  }
  const std::vector<double> c = test::RandomCoefficients(random, 40);
  EXPECT_LE(LargestDifference(Apply(back, Apply(there, c)), c), 5e-14);
}

TEST(SphericalHarmonicRotation, IdentityChangesNothing)
{
  Random random(308);
  const std::vector<double> c = test::RandomCoefficients(random, 100);
  // The exchange of y and z is applied twice: orthogonal to a few roundings.
  EXPECT_LE(LargestDifference(Apply(Rotation(100, Eigen::Matrix3d::Identity()), c), c), 5e-15);
  EXPECT_EQ(SphericalHarmonicRotation().Degree(), 0);
  EXPECT_EQ(Apply(SphericalHarmonicRotation(), {3.0}), std::vector<double>{3.0});
}

TEST(SphericalHarmonicRotation, KeepsPowerOfDegrees)
{
  Random random(309);
  for (int sample = 0; sample < 10; ++sample)
  {
    const SphericalHarmonicModel model(30, test::RandomCoefficients(random, 30), Vector3::Zero());
    const std::vector<double> before = model.PowerSpectrum();
    const std::vector<double> after =
        Rotation(30, RandomRotation(random)).Apply(model).PowerSpectrum();
    for (std::size_t l = 0; l < before.size(); ++l)
    {
      EXPECT_NEAR(after[l] / before[l], 1.0, 1e-14) << l; // tens of roundings
    }
  }
}

TEST(SphericalHarmonicRotation, WorksInPlace)
{
  Random random(310);
  const SphericalHarmonicRotation rotation = Rotation(9, RandomRotation(random));
  std::vector<double> c = test::RandomCoefficients(random, 9);
  const std::vector<double> expected = Apply(rotation, c);
  rotation.Apply(c.data(), c.data());
  EXPECT_EQ(c, expected);
}

TEST(SphericalHarmonicRotation, RotatesModelAboutCentreAndPoint)
{
  Random random(311);
  const SphericalHarmonicModel model = test::RandomOrgan(random, 10);
  const Eigen::Matrix3d matrix = RandomRotation(random);
  const SphericalHarmonicRotation rotation = Rotation(10, matrix);
  const Vector3 pivot(10.0, -20.0, 30.0);
  const SphericalHarmonicModel here = rotation.Apply(model);
  const SphericalHarmonicModel moved = rotation.ApplyAbout(pivot, model);
  EXPECT_EQ(here.CenterWorld(), model.CenterWorld());
  EXPECT_EQ(moved.Coefficients(), here.Coefficients());
  for (const Vector3& u : test::RandomDirections(random, 50))
  {
    const Vector3 expected = pivot + matrix * (model.PointWorld(u) - pivot);
    // Points some 200 mm off the origin, a few roundings of 3e-14 mm.
    EXPECT_LE((moved.PointWorld(matrix * u) - expected).norm(), 3e-13);
  }
}

TEST(SphericalHarmonicRotation, TruncatesHigherDegrees)
{
  Random random(312);
  const SphericalHarmonicModel model = test::RandomOrgan(random, 8);
  const Eigen::Matrix3d matrix = RandomRotation(random);
  const SphericalHarmonicModel low = Rotation(5, matrix).Apply(model);
  const SphericalHarmonicModel high = Rotation(11, matrix).Apply(model);
  EXPECT_EQ(low.Coefficients(), high.WithDegree(5).Coefficients()); // blocks do not mix
  EXPECT_EQ(high.WithDegree(8).WithDegree(11).Coefficients(), high.Coefficients());
}

TEST(SphericalHarmonicRotation, RejectsInvalidMatrix)
{
  SphericalHarmonicRotation rotation;
  const auto refuses = [&rotation](int degree, const Eigen::Matrix3d& matrix)
  { return !SphericalHarmonicRotation::Make(degree, matrix, rotation).IsOk(); };
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  EXPECT_TRUE(refuses(-1, identity));
  EXPECT_TRUE(refuses(3, -identity)) << "a reflection";
  EXPECT_TRUE(refuses(3, 1.001 * identity));
  EXPECT_TRUE(refuses(3, Eigen::Matrix3d::Zero()));
  Eigen::Matrix3d shear = identity;
  shear(0, 1) = 1e-3;
  EXPECT_TRUE(refuses(3, shear));
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()})
  {
    Eigen::Matrix3d matrix = identity;
    matrix(1, 2) = bad;
    EXPECT_TRUE(refuses(3, matrix));
  }
  EXPECT_EQ(rotation.Degree(), 0) << "a failure must leave the result unchanged";
}

TEST(SphericalHarmonicRotation, AcceptsRoundedMatrix)
{
  Random random(313);
  const Eigen::Matrix3d rounded = RandomRotation(random).cast<float>().cast<double>();
  const SphericalHarmonicRotation rotation = Rotation(6, rounded);
  const Eigen::MatrixXd block = rotation.Block(6);
  // Orthogonal to double precision, although the entries are accurate to float only.
  EXPECT_LE(LargestEntry(block.transpose() * block - Eigen::MatrixXd::Identity(13, 13)), 1e-14);
  EXPECT_LE(LargestEntry(rotation.Matrix() - rounded), 1e-6);
}
} // namespace palpate
