#include "Handles.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace palpate::design_handle_test
{
namespace
{
using namespace palpate::test;

constexpr std::array<const char*, 2> Names{{"age", "group"}};
// The fourth case has no age.
constexpr std::array<const char*, 12> Values{
    {"60", "70", "65", "", "58", "72", "a", "b", "a", "b", "b", "a"}};

Owned<palpate_design> DesignOf(const char* formula, palpate_error* error)
{
  return Owned<palpate_design>(
      palpate_design_create(formula, 6, 2, Names.data(), Values.data(), 0, nullptr, error));
}

TEST(DesignHandle, FitsWhatOutcomesAreMadeOf)
{
  palpate_error error{};
  const Owned<palpate_design> design = DesignOf("~ age + group", &error);
  ASSERT_NE(design, nullptr) << error.text;
  EXPECT_EQ(palpate_design_case_count(design.get()), 5U);
  EXPECT_STREQ(palpate_design_column_name(design.get(), 2), "groupb");
  EXPECT_EQ(palpate_design_column_name(design.get(), 3), nullptr);
  std::array<std::size_t, 5> cases{};
  std::array<double, 15> matrix{};
  palpate_design_matrix(design.get(), cases.data(), matrix.data());
  EXPECT_EQ(cases, (std::array<std::size_t, 5>{0, 1, 2, 4, 5}));
  std::array<double, 6> outcomes{};
  outcomes.fill(std::nan("")); // also that of the case that is left out
  for (std::size_t i = 0; i < 5; ++i)
  {
    outcomes[cases[i]] = 3.0 + 0.5 * matrix[3 * i + 1] - 2.0 * matrix[3 * i + 2];
  }
  std::array<double, 3> coefficients{};
  std::array<double, 3> errors{};
  std::array<double, 3> widths{};
  ASSERT_EQ(palpate_design_fit(design.get(), outcomes.data(), 1, 0.95, coefficients.data(),
                               errors.data(), widths.data(), &error),
            1)
      << error.text;
  EXPECT_NEAR(coefficients[0], 3.0, 1e-10);
  EXPECT_NEAR(coefficients[1], 0.5, 1e-12);
  EXPECT_NEAR(coefficients[2], -2.0, 1e-11);
}

// Pairs: the paired t-test, and the analysis of variance of their means (Searle, Linear Models,
// 1971).
TEST(DesignHandle, MixedModelOfPairsIsTheirPairedTest)
{
  const std::array<const char*, 1> name{{"time"}};
  const std::array<const char*, 6> times{{"0", "0", "1", "0", "1", "1"}};
  palpate_error error{};
  const Owned<palpate_design> design(
      palpate_design_create("~ time", 6, 1, name.data(), times.data(), 0, nullptr, &error));
  ASSERT_NE(design, nullptr) << error.text;
  const std::array<int32_t, 6> subjects{5, -3, 5, 9, -3, 9};
  const std::array<double, 6> outcomes{4.0, 9.0, 5.0, 1.0, 10.5, 3.0};
  const double spread = 0.25; // variance of the differences 1, 1.5 and 2
  const std::array<double, 3> means{4.5, 9.75, 2.0};
  double between = 0.0;
  for (const double mean : means)
  {
    between += 0.5 * std::pow(mean - (4.5 + 9.75 + 2.0) / 3.0, 2);
  }
  std::array<double, 2> coefficients{};
  std::array<double, 2> errors{};
  std::array<double, 1> residual{};
  std::array<double, 3> covariance{};
  std::array<double, 2> f{};
  std::array<double, 2> degrees{};
  palpate_mixed results{};
  results.coefficients = coefficients.data();
  results.errors = errors.data();
  results.residual_variance = residual.data();
  results.subject_covariance = covariance.data();
  results.f = f.data();
  results.denominator_degrees = degrees.data();
  ASSERT_EQ(palpate_design_fit_mixed(design.get(), subjects.data(), nullptr, outcomes.data(), 1,
                                     0.95, &results, &error),
            1)
      << error.text;
  EXPECT_NEAR(coefficients[1], 1.5, 1e-9);
  EXPECT_NEAR(errors[1], std::sqrt(spread / 3.0), 1e-6); // of the search for the optimum, as below
  EXPECT_NEAR(residual[0], 0.5 * spread, 1e-6);
  EXPECT_NEAR(covariance[0], between - 0.25 * spread, 1e-4);
  const std::size_t term = palpate_design_term_count(design.get()) - 1;
  EXPECT_NEAR(f[term], 1.5 * 1.5 * 3.0 / spread, 1e-4);
  EXPECT_NEAR(degrees[term], 2.0, 1e-4);
  const std::array<int32_t, 6> alone{1, 2, 3, 4, 5, 6};
  EXPECT_EQ(palpate_design_fit_mixed(design.get(), alone.data(), nullptr, outcomes.data(), 1, 0.95,
                                     &results, &error),
            0);
  EXPECT_NE(error.text[0], '\0');
}

TEST(DesignHandle, TermsHaveTheirColumns)
{
  const Owned<palpate_design> design = DesignOf("~ age + group", nullptr);
  palpate_term term{};
  ASSERT_EQ(palpate_design_term(design.get(), 1, &term), 1);
  EXPECT_STREQ(term.name, "group");
  EXPECT_EQ(term.first_column, 2U);
  EXPECT_EQ(term.column_count, 1U);
  EXPECT_EQ(term.is_tested, 1);
  EXPECT_EQ(palpate_design_term(design.get(), 2, &term), 0);
}

TEST(DesignHandle, RefusesBadArgumentsInASentence)
{
  palpate_error error{};
  EXPECT_EQ(DesignOf("~ weight", &error), nullptr);
  EXPECT_NE(std::string(error.text).find("no column weight"), std::string::npos);
  const Owned<palpate_design> design = DesignOf("~ age", &error);
  std::array<double, 6> values{};
  std::array<double, 6> results{};
  EXPECT_EQ(palpate_design_fit(design.get(), values.data(), 1, 1.0, results.data(), results.data(),
                               results.data(), &error),
            0);
  EXPECT_STREQ(error.text, "the confidence is not between 0 and 1");
  EXPECT_EQ(
      palpate_design_test(design.get(), 7, values.data(), 1, nullptr, nullptr, nullptr, &error), 0);
  const double area = 1.0;
  const std::array<int32_t, 3> triangle{{0, 1, 2}};
  double whole = 0.0;
  EXPECT_EQ(palpate_design_permute(design.get(), 0, values.data(), 1, &area, triangle.data(), 1, 9,
                                   1, nullptr, nullptr, nullptr, nullptr, &whole, &whole, &error),
            0);
  EXPECT_STREQ(error.text, "a triangle has a corner that is no point");
}

TEST(DesignHandle, DisplacementOfASphereIsItsHarmonics)
{
  const Owned<palpate_model> ball = BallModel();
  std::array<double, 36> points{};
  std::array<double, 36> normals{};
  std::array<double, 12> areas{};
  std::array<int32_t, 60> triangles{};
  std::array<double, 12> map{};
  palpate_error error{};
  ASSERT_EQ(palpate_model_displacement(ball.get(), 1, points.data(), normals.data(), areas.data(),
                                       triangles.data(), map.data(), &error),
            1)
      << error.text;
  for (const double one : map)
  {
    EXPECT_NEAR(one, 1.0 / std::sqrt(4.0 * M_PI), 1e-15);
  }
  EXPECT_NEAR(std::hypot(points[0], points[1], points[2]), 20.0, 1e-12);
  EXPECT_EQ(palpate_model_displacement(ball.get(), 0, nullptr, nullptr, nullptr, nullptr, nullptr,
                                       &error),
            0);
}
} // namespace
} // namespace palpate::design_handle_test
