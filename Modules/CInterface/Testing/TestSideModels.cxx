#include "Handles.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

namespace palpate::side_models_test
{
namespace
{
using namespace palpate::test;

constexpr double Offset = 1.5; // mm of a coefficient, of the left sides
constexpr std::size_t Individuals = 10;

// Ellipsoids with noise of 0.1 mm.
std::vector<Owned<palpate_model>> Models(unsigned seed, double offset, double side)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0.0, 0.1);
  std::vector<Owned<palpate_model>> models;
  for (std::size_t n = 0; n < Individuals; ++n)
  {
    std::array<double, 9> coefficients{};
    for (double& one : coefficients)
    {
      one = normal(random);
    }
    coefficients[0] += 20.0 * std::sqrt(4.0 * M_PI);
    coefficients[6] += 12.0 + offset; // along z, which mirroring keeps
    coefficients[8] += 8.0;           // along x
    coefficients[7] += side;          // which mirroring turns round
    const double center[3] = {30.0 * side, 5.0, 7.0};
    models.emplace_back(palpate_model_create(2, coefficients.data(), center, nullptr));
  }
  return models;
}

std::vector<const palpate_model*> HandlesOf(const std::vector<Owned<palpate_model>>& models)
{
  std::vector<const palpate_model*> handles;
  for (const auto& one : models)
  {
    handles.push_back(one.get());
  }
  return handles;
}

TEST(SideModels, PairsHaveTheOffsetOfTheirLeftSides)
{
  const auto left = Models(1, Offset, 1.0);
  const auto right = Models(2, 0.0, -1.0);
  std::array<double, Individuals> individuals{};
  std::vector<double> mean(palpate_mesh_point_count(4));
  std::vector<double> points(3 * mean.size());
  palpate_asymmetry found{};
  found.individuals = individuals.data();
  found.mean = mean.data();
  found.points = points.data();
  palpate_error error{};
  for (const int turns : {0, 1})
  {
    ASSERT_EQ(palpate_find_asymmetry(HandlesOf(left).data(), HandlesOf(right).data(), Individuals,
                                     turns, 4, 199, 1, &found, &error),
              1)
        << error.text;
    // 2 n |mean / 2|^2 of the difference; noise of 0.1 sqrt(2 / 10) in each coefficient.
    EXPECT_NEAR(found.squares[1], 0.5 * Individuals * Offset * Offset, 1.5);
    EXPECT_EQ(found.degrees[1], 9.0);
    EXPECT_EQ(found.degrees[2], 81.0);
    EXPECT_EQ(found.p, 1.0 / 200.0);
    EXPECT_NEAR(individuals[0], Offset / std::sqrt(4.0 * M_PI), 0.15);
    std::size_t top = 0;
    for (std::size_t i = 0; i < mean.size(); ++i)
    {
      top = points[3 * i + 2] > points[3 * top + 2] ? i : top;
    }
    EXPECT_NEAR(mean[top], Offset * std::sqrt(5.0 / (4.0 * M_PI)), 0.15);
  }
}

TEST(SideModels, ModelsEqualToTheirMirrorImagesHaveNone)
{
  std::vector<Owned<palpate_model>> models;
  for (int n = 0; n < 3; ++n)
  {
    models.push_back(BallModel());
  }
  std::vector<double> mean(palpate_mesh_point_count(2), 1.0);
  palpate_asymmetry found{};
  found.mean = mean.data();
  ASSERT_EQ(
      palpate_find_asymmetry(HandlesOf(models).data(), nullptr, 3, 0, 2, 19, 1, &found, nullptr),
      1);
  EXPECT_EQ(found.squares[1], 0.0);
  EXPECT_EQ(found.p, 1.0);
  EXPECT_EQ(mean, std::vector<double>(mean.size(), 0.0));
}

TEST(SideModels, RefusesInASentence)
{
  const auto radial = Models(1, 0.0, 1.0);
  std::array<double, 12> linear{};
  linear[3] = linear[5] = linear[10] = 10.0;
  std::vector<const palpate_model*> models = HandlesOf(radial);
  palpate_asymmetry found{};
  palpate_error error{};
  EXPECT_EQ(palpate_find_asymmetry(models.data(), nullptr, 2, 0, 4, 9, 1, &found, &error), 0);
  EXPECT_STREQ(error.text, "asymmetry needs at least 3 individuals");
  EXPECT_EQ(palpate_find_asymmetry(models.data(), nullptr, 3, 0, 0, 9, 1, &found, &error), 0);
  EXPECT_NE(std::string(error.text).find("the frequency"), std::string::npos);
  const Owned<palpate_model> surface(palpate_model_create_surface(1, linear.data(), nullptr));
  models[1] = surface.get();
  EXPECT_EQ(palpate_find_asymmetry(models.data(), nullptr, 3, 0, 4, 9, 1, &found, &error), 0);
  EXPECT_STREQ(error.text, "radial and surface models cannot be compared");
  models[1] = nullptr;
  EXPECT_EQ(palpate_find_asymmetry(models.data(), nullptr, 3, 0, 4, 9, 1, &found, &error), 0);
  EXPECT_STREQ(error.text, "a model is NULL");
}
} // namespace
} // namespace palpate::side_models_test
