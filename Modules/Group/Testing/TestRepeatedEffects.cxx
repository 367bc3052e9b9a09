#include "CovariateModel.h"
#include "MarkupCheck.h"
#include "MessageOf.h"
#include "ProbabilityDistributions.h"
#include "RepeatedEffectFiles.h"
#include "ReportPage.h"
#include "SurfaceFile.h"
#include "TemporaryFolder.h"

#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace palpate::repeated_effects_test
{
namespace
{
using namespace palpate::test;

constexpr int PatientCount = 20;

/// Twenty patients with as many scans each: shapes of 20 mm with an own shape, 0.05 mm a month
/// along one harmonic, a deviation of 0.03 from that, and noise. Every second is in group b.
class RepeatedCohort
{
public:
  explicit RepeatedCohort(int scans)
  {
    std::mt19937 random(6);
    std::normal_distribution<double> normal;
    std::string table = "case,patient,months,group\n";
    Eigen::MatrixXd coefficients(PatientCount * scans, 9);
    for (int i = 0; i < PatientCount * scans; ++i)
    {
      const int patient = i / scans;
      const int months = 6 * (i % scans);
      std::mt19937 own(static_cast<unsigned>(100 + patient)); // the same for each scan
      std::normal_distribution<double> ofPatient;
      Eigen::VectorXd values =
          Eigen::VectorXd::NullaryExpr(9, [&] { return 0.5 * ofPatient(own); });
      values += Eigen::VectorXd::NullaryExpr(9, [&] { return 0.1 * normal(random); });
      values[0] += 20.0 * std::sqrt(4.0 * M_PI);
      values[TimeHarmonic] += (0.05 + 0.03 * ofPatient(own)) * months;
      coefficients.row(i) = values;
      const std::string name = "c_" + std::to_string(i);
      table += name + ",p" + std::to_string(patient) + "," + std::to_string(months) +
               (patient % 2 == 0 ? ",a\n" : ",b\n");
      this->Group.Rows.emplace_back();
      this->Group.Rows.back().Case = name;
      this->Group.Rows.back().Result.ModelAreaSquareMillimeters = 5000.0;
      this->Group.Models.emplace_back(
          RadialModel(2, std::vector<double>(values.begin(), values.end()), Vector3::Zero()));
      this->Group.Bodies.emplace_back();
      this->Group.Bodies.back().Volume = 1000.0 * values[0];
      this->Group.Bodies.back().SemiAxes = Vector3(values[1], values[2], values[3]);
    }
    EXPECT_TRUE(FindShapeModes(coefficients, this->Group.Modes).IsOk());
    WriteAll(this->Folder / "scans.csv", table);
  }
  CovariateRequest Request(const std::string& formula, const std::string& time) const
  {
    CovariateRequest request;
    request.File = this->Folder / "scans.csv";
    request.Formula = formula;
    request.Repeated = {"patient", time};
    return request;
  }
  RepeatedEffects Effects(const std::string& formula, const std::string& time,
                          std::vector<std::string>* notes = nullptr) const
  {
    std::vector<std::string> told;
    const CovariateModel model(this->Group, this->Request(formula, time),
                               notes == nullptr ? told : *notes, {});
    EXPECT_EQ(model.Effects(), nullptr);
    return *model.Repeated();
  }

  static constexpr int TimeHarmonic = 6;
  TemporaryFolder Folder;
  CohortGroup Group;
};

// As R's t.test finds it.
double FOfMean(const Eigen::ArrayXd& values)
{
  const auto count = static_cast<double>(values.size());
  return values.mean() * values.mean() * count * (count - 1.0) /
         (values - values.mean()).square().sum();
}

// For two scans of each patient these are the exact tests of what varies within patients and of
// what does not.
TEST(RepeatedEffects, OfTwoScansAreThePairedTestAndTheTestOfMeans)
{
  RepeatedCohort cohort(2);
  Eigen::ArrayXd change(PatientCount);
  Eigen::ArrayXd means(PatientCount);
  for (int i = 0; i < PatientCount; ++i)
  {
    change[i] = cohort.Group.Modes.Scores(2 * i + 1, 0) - cohort.Group.Modes.Scores(2 * i, 0);
    means[i] =
        0.5 * (cohort.Group.Modes.Scores(2 * i + 1, 0) + cohort.Group.Modes.Scores(2 * i, 0));
  }
  const RepeatedEffects effects = cohort.Effects("~ months + group", "");
  EXPECT_EQ(effects.PatientCount, PatientCount);
  EXPECT_EQ(effects.SeveralCount, PatientCount);
  const RepeatedFigure& mode = effects.Modes.front();
  EXPECT_EQ(mode.Name, "mode_1");
  // The criterion is flat to 1e-11 at its minimum, so variances are right to about 1e-5.
  EXPECT_NEAR(mode.Tests[0].F / FOfMean(change), 1.0, 1e-4);
  EXPECT_NEAR(mode.Tests[0].DenominatorDegrees, 19.0, 1e-6);
  const Eigen::ArrayXd odd = means(Eigen::seq(1, PatientCount - 1, 2));
  const Eigen::ArrayXd even = means(Eigen::seq(0, PatientCount - 1, 2));
  const double rest =
      ((odd - odd.mean()).square().sum() + (even - even.mean()).square().sum()) / 18.0;
  EXPECT_NEAR(mode.Tests[1].F / (std::pow(odd.mean() - even.mean(), 2) / (0.2 * rest)), 1.0, 1e-4);
  EXPECT_NEAR(mode.Tests[1].DenominatorDegrees, 18.0, 1e-6);
}

// For scans at the same times these are exactly Student's tests of the patients' own slopes, where
// the fit is not singular.
TEST(RepeatedEffects, OfEqualTimesAreTheTestsOfSlopesAtEachPoint)
{
  const RepeatedCohort cohort(4);
  const RepeatedEffects effects = cohort.Effects("", "months");
  ASSERT_EQ(effects.Terms.size(), 1U);
  EXPECT_EQ(effects.Formula.Text(), "~ months");
  EXPECT_EQ(effects.UnfoundPoints, 0);
  EXPECT_LT(effects.Singular.sum(), 1000.0);
  const Eigen::MatrixXd displacements =
      CoefficientsOf(cohort.Group) * effects.Surface.PerCoefficient.transpose();
  const Eigen::RowVector4d slope = Eigen::RowVector4d(-3.0, -1.0, 1.0, 3.0) / 60.0; // 6 months
  const RepeatedTerm& term = effects.Terms[0];
  for (Eigen::Index point = 0; point < displacements.cols(); ++point)
  {
    Eigen::ArrayXd slopes(PatientCount);
    for (int i = 0; i < PatientCount; ++i)
    {
      slopes[i] = slope.dot(displacements.col(point).segment<4>(4 * i));
    }
    EXPECT_NEAR(term.Columns[0].PerUnit[point], slopes.mean(), 1e-10);
    if (effects.Singular[point] == 0.0)
    {
      // The criterion is flat to 1e-11 at its minimum, so variances are right to about 1e-5.
      EXPECT_NEAR(std::pow(term.Statistic[point], 2) / FOfMean(slopes), 1.0, 1e-3);
      EXPECT_NEAR(term.Columns[0].HalfWidth[point],
                  StudentQuantile(0.95, 19.0) * std::abs(slopes.mean() / term.Statistic[point]),
                  1e-6);
    }
  }
  EXPECT_LT(term.Discovery.minCoeff(), 0.01);
}

TEST(RepeatedEffects, FiguresThatAreCovariatesOrDoNotVaryAreLeftOut)
{
  const RepeatedCohort cohort(3);
  const RepeatedEffects effects = cohort.Effects("~ volume_ml + months", "");
  std::string names;
  for (const RepeatedFigure& figure : effects.Figures)
  {
    names += figure.Name + " ";
  }
  EXPECT_EQ(names,
            "semi_axis_1_mm semi_axis_2_mm semi_axis_3_mm "); // the radius follows the volume
}

TEST(RepeatedEffects, WithoutSlopesThatCanBeToldHaveInterceptsAlone)
{
  const RepeatedCohort cohort(2); // all at the same two times
  std::vector<std::string> notes;
  const RepeatedEffects effects = cohort.Effects("~ months", "months", &notes);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("only intercepts of patient are random"), std::string::npos);
  EXPECT_EQ(effects.RandomText(), "random intercept of each patient");
  EXPECT_EQ(effects.Slopes.maxCoeff(), 0.0);
  EXPECT_NEAR(effects.Modes[0].Tests[0].F, cohort.Effects("~ months", "").Modes[0].Tests[0].F,
              1e-12);
}

TEST(RepeatedEffects, CasesWithoutPatientAreOmitted)
{
  const RepeatedCohort cohort(3);
  std::string table = ReadAll(cohort.Folder / "scans.csv");
  table.replace(table.find("c_4,p1"), 6, "c_4,NA");
  WriteAll(cohort.Folder / "scans.csv", table);
  std::vector<std::string> notes;
  const RepeatedEffects effects = cohort.Effects("~ months", "", &notes);
  EXPECT_EQ(effects.Design.Cases.size(), 59U);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_NE(notes[0].find("1 of 60 cases lack a value of patient"), std::string::npos);
}

TEST(RepeatedEffects, FilesHaveAllFiguresAndMapsByName)
{
  const RepeatedCohort cohort(4);
  const RepeatedEffects effects = cohort.Effects("~ months * group", "months");
  const std::filesystem::path folder = cohort.Folder.Path();
  WriteRepeatedEffects(cohort.Group, effects, folder);
  const auto surface = ReadSurface(folder / "effects.vtp");
  for (const char* name :
       {"months:groupb (mm)", "months:groupb 95% half width (mm)", "months:group t",
        "months:group p", "months:group q", "sd between patients (mm)", "sd of slopes (mm)",
        "sd within patients (mm)", "singular"})
  {
    EXPECT_NE(surface->GetPointData()->GetArray(name), nullptr) << name;
  }
  const std::string table = ReadAll(folder / "repeated.csv");
  EXPECT_NE(table.find("\nvolume_ml,months:group,months:groupb,"), std::string::npos);
  EXPECT_NE(table.find("\nmode_1,months:group,months:groupb,"), std::string::npos);
  EXPECT_EQ(table.find("\narea_mm2,"), std::string::npos) << "it is the same everywhere";
  EXPECT_NE(ReadAll(folder / "repeated_variances.csv").find("\nmode_1,"), std::string::npos);
  EXPECT_NE(ReadAll(folder / "effects.csv").find("\nmonths:group,1,80,20,"), std::string::npos);
  EXPECT_NE(ReadAll(folder / "design.csv").find("\nc_7,1,18,1,"), std::string::npos);
}

TEST(RepeatedEffects, SectionIsWellFormedAndSaysWhatIsSingular)
{
  const RepeatedCohort cohort(3);
  RepeatedEffects effects = cohort.Effects("~ months + group", "");
  effects.Modes[0].Fit.IsSingular = true;
  effects.Singular.setZero();
  effects.Singular.head(7).setOnes();
  ReportPage page;
  AddRepeatedEffects(page, effects);
  const std::string html = page.Body();
  EXPECT_EQ(MarkupError("<html><body>" + html + "</body></html>"), "");
  EXPECT_EQ(html.find("c_17"), std::string::npos);
  for (const std::string& text :
       {html, RepeatedEffectText(effects), RepeatedEffectMethods(effects)})
  {
    EXPECT_NE(text.find("60 cases of 20 patients, 20 with several"), std::string::npos);
    EXPECT_NE(text.find("7 of 2562 points have a singular fit"), std::string::npos) << text;
  }
}

TEST(RepeatedEffects, AreRefusedInOneSentence)
{
  const RepeatedCohort cohort(2);
  const auto refusal = [&](const CovariateRequest& request)
  {
    std::vector<std::string> notes;
    return test::MessageOf([&] { CovariateModel(cohort.Group, request, notes, {}); });
  };
  CovariateRequest request = cohort.Request("~ group", "");
  request.Repeated = {"", "months"};
  EXPECT_NE(refusal(request).find("a time needs"), std::string::npos);
  request.Repeated = {"subject", ""};
  EXPECT_NE(refusal(request).find("no column subject"), std::string::npos);
  request.Repeated = {"case", ""};
  EXPECT_NE(refusal(request).find("none has several"), std::string::npos);
  request.Repeated = {"patient", "group"};
  EXPECT_NE(refusal(request).find("the time group is no number"), std::string::npos);
  request.Repeated = {"patient", "year"};
  EXPECT_NE(refusal(request).find("no column year"), std::string::npos);
  request = cohort.Request("", "");
  EXPECT_NE(refusal(request).find("need a formula"), std::string::npos);
  request = cohort.Request("~ group", "");
  request.Effects.BeyondModes = 2;
  EXPECT_NE(refusal(request).find("beyond modes"), std::string::npos);
}
} // namespace
} // namespace palpate::repeated_effects_test
