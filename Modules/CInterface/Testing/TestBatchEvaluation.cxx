#include "Handles.h"
#include "RandomShapes.h"
#include "SurfaceCurvature.h"
#include "Vector3.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <vector>

namespace palpate::batch_evaluation_test
{
namespace
{
using test::Owned;

constexpr int Degree = 6;
constexpr std::size_t Count = 300; // more than are evaluated at once

Owned<palpate_model> StarHandle(const RadialModel& model)
{
  return Owned<palpate_model>(palpate_model_create(model.Degree(), model.Coefficients().data(),
                                                   model.CenterWorld().data(), nullptr));
}

Owned<palpate_model> SurfaceHandle(const SurfaceModel& surface)
{
  std::vector<double> values;
  for (int coordinate = 0; coordinate < 3; ++coordinate)
  {
    const std::vector<double>& of = surface.Coefficients(coordinate);
    values.insert(values.end(), of.begin(), of.end());
  }
  palpate_error error{};
  Owned<palpate_model> handle(
      palpate_model_create_surface(surface.Degree(), values.data(), &error));
  EXPECT_NE(handle, nullptr) << error.text;
  return handle;
}

RadialModel Bumpy()
{
  test::Random random(5);
  return test::RandomOrgan(random, Degree);
}

struct Results
{
  std::array<Vector3, Count> Points, Normals, Gradients;
  std::array<double, Count> Radii, Mean, Gaussian;
  std::array<std::array<double, 2>, Count> Principal;
  std::array<std::array<Vector3, 2>, Count> Tangents;

  palpate_evaluation Of(bool isRadial)
  {
    return {Points[0].data(),
            Normals[0].data(),
            isRadial ? Radii.data() : nullptr,
            isRadial ? Gradients[0].data() : nullptr,
            Mean.data(),
            Gaussian.data(),
            Principal[0].data(),
            Tangents[0][0].data()};
  }
};

void ExpectPlace(const palpate_model* handle, const Vector3& direction, const Results& results,
                 std::size_t i)
{
  Vector3 point;
  Vector3 normal;
  ASSERT_EQ(palpate_model_point(handle, direction.data(), point.data(), normal.data(), nullptr), 1);
  // Batches may round otherwise.
  EXPECT_LT((results.Points[i] - point).norm(), 1e-12);
  EXPECT_LT((results.Normals[i] - normal).norm(), 1e-12);
}

void ExpectCurvature(const SurfaceCurvature& wanted, const Results& results, std::size_t i)
{
  EXPECT_NEAR(results.Mean[i], wanted.Mean, 1e-12);
  EXPECT_NEAR(results.Gaussian[i], wanted.Gaussian, 1e-12);
  for (std::size_t axis = 0; axis < 2; ++axis)
  {
    EXPECT_NEAR(results.Principal[i][axis], wanted.Principal[axis], 1e-12);
    EXPECT_NEAR(results.Tangents[i][axis].dot(wanted.Directions[axis]), 1.0, 1e-6);
  }
}

TEST(BatchEvaluation, BatchesHaveTheResultsOfSinglePoints)
{
  const RadialModel model = Bumpy();
  const SurfaceModel surface = SurfaceModel::FromModel(model);
  test::Random random(7);
  const std::vector<Vector3> directions = test::RandomDirections(random, Count);
  const auto star = StarHandle(model);
  const auto surfaceModel = SurfaceHandle(surface);
  Results of[2];
  const palpate_evaluation stars = of[0].Of(true);
  const palpate_evaluation others = of[1].Of(false);
  ASSERT_EQ(palpate_model_evaluate(star.get(), directions[0].data(), Count, &stars, nullptr), 1);
  ASSERT_EQ(
      palpate_model_evaluate(surfaceModel.get(), directions[0].data(), Count, &others, nullptr), 1);
  for (std::size_t i = 0; i < Count; ++i)
  {
    const Vector3& u = directions[i];
    ExpectPlace(star.get(), u, of[0], i);
    ExpectPlace(surfaceModel.get(), u, of[1], i);
    EXPECT_NEAR(of[0].Radii[i], model.Radius(u), 1e-12);
    EXPECT_LT((of[0].Gradients[i] - model.Evaluate(u).SurfaceGradient).norm(), 1e-12);
    ExpectCurvature(CurvatureAt(u, model.EvaluateSecondOrder(u)), of[0], i);
    ExpectCurvature(CurvatureAt(surface.EvaluateSecondOrder(u)), of[1], i);
  }
}

TEST(BatchEvaluation, ResultsThatAreNullAreLeftOut)
{
  const auto star = StarHandle(Bumpy());
  const double direction[3] = {0.0, 0.0, 3.0};
  double radius = 0.0;
  palpate_evaluation results{};
  results.radii = &radius;
  ASSERT_EQ(palpate_model_evaluate(star.get(), direction, 1, &results, nullptr), 1);
  EXPECT_NEAR(radius, Bumpy().Radius(Vector3::UnitZ()), 1e-12);
}

TEST(BatchEvaluation, RefusesDirectionsThatAreZeroAndRadiiOfSurfaceModels)
{
  const auto surfaceModel = SurfaceHandle(SurfaceModel::FromModel(Bumpy()));
  const double directions[6] = {0.0, 0.0, 1.0, 0.0, 0.0, 0.0};
  double radii[2] = {-1.0, -1.0};
  palpate_evaluation results{};
  results.radii = radii;
  palpate_error error{};
  EXPECT_EQ(palpate_model_evaluate(surfaceModel.get(), directions, 1, &results, &error), 0);
  EXPECT_NE(std::strstr(error.text, "radial"), nullptr) << error.text;
  EXPECT_EQ(palpate_model_evaluate(StarHandle(Bumpy()).get(), directions, 2, &results, &error), 0);
  EXPECT_NE(std::strstr(error.text, "direction 1"), nullptr) << error.text;
  EXPECT_EQ(radii[0], -1.0) << "outputs are left alone";
}
} // namespace
} // namespace palpate::batch_evaluation_test
