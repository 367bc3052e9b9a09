#include "RandomStudy.h"

namespace palpate::test
{
namespace
{
CovariateTable SmallTable()
{
  CovariateTable table({"a", "b", "c", "d", "e", "f"});
  table.Add("age", {"61", "55", "70", "64", "58", "66"});
  table.Add("group", {"ill", "healthy", "ill", "healthy", "ill", "healthy"});
  table.Add("psa", {"4", "NA", "9", "1.5", "2.5", "3"});
  table.Add("grade", {"0", "1", "2", "0", "1", "2"});
  table.Add("same", {"x", "x", "x", "x", "x", "x"});
  table.Add("month", {"732", "660", "840", "768", "696", "792"});
  table.Add("typing", {"1", "2", "3,5", "4", "5", "6"});
  return table;
}

TEST(LinearDesign, CodesFactorsByTreatmentContrasts)
{
  const LinearDesign design = DesignOf(SmallTable(), "~ age + group");
  EXPECT_EQ(design.Columns, (std::vector<std::string>{"(Intercept)", "age", "groupill"}));
  EXPECT_EQ(design.Matrix.col(2), (Eigen::VectorXd(6) << 1, 0, 1, 0, 1, 0).finished());
  EXPECT_EQ(design.References.at("group"), "healthy");
  EXPECT_TRUE(design.Terms[0].IsNumeric);
  EXPECT_FALSE(design.Terms[1].IsNumeric);
}

// Ages of 55, 58, 61, 64, 66 and 70: squares about their mean add up to 448/3.
TEST(LinearDesign, DeviationOfANumberIsThatOfASample)
{
  const LinearDesign design = DesignOf(SmallTable(), "~ age + group");
  EXPECT_NEAR(design.Terms[0].Deviation, std::sqrt(448.0 / 3.0 / 5.0), 1e-12);
  EXPECT_EQ(design.Terms[1].Deviation, 0.0);
}

TEST(LinearDesign, TakesTheReferenceThatIsAskedFor)
{
  LinearDesign design;
  ASSERT_TRUE(
      MakeLinearDesign(SmallTable(), FormulaOf("~ group"), {{"group", "ill"}}, design).IsOk());
  EXPECT_EQ(design.Columns[1], "grouphealthy");
  EXPECT_NE(RefusalOf(SmallTable(), "~ group", {{"group", "dead"}})
                .find("no case has the reference dead"),
            std::string::npos);
}

TEST(LinearDesign, TreatsNumbersAsCategoriesOnRequest)
{
  EXPECT_EQ(DesignOf(SmallTable(), "~ factor(grade)").Columns,
            (std::vector<std::string>{"(Intercept)", "factor(grade)1", "factor(grade)2"}));
}

TEST(LinearDesign, OmitsIncompleteCasesAndSaysSo)
{
  const LinearDesign design = DesignOf(SmallTable(), "~ log(psa)");
  EXPECT_EQ(design.Cases, (std::vector<std::size_t>{0, 2, 3, 4, 5}));
  EXPECT_DOUBLE_EQ(design.Matrix(1, 1), std::log(9.0));
  EXPECT_EQ(design.Omitted, (std::vector<std::size_t>{1}));
  EXPECT_EQ(design.OmissionText(), "1 of 6 cases lack a value of psa and are omitted");
}

TEST(LinearDesign, MultipliesColumnsOfInteractions)
{
  const LinearDesign design = DesignOf(RandomCovariates(40, 3), "~ age*center");
  EXPECT_EQ(design.Columns,
            (std::vector<std::string>{"(Intercept)", "age", "centerRUMC", "centerZGT",
                                      "age:centerRUMC", "age:centerZGT"}));
  EXPECT_EQ(design.Matrix.col(5), design.Matrix.col(1).cwiseProduct(design.Matrix.col(3)));
  EXPECT_FALSE(design.Terms[0].IsTested);
  EXPECT_FALSE(design.Terms[1].IsTested);
  EXPECT_TRUE(design.Terms[2].IsTested);
}

TEST(LinearDesign, NamesWhatMakesAModelImpossible)
{
  const CovariateTable table = SmallTable();
  EXPECT_NE(RefusalOf(table, "~ weight").find("no column weight; they have age, group"),
            std::string::npos);
  EXPECT_NE(RefusalOf(table, "~ same").find("same has one value only, x"), std::string::npos);
  EXPECT_NE(
      RefusalOf(table, "~ age + month").find("month is a combination of columns before it (age)"),
      std::string::npos);
  EXPECT_NE(RefusalOf(table, "~ log(grade)")
                .find("log(grade) is not finite for case a, whose grade is 0"),
            std::string::npos);
  EXPECT_NE(RefusalOf(table, "~ log(group)").find("needs numbers, but case a has ill"),
            std::string::npos);
  EXPECT_NE(RefusalOf(table, "~ typing").find("no column of numbers since case c has 3,5"),
            std::string::npos);
  EXPECT_NE(RefusalOf(table, "~ age:group").find("write age*group"), std::string::npos);
  EXPECT_NE(RefusalOf(table, "~ age + group + grade + I(age^2) + I(age^3)").find("too few"),
            std::string::npos);
}

TEST(LinearDesign, NeedsThreeCompleteCases)
{
  CovariateTable table({"a", "b", "c"});
  table.Add("age", {"1", "", "3"});
  EXPECT_NE(RefusalOf(table, "~ age").find("only 2 cases have a value of each of age"),
            std::string::npos);
}
} // namespace
} // namespace palpate::test
