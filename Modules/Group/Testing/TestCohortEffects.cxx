#include "CohortEffectFiles.h"
#include "CohortEffectPage.h"
#include "CovariateModel.h"
#include "DecimalText.h"
#include "IcosahedronDirections.h"
#include "MarkupCheck.h"
#include "MessageOf.h"
#include "RandomShapes.h"
#include "ReportPage.h"
#include "SphericalHarmonicBasis.h"
#include "SurfaceFile.h"
#include "SurfacePhantoms.h"
#include "TemporaryFolder.h"

#include "vtkPointData.h"

#include <gtest/gtest.h>

namespace palpate::cohort_effects_test
{
namespace
{
using namespace palpate::test;

constexpr int Degree = 4;
constexpr int Cases = 40;

/// Forty radial shapes round a mean of 20 mm: 0.05 mm along one harmonic per year of age, one mm
/// along another for group b, and noise in all.
class EffectCohort
{
public:
  EffectCohort()
  {
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    std::string covariates = "case,age,group\n";
    Eigen::MatrixXd coefficients(Cases, 25);
    for (int i = 0; i < Cases; ++i)
    {
      const double age = 60.0 + 8.0 * normal(random);
      const bool isB = i % 2 == 1;
      Eigen::VectorXd values =
          Eigen::VectorXd::NullaryExpr(25, [&] { return 0.1 * normal(random); });
      values[0] += 20.0 * std::sqrt(4.0 * M_PI);
      values[AgeHarmonic] += 0.05 * (age - 60.0);
      values[GroupHarmonic] += isB ? 1.0 : 0.0;
      coefficients.row(i) = values;
      covariates +=
          "c_" + std::to_string(i) + "," + std::to_string(age) + "," + (isB ? "b" : "a") + "\n";
      this->AddCase("c_" + std::to_string(i), values);
    }
    EXPECT_TRUE(FindShapeModes(coefficients, this->Group.Modes).IsOk());
    WriteAll(this->Folder / "covariates.csv", covariates);
  }

  CovariateRequest Request(const std::string& formula) const
  {
    CovariateRequest request;
    request.File = this->Folder / "covariates.csv";
    request.Formula = formula;
    request.Effects.Permutations.Count = 199;
    return request;
  }
  CohortEffects Effects(const std::string& formula) const
  {
    std::vector<std::string> notes;
    return *CovariateModel(this->Group, this->Request(formula), notes, {}).Effects();
  }

  static constexpr int AgeHarmonic = 6;
  static constexpr int GroupHarmonic = 12;
  TemporaryFolder Folder;
  CohortGroup Group;

private:
  void AddCase(const std::string& name, const Eigen::VectorXd& values)
  {
    CohortRow row;
    row.Case = name;
    this->Group.Rows.push_back(row);
    this->Group.Models.emplace_back(RadialModel(
        Degree, std::vector<double>(values.data(), values.data() + 25), Vector3::Zero()));
    this->Group.Bodies.emplace_back();
    this->Group.Bodies.back().Volume = 1000.0 + static_cast<double>(this->Group.Rows.size());
  }
};

TEST(CohortEffects, FindsTheDisplacementThatTheShapesWereMadeWith)
{
  const EffectCohort cohort;
  const CohortEffects effects = cohort.Effects("~ age + group");
  ASSERT_EQ(effects.Terms.size(), 2U);
  EXPECT_EQ(effects.Terms[1].Columns[0].Name, "groupb");
  const SphericalHarmonicBasis basis(Degree);
  const IcosahedronDirections sphere(16);
  std::vector<double> values(basis.Size());
  int covered = 0;
  for (std::size_t p = 0; p < sphere.Directions().size(); ++p)
  {
    const auto row = static_cast<Eigen::Index>(p);
    basis.Evaluate(sphere.Directions()[p], values.data());
    const ColumnEffect& age = effects.Terms[0].Columns[0];
    const ColumnEffect& group = effects.Terms[1].Columns[0];
    // The mean is a ball but for noise of 0.1 mm, so normals are directions up to 1e-2.
    EXPECT_NEAR(group.PerUnit[row], values[EffectCohort::GroupHarmonic], 0.25);
    const double error = age.PerUnit[row] - 0.05 * values[EffectCohort::AgeHarmonic];
    covered += std::abs(error) < age.HalfWidth[row] ? 1 : 0;
  }
  // Points depend on 25 numbers, so the share within their 95 % intervals varies much.
  EXPECT_GT(covered, 2000);
  for (const TermEffect& effect : effects.Terms)
  {
    EXPECT_LT(effect.Points.WholeP, 0.01);
    EXPECT_LT(effect.Scores.Pillai.P, 1e-6);
    EXPECT_LT(effect.Points.EnhancedP.minCoeff(), 0.01);
  }
}

TEST(CohortEffects, OfAnUnrelatedCovariateAreNotSignificant)
{
  EffectCohort cohort;
  const CohortEffects effects = cohort.Effects("~ age + group + volume_ml");
  EXPECT_GT(effects.Terms[2].Points.EnhancedP.minCoeff(), 0.05);
  EXPECT_GT(effects.Terms[2].Scores.Pillai.P, 0.01);
}

TEST(CohortEffects, BeyondModesAreThoseOfTheModelWithTheirScoresAsCovariates)
{
  const EffectCohort cohort;
  CovariateRequest request = cohort.Request("~ group");
  request.Effects.BeyondModes = 2;
  std::vector<std::string> notes;
  const CohortEffects beyond = *CovariateModel(cohort.Group, request, notes, {}).Effects();
  std::string table = "case,group,mode_1,mode_2\n";
  for (int i = 0; i < Cases; ++i)
  {
    table += "c_" + std::to_string(i) + (i % 2 == 1 ? ",b," : ",a,") +
             ExactText(cohort.Group.Modes.Scores(i, 0)) + "," +
             ExactText(cohort.Group.Modes.Scores(i, 1)) + "\n";
  }
  request.File = cohort.Folder / "scores.csv";
  WriteAll(request.File, table);
  request.Effects.BeyondModes = 0;
  request.Formula = "~ group + mode_1 + mode_2";
  const CohortEffects listed = *CovariateModel(cohort.Group, request, notes, {}).Effects();
  ASSERT_EQ(beyond.Terms.size(), 1U);
  const TermEffect& group = beyond.Terms[0];
  const TermEffect& same = listed.Terms[0];
  EXPECT_EQ(group.Points.FamilyP, same.Points.FamilyP);
  EXPECT_EQ(group.Columns[0].HalfWidth, same.Columns[0].HalfWidth);
  EXPECT_EQ(group.Columns[0].PerUnit, same.Columns[0].PerUnit);
  EXPECT_EQ(group.PartialR2, same.PartialR2);
  // Scores are what the multivariate test explains, and no covariates of it.
  EXPECT_EQ(group.Scores.Pillai.P, cohort.Effects("~ group").Terms[0].Scores.Pillai.P);
  EXPECT_NE(CohortEffectMethods(beyond).find("first 2 modes do not explain"), std::string::npos);
  EXPECT_NE(CohortEffectText(beyond).find("beyond the first 2 modes"), std::string::npos);
}

TEST(CohortEffects, SurfaceHasAllMapsByName)
{
  const EffectCohort cohort;
  WriteCohortEffects(cohort.Group, cohort.Effects("~ age + group"), cohort.Folder.Path());
  const auto surface = ReadSurface(cohort.Folder / "effects.vtp");
  ASSERT_EQ(surface->GetNumberOfPoints(), 2562);
  for (const char* name : {"age (mm)", "age 95% half width (mm)", "age t", "age p", "age p family",
                           "age p TFCE", "age q", "age partial R2", "groupb (mm)", "group p TFCE"})
  {
    EXPECT_NE(surface->GetPointData()->GetArray(name), nullptr) << name;
  }
  EXPECT_NE(ReadAll(cohort.Folder / "design.csv").find("case,(Intercept),age,groupb\nc_0,1,"),
            std::string::npos);
  const std::string table = ReadAll(cohort.Folder / "effects.csv");
  EXPECT_NE(table.find("\nage,1,40,"), std::string::npos);
}

// VTK writes names of arrays into XML as they are.
TEST(CohortEffects, NamesOfColumnsMayHoldWhatXmlReserves)
{
  const EffectCohort cohort;
  std::string table = ReadAll(cohort.Folder / "covariates.csv");
  table.replace(table.find("group"), 5, "\"<gro\"\"u\"\"p&\"");
  WriteAll(cohort.Folder / "covariates.csv", table);
  WriteCohortEffects(cohort.Group, cohort.Effects("~ `<gro\"u\"p&`"), cohort.Folder.Path());
  const auto surface = ReadSurface(cohort.Folder / "effects.vtp");
  EXPECT_EQ(surface->GetNumberOfPoints(), 2562);
}

TEST(CohortEffects, SectionIsWellFormedAndNamesNoCase)
{
  const EffectCohort cohort;
  ReportPage page;
  AddCohortEffects(page, cohort.Effects("~ age + group"));
  const std::string html = page.Body();
  EXPECT_EQ(MarkupError("<html><body>" + html + "</body></html>"), "");
  EXPECT_EQ(html.find("c_17"), std::string::npos);
  EXPECT_NE(html.find("group a"), std::string::npos); // the reference level
}

TEST(CovariateModel, SaysWhatLooksLikeACodeAndWhatIsCollinear)
{
  const EffectCohort cohort;
  std::string table = "case,age,again\n";
  for (int i = 0; i < Cases; ++i)
  {
    const int age = i == 3 ? -999 : 50 + (7 * i) % 31;
    table += "c_" + std::to_string(i) + "," + std::to_string(age) + "," +
             std::to_string(age + i % 2) + "\n";
  }
  WriteAll(cohort.Folder / "covariates.csv", table);
  std::vector<std::string> notes;
  const CovariateModel model(cohort.Group, cohort.Request("~ age + again"), notes, {});
  ASSERT_EQ(notes.size(), 3U);
  EXPECT_NE(notes[0].find("age is -999 in some cases"), std::string::npos);
  EXPECT_NE(notes[1].find("age is nearly a combination"), std::string::npos);
  WriteCohortEffects(cohort.Group, *model.Effects(), cohort.Folder.Path());
  EXPECT_NE(ReadAll(cohort.Folder / "effects.csv").find(",variance_inflation\n"),
            std::string::npos);
  ReportPage page;
  AddCohortEffects(page, *model.Effects());
  EXPECT_NE(page.Body().find("variance inflation"), std::string::npos);
}

TEST(CovariateModel, RefusesInOneSentence)
{
  const EffectCohort cohort;
  const auto refusal = [&](CovariateRequest request)
  {
    std::vector<std::string> notes;
    return test::MessageOf([&] { CovariateModel(cohort.Group, request, notes, {}); });
  };
  EXPECT_NE(refusal(cohort.Request("")).find("need a formula"), std::string::npos);
  EXPECT_NE(refusal(cohort.Request("~ weight")).find("no column weight"), std::string::npos);
  CovariateRequest request = cohort.Request("~ group");
  request.References = {"group"};
  EXPECT_NE(refusal(request).find("COLUMN=LEVEL"), std::string::npos);
  request = cohort.Request("~ group");
  request.Effects.BeyondModes = 20; // of 40 cases two columns leave 38 free degrees
  EXPECT_NE(refusal(request).find("40 complete cases allow for 19"), std::string::npos);
}
} // namespace
} // namespace palpate::cohort_effects_test
