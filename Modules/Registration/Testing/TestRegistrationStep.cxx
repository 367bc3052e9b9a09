#include "RegistrationStep.h"

#include "RandomMaps.h"

#include <gtest/gtest.h>

namespace palpate::registration_step_test
{
namespace
{
constexpr std::array<RegistrationKind, 3> Kinds{
    RegistrationKind::Rigid, RegistrationKind::Similarity, RegistrationKind::Affine};

TEST(RegistrationStep, DerivativesAreThoseOfItsMap)
{
  test::Random random(1);
  for (const RegistrationKind kind : Kinds)
  {
    const RegistrationStep step(kind, test::RandomVector(random, 20.0), 7.0);
    const Vector3 point = test::RandomVector(random, 20.0);
    const Vector3 direction = test::RandomVector(random, 1.0).normalized();
    const Eigen::VectorXd row = step.Derivatives(point, direction);
    ASSERT_EQ(row.size(), step.Count());
    for (int k = 0; k < step.Count(); ++k)
    {
      constexpr double H = 1e-5; // mm: rounding 1e-10, second order 1e-10
      const Eigen::VectorXd unknowns = H * Eigen::VectorXd::Unit(step.Count(), k);
      const Vector3 ahead = step.MapOf(unknowns) * point;
      const Vector3 behind = step.MapOf(-unknowns) * point;
      EXPECT_NEAR(row[k], direction.dot(ahead - behind) / (2.0 * H), 1e-8) << k;
    }
  }
}

TEST(RegistrationStep, LargeRigidStepsKeepLengthsAndSimilaritiesAngles)
{
  test::Random random(2);
  for (int draw = 0; draw < 50; ++draw)
  {
    const Eigen::VectorXd unknowns = 10.0 * Eigen::VectorXd::Random(7);
    const Matrix3 rigid = RegistrationStep(RegistrationKind::Rigid, Vector3::Zero(), 5.0)
                              .MapOf(unknowns.head<6>())
                              .linear();
    EXPECT_NEAR((rigid.transpose() * rigid - Matrix3::Identity()).norm(), 0.0, 1e-14);
    EXPECT_GT(rigid.determinant(), 0.0);
    const Matrix3 similar = RegistrationStep(RegistrationKind::Similarity, Vector3::Zero(), 5.0)
                                .MapOf(unknowns)
                                .linear();
    const Matrix3 product = similar.transpose() * similar;
    EXPECT_NEAR((product / product(0, 0) - Matrix3::Identity()).norm(), 0.0, 1e-13);
  }
}

TEST(PredictedPoseError, IsInfiniteForWhatPointsDoNotDetermine)
{
  // Points of a ball, seen along its normals: no turn of it is seen.
  const RegistrationStep step(RegistrationKind::Rigid, Vector3::Zero(), 10.0);
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(6, 6);
  test::Random random(3);
  for (int i = 0; i < 100; ++i)
  {
    const Vector3 direction = test::RandomVector(random, 1.0).normalized();
    const Eigen::VectorXd row = step.Derivatives(10.0 * direction, direction);
    normal += row * row.transpose();
  }
  const PredictedPoseError error = PredictedPoseError::Of(normal, 10.0, 1.0);
  EXPECT_TRUE(std::isinf(error.Turn));
  EXPECT_NEAR(error.Shift, std::sqrt(3.0 * 3.0 / 100.0), 0.05); // each axis is seen by a third
}
} // namespace
} // namespace palpate::registration_step_test
