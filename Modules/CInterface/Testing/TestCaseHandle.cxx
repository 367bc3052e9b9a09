#include "Handles.h"

#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

namespace palpate::case_handle_test
{
namespace
{
using namespace palpate::test;

constexpr std::array<int, 3> Size{60, 32, 32};
constexpr double Origin[3] = {-30.0, -16.0, 100.0};
constexpr double Spacing[3] = {1.0, 1.0, 1.0};
constexpr double Axes[9] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};

struct Ball
{
  double X, Y, Z, Radius; // voxels

  bool Has(int i, int j, int k) const
  {
    return std::hypot(i - this->X, j - this->Y, k - this->Z) <= this->Radius;
  }
};

// Label n + 1 where the n-th ball is; `hole` belongs to none.
std::vector<int32_t> LabelsOf(const std::vector<Ball>& balls, const Ball& hole = {0, 0, 0, -1})
{
  std::vector<int32_t> labels;
  for (int k = 0; k < Size[2]; ++k)
  {
    for (int j = 0; j < Size[1]; ++j)
    {
      for (int i = 0; i < Size[0]; ++i)
      {
        int32_t label = 0;
        for (std::size_t n = 0; n < balls.size(); ++n)
        {
          label = balls[n].Has(i, j, k) && !hole.Has(i, j, k) ? static_cast<int32_t>(n) + 1 : label;
        }
        labels.push_back(label);
      }
    }
  }
  return labels;
}

Owned<palpate_case> CaseOf(const std::vector<int32_t>& labels,
                           const std::array<const char*, 2>& names, const double* axes = Axes,
                           palpate_error* error = nullptr)
{
  const std::array<int32_t, 2> values{1, 2};
  return Owned<palpate_case>(palpate_case_of_labels(labels.data(), Size.data(), Origin, Spacing,
                                                    axes, 2, values.data(), names.data(), error));
}

palpate_rule RuleOf(const palpate_checked* checked, std::size_t structure, const std::string& key)
{
  palpate_rule rule{};
  for (std::size_t k = 0; palpate_checked_rule(checked, structure, k, &rule) != 0; ++k)
  {
    if (rule.key == key)
    {
      return rule;
    }
  }
  ADD_FAILURE() << key;
  return {};
}

TEST(CaseHandle, AHoleIsFoundWhereItIs)
{
  const auto labels = LabelsOf({{15, 16, 16, 11}, {45, 16, 16, 11}}, {45, 16, 16, 4.2});
  palpate_error error{};
  const auto one = CaseOf(labels, {"liver", ""}, Axes, &error);
  ASSERT_NE(one, nullptr) << error.text;
  const Owned<palpate_checked> checked(palpate_case_check(one.get(), nullptr, 0.05, &error));
  ASSERT_NE(checked, nullptr) << error.text;
  palpate_verdict verdict{};
  ASSERT_EQ(palpate_checked_verdict(checked.get(), 0, &verdict), 1);
  EXPECT_STREQ(verdict.name, "liver");
  EXPECT_EQ(verdict.verdict, 0);
  EXPECT_STREQ(verdict.sentence, "shows nothing unusual");
  EXPECT_STREQ(verdict.rule, "");
  EXPECT_TRUE(std::isnan(verdict.place[0]) && std::isnan(verdict.p));
  ASSERT_EQ(palpate_checked_verdict(checked.get(), 1, &verdict), 1);
  EXPECT_STREQ(verdict.name, "label 2");
  EXPECT_EQ(verdict.verdict, 2);
  EXPECT_STREQ(verdict.rule, "hole");
  EXPECT_EQ(std::string(verdict.sentence).find("has a hole of 0.3"), 0U) << verdict.sentence;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::array<double, 3> middle{15.0, 0.0, 116.0};
    EXPECT_NEAR(verdict.place[axis], middle[static_cast<std::size_t>(axis)], 1.0); // of voxels
  }
  const palpate_rule rule = RuleOf(checked.get(), 1, "hole");
  EXPECT_EQ(rule.is_alarm, 1);
  EXPECT_EQ(rule.place[2], verdict.place[2]);
  EXPECT_EQ(RuleOf(checked.get(), 0, "hole").is_alarm, 0);
  EXPECT_EQ(palpate_checked_verdict(checked.get(), 2, &verdict), 0) << "they are no one body";
}

TEST(CaseHandle, OverlapsAreThoseOfMasks)
{
  const std::array<Ball, 2> balls{Ball{20, 16, 16, 10}, Ball{30, 16, 16, 10}};
  std::array<std::vector<uint8_t>, 2> masks;
  double shared = 0.0;
  double least = 1e9;
  for (std::size_t n = 0; n < 2; ++n)
  {
    double count = 0.0;
    for (const int32_t label : LabelsOf({balls[n]}))
    {
      masks[n].push_back(label != 0 ? 7 : 0);
      count += label;
    }
    least = std::min(least, count);
  }
  for (std::size_t i = 0; i < masks[0].size(); ++i)
  {
    shared += masks[0][i] != 0 && masks[1][i] != 0 ? 1.0 : 0.0;
  }
  const std::array<const uint8_t*, 2> voxels{masks[0].data(), masks[1].data()};
  const std::array<const char*, 2> names{"a", "b"};
  const Owned<palpate_case> one(palpate_case_of_masks(voxels.data(), Size.data(), Origin, Spacing,
                                                      Axes, 2, names.data(), nullptr));
  const Owned<palpate_checked> checked(palpate_case_check(one.get(), nullptr, 0.05, nullptr));
  ASSERT_GT(shared, 0.0);
  EXPECT_NEAR(RuleOf(checked.get(), 0, "overlap").value, shared / least, 1e-12);
  EXPECT_NEAR(RuleOf(checked.get(), 1, "overlap").value, shared / least, 1e-12);
}

TEST(CaseHandle, SidesNeedAxesThatAreThePatients)
{
  const auto labels = LabelsOf({{15, 16, 16, 11}, {45, 16, 16, 11}}); // right first, as x is left
  for (const double* axes : {Axes, static_cast<const double*>(nullptr)})
  {
    const auto one = CaseOf(labels, {"kidney_left", "kidney_right"}, axes);
    const Owned<palpate_checked> checked(palpate_case_check(one.get(), nullptr, 0.05, nullptr));
    palpate_verdict verdict{};
    ASSERT_EQ(palpate_checked_verdict(checked.get(), 0, &verdict), 1);
    EXPECT_STREQ(verdict.rule, axes != nullptr ? "side" : "");
  }
}

// Twenty-four pairs of balls whose radii vary.
std::vector<const palpate_case*> CleanCases()
{
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0.0, 0.4);
  static std::vector<Owned<palpate_case>> cases; // made once
  for (std::size_t n = cases.size(); n < 24; ++n)
  {
    cases.push_back(CaseOf(LabelsOf({{15 + normal(random), 16, 16, 10 + normal(random)},
                                     {45, 16 + normal(random), 16, 10 + normal(random)}}),
                           {"a", "b"}));
  }
  std::vector<const palpate_case*> handles;
  for (const auto& one : cases)
  {
    handles.push_back(one.get());
  }
  return handles;
}

TEST(CaseHandle, GroupsJudgeTheSameOnceWrittenAndRead)
{
  const std::vector<const palpate_case*> handles = CleanCases();
  palpate_error error{};
  const Owned<palpate_check_group> made(
      palpate_check_group_create(handles.data(), handles.size(), &error));
  ASSERT_NE(made, nullptr) << error.text;
  const std::string path = ::testing::TempDir() + "case-handle-group.json";
  ASSERT_EQ(palpate_check_group_write(made.get(), path.c_str(), &error), 1) << error.text;
  const Owned<palpate_check_group> read(palpate_check_group_read(path.c_str(), &error));
  ASSERT_NE(read, nullptr) << error.text;
  EXPECT_EQ(palpate_check_group_least_rate(read.get()), 1.0 / 25.0);
  const auto odd = CaseOf(LabelsOf({{15, 16, 16, 5}, {45, 16, 16, 10}}), {"a", "b"});
  std::array<double, 2> p{};
  for (std::size_t n = 0; n < 2; ++n)
  {
    const Owned<palpate_checked> checked(
        palpate_case_check(odd.get(), n == 0 ? made.get() : read.get(), 0.1, &error));
    ASSERT_NE(checked, nullptr) << error.text;
    palpate_verdict verdict{};
    ASSERT_EQ(palpate_checked_verdict(checked.get(), 0, &verdict), 1);
    EXPECT_NE(verdict.verdict, 0) << "an eighth of the usual volume";
    p[n] = verdict.p;
    EXPECT_LT(RuleOf(checked.get(), 0, "size").p, 0.01);
    EXPECT_GT(RuleOf(checked.get(), 1, "size").p, 0.01);
  }
  EXPECT_EQ(p[0], p[1]);
  EXPECT_EQ(palpate_case_check(odd.get(), made.get(), 0.01, &error), nullptr);
  EXPECT_NE(std::string(error.text).find("too few cases"), std::string::npos);
}

TEST(CaseHandle, DroppedCasesHaveTheirPlace)
{
  std::vector<const palpate_case*> handles = CleanCases();
  const auto cut =
      CaseOf(LabelsOf({{15, 16, 16, 10}, {55, 16, 16, 10}}), {"a", "b"}); // beyond the image
  handles[3] = cut.get();
  const Owned<palpate_check_group> made(
      palpate_check_group_create(handles.data(), handles.size(), nullptr));
  std::size_t place = 0;
  const char* const why = palpate_check_group_dropped(made.get(), 0, &place);
  ASSERT_NE(why, nullptr);
  EXPECT_EQ(place, 3U);
  EXPECT_EQ(std::string(why).find("b is cut off by the border"), 0U) << why;
}

TEST(CaseHandle, RefusesInASentence)
{
  palpate_error error{};
  const auto labels = LabelsOf({{15, 16, 16, 11}});
  EXPECT_EQ(CaseOf(labels, {"a", "b"}, Axes, &error), nullptr);
  EXPECT_STREQ(error.text, "the structure b has no voxels");
  EXPECT_EQ(CaseOf(labels, {"a", nullptr}, Axes, &error), nullptr);
  EXPECT_STREQ(error.text, "a text of 'names' is NULL");
  EXPECT_EQ(palpate_case_of_labels(labels.data(), Size.data(), Origin, Spacing, Axes, 0, nullptr,
                                   nullptr, &error),
            nullptr);
  EXPECT_STREQ(error.text, "a case has one structure at least");
  const auto one = CaseOf(LabelsOf({{15, 16, 16, 11}, {45, 16, 16, 11}}), {"a", "b"});
  const palpate_case* const handles[] = {one.get(), one.get(), nullptr};
  EXPECT_EQ(palpate_check_group_create(handles, 2, &error), nullptr);
  EXPECT_NE(std::string(error.text).find("20 clean cases"), std::string::npos);
  EXPECT_EQ(palpate_check_group_create(handles, 3, &error), nullptr);
  EXPECT_STREQ(error.text, "a case of 'cases' is NULL");
  for (const double rate : {0.0, 1.0, std::nan("")})
  {
    EXPECT_EQ(palpate_case_check(one.get(), nullptr, rate, &error), nullptr);
    EXPECT_STREQ(error.text, "the rate of false alarms is not between 0 and 1");
  }
  EXPECT_EQ(palpate_check_group_read("/absent/group.json", &error), nullptr);
  EXPECT_NE(std::string(error.text).find("/absent/group.json"), std::string::npos);
}
} // namespace
} // namespace palpate::case_handle_test
