#include "RandomStudy.h"

namespace palpate::test
{
namespace
{
std::string ErrorOf(const std::string& text)
{
  ModelFormula formula;
  return ModelFormula::Parse(text, formula).Message();
}

TEST(ModelFormula, ReadsSumsTransformsAndQuotedNames)
{
  EXPECT_EQ(FormulaOf(" ~ age+log( psa ) + I(age^2)+factor(grade)+`body mass`").Text(),
            "~ age + log(psa) + I(age^2) + factor(grade) + `body mass`");
  EXPECT_EQ(FormulaOf("sqrt(a) + log2(b) + log10(c) + exp(d) + 1").Text(),
            "~ sqrt(a) + log2(b) + log10(c) + exp(d)");
}

TEST(ModelFormula, ExpandsProductsAsR)
{
  EXPECT_EQ(FormulaOf("~ a*b + c").Text(), "~ a + b + c + a:b");
  EXPECT_EQ(FormulaOf("~ a*b*c").Text(), "~ a + b + c + a:b + a:c + b:c + a:b:c");
  EXPECT_EQ(FormulaOf("~ a + b + a:b + b:a + a + a:a").Text(), "~ a + b + a:b");
}

TEST(ModelFormula, ListsEachColumnOnce)
{
  EXPECT_EQ(FormulaOf("~ age + I(age^2) + age:sex + sex").Columns(),
            (std::vector<std::string>{"age", "sex"}));
}

TEST(ModelFormula, PointsAtWhatIsNotUnderstood)
{
  EXPECT_NE(ErrorOf("~ age + ").find("character 9"), std::string::npos);
  EXPECT_NE(ErrorOf("~ age & sex").find("character 7: expected + : or *"), std::string::npos);
  EXPECT_NE(ErrorOf("~ poly(age)").find("log, log2"), std::string::npos);
  EXPECT_NE(ErrorOf("~ I(age)").find("exponent"), std::string::npos);
  EXPECT_NE(ErrorOf("~ log(age").find("expected )"), std::string::npos);
  EXPECT_NE(ErrorOf("~ `age").find("back quote"), std::string::npos);
  EXPECT_NE(ErrorOf("~ age - 1").find("expected + : or *"), std::string::npos);
  EXPECT_NE(ErrorOf("~ 0 + age").find("intercept"), std::string::npos);
  EXPECT_NE(ErrorOf("~ 1").find("no covariate"), std::string::npos);
  EXPECT_NE(ErrorOf("").find("expected the name"), std::string::npos);
}

TEST(ModelFormula, RefusesProductsWithoutEnd)
{
  std::string text = "~ a0";
  for (int i = 1; i < 40; ++i)
  {
    text += "*a" + std::to_string(i);
  }
  EXPECT_NE(ErrorOf(text).find("too many terms"), std::string::npos);
}

// Random bytes of the notation's own characters: an answer or a message, never a crash.
TEST(ModelFormula, SurvivesRandomTexts)
{
  std::mt19937 random(7);
  const std::string letters = "~+*:()^`ab1 29.Ilog";
  for (int round = 0; round < 20000; ++round)
  {
    std::string text;
    for (std::size_t i = random() % 20; i > 0; --i)
    {
      text += letters[random() % letters.size()];
    }
    ModelFormula formula;
    const Status status = ModelFormula::Parse(text, formula);
    ASSERT_EQ(status.IsOk(), !formula.Terms().empty()) << text;
    if (status.IsOk())
    {
      ASSERT_EQ(FormulaOf(formula.Text()).Text(), formula.Text()) << text;
    }
  }
}
} // namespace
} // namespace palpate::test
