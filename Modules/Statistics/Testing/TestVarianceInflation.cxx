#include "RandomStudy.h"
#include "VarianceInflation.h"

namespace palpate::test
{
namespace
{
// `copy` is age with noise: their correlation r is known from the table itself.
CovariateTable CollinearTable(double noise)
{
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::vector<std::string> cases;
  std::vector<std::string> age;
  std::vector<std::string> copy;
  std::vector<std::string> group;
  for (int i = 0; i < 60; ++i)
  {
    const double years = 60.0 + 8.0 * normal(random);
    cases.push_back("c" + std::to_string(i));
    age.push_back(std::to_string(years));
    copy.push_back(std::to_string(years + noise * normal(random)));
    group.emplace_back(1, "abc"[i % 3]);
  }
  CovariateTable table(cases);
  table.Add("age", age);
  table.Add("copy", copy);
  table.Add("group", group);
  return table;
}

TEST(VarianceInflation, OfTwoColumnsIsThatOfTheirCorrelation)
{
  for (const double noise : {0.5, 20.0})
  {
    const LinearDesign design = DesignOf(CollinearTable(noise), "~ age + copy");
    Eigen::MatrixXd both = design.Matrix.rightCols(2);
    both.rowwise() -= both.colwise().mean().eval();
    const double r = both.col(0).dot(both.col(1)) / (both.col(0).norm() * both.col(1).norm());
    for (const DesignTerm& term : design.Terms)
    {
      EXPECT_NEAR(VarianceInflation(design, term) * (1.0 - r * r), 1.0, 1e-9);
    }
  }
}

TEST(VarianceInflation, OfAFactorDependsOnNoReferenceLevel)
{
  const CovariateTable table = CollinearTable(5.0);
  double first = 0.0;
  for (const char* const reference : {"a", "b", "c"})
  {
    LinearDesign design;
    ASSERT_TRUE(
        MakeLinearDesign(table, FormulaOf("~ group + age"), {{"group", reference}}, design).IsOk());
    const double inflation = VarianceInflation(design, design.Terms[0]);
    first = first == 0.0 ? inflation : first;
    EXPECT_NEAR(inflation, first, 1e-9);
    EXPECT_GE(inflation, 1.0);
  }
}

// With one other column the determinants of both terms are equal, and the root of a factor of
// three levels is the square root (Fox and Monette, J. Am. Stat. Assoc. 87, 1992).
TEST(VarianceInflation, OfAFactorIsPerColumn)
{
  const LinearDesign design = DesignOf(CollinearTable(5.0), "~ group + age");
  const double inflation = VarianceInflation(design, design.Terms[0]);
  EXPECT_NEAR(inflation * inflation, VarianceInflation(design, design.Terms[1]), 1e-9);
  EXPECT_GT(inflation, 1.001);
}

TEST(VarianceInflation, NotesNameBothOfACollinearPairAndNoOthers)
{
  const std::vector<std::string> notes =
      InflationNotes(DesignOf(CollinearTable(1.0), "~ age + group + copy"));
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_NE(notes[0].find("age is nearly a combination"), std::string::npos);
  EXPECT_NE(notes[0].find("most correlated with copy"), std::string::npos);
  EXPECT_NE(notes[1].find("most correlated with age"), std::string::npos);
  EXPECT_TRUE(InflationNotes(DesignOf(CollinearTable(20.0), "~ age + group + copy")).empty());
  EXPECT_TRUE(InflationNotes(DesignOf(CollinearTable(20.0), "~ age*copy")).empty());
  EXPECT_EQ(VarianceInflation(DesignOf(CollinearTable(1.0), "~ age"), DesignTerm{"age", 1, 1}),
            1.0);
}

TEST(LikelyMissingCode, IsFarFromNumbersThatAreNotNegative)
{
  const auto codeOf = [](std::vector<std::string> texts)
  { return Covariate("x", std::move(texts)).LikelyMissingCode(); };
  EXPECT_EQ(codeOf({"64", "-999", "37", "NA"}), -999.0);
  EXPECT_EQ(codeOf({"0", "1", "-9", "-9"}), -9.0);
  EXPECT_EQ(codeOf({"64", "9999", "37"}), 9999.0);
  EXPECT_EQ(codeOf({"-9", "-99", "3"}), -9.0);
  EXPECT_TRUE(std::isnan(codeOf({"-9", "-3", "4"})));      // of signed numbers
  EXPECT_TRUE(std::isnan(codeOf({"999", "850", "1200"}))); // among the others
  EXPECT_TRUE(std::isnan(codeOf({"999", "850", "250"})));  // beside them
  EXPECT_TRUE(std::isnan(codeOf({"999"})));
  EXPECT_TRUE(std::isnan(codeOf({"a", "b"})));
}
} // namespace
} // namespace palpate::test
