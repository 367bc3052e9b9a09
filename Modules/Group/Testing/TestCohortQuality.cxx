#include "CohortCorrespondence.h"
#include "CohortQuality.h"
#include "CohortQualityPage.h"

#include "CsvRecords.h"
#include "DecimalText.h"
#include "MarkupCheck.h"
#include "ModelMeasures.h"
#include "RandomShapes.h"
#include "ReportPage.h"
#include "SphericalHarmonicProjection.h"
#include "TemporaryFolder.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace palpate::cohort_quality_test
{
namespace
{
using palpate::test::CsvRecordsIn;
using palpate::test::Random;
using palpate::test::TemporaryFolder;

void AddCase(CohortGroup& group, const std::string& name, std::vector<double> coefficients)
{
  CohortRow row;
  row.Case = name;
  row.Result.Structure.Label = 1;
  group.Rows.push_back(row);
  const RadialModel model(5, std::move(coefficients), Vector3::Zero());
  BodyMoments body;
  EXPECT_TRUE(MeasureBody(model, body).IsOk());
  group.Bodies.push_back(body);
  group.Models.emplace_back(model);
}

/// Thirty normal variants of an organ; the last one has a bump of 8 mm on its left side.
CohortGroup BumpedGroup()
{
  Random random(91);
  CohortGroup group;
  const std::vector<double> organ = test::RandomOrgan(random, 5).Coefficients();
  const std::vector<double> bump = ProjectOnHarmonics(
      5, 60, [](const Vector3& u) { return 8.0 * std::exp(6.0 * (u[0] - 1.0)); });
  for (int i = 0; i < 30; ++i)
  {
    std::vector<double> coefficients = organ;
    const std::vector<double> relief = test::RandomCoefficients(random, 5, 1.0);
    for (std::size_t k = 0; k < organ.size(); ++k)
    {
      coefficients[k] += relief[k] + (i == 29 ? bump[k] : 0.0);
    }
    AddCase(group, "patient & " + std::to_string(i), coefficients);
  }
  EXPECT_TRUE(FindShapeModes(CoefficientsOf(group), group.Modes).IsOk());
  return group;
}

double Number(const CsvRecord& record, const std::string& column)
{
  return ParseNumber(*record.Find(column)).value();
}

TEST(CohortQuality, BumpedCaseIsTheMostUnusualAndItsBumpIsFound)
{
  const CohortGroup group = BumpedGroup();
  const CohortQuality quality = FindCohortQuality(group, {});
  ASSERT_EQ(quality.Distances.size(), 30U);
  EXPECT_EQ(quality.Distances[0].Row, 29U);
  EXPECT_LT(quality.Distances[0].Discovery, 0.05);
  EXPECT_GT(quality.Distances[0].LargestZ, 4.0);
  EXPECT_GT(quality.Surface.Points[quality.Distances[0].Point].normalized()[0], 0.9);
  EXPECT_GT(quality.Distances[1].P, 1e-3);
  for (std::size_t i = 1; i < 30; ++i)
  {
    EXPECT_LE(quality.Distances[i - 1].P, quality.Distances[i].P);
    EXPECT_LE(quality.Distances[i].P, quality.Distances[i].Discovery);
  }
}

TEST(CohortQuality, TablesHaveARowPerCaseAndPerNumberOfModes)
{
  const CohortGroup group = BumpedGroup();
  const CohortQuality quality = FindCohortQuality(group, {});
  const TemporaryFolder folder;
  WriteCohortGroup(group, {nullptr, false, &quality}, folder / "out", "test");
  const auto distances = CsvRecordsIn(test::ReadAll(folder / "out/distances.csv"));
  ASSERT_EQ(distances.size(), 30U);
  EXPECT_EQ(*distances[0].Find("case"), "patient & 29");
  EXPECT_EQ(*distances[0].Find("side"), "L");
  EXPECT_EQ(Number(distances[0], "mahalanobis"), quality.Distances[0].Mahalanobis);
  std::set<std::string> names;
  for (const CsvRecord& record : distances)
  {
    names.insert(*record.Find("case"));
  }
  EXPECT_EQ(names.size(), 30U);
  const auto model = CsvRecordsIn(test::ReadAll(folder / "out/model_quality.csv"));
  ASSERT_EQ(model.size(), 30U); // 0 to 29 modes
  EXPECT_EQ(Number(model.back(), "explained"), 1.0);
  EXPECT_GT(Number(model.front(), "generalisation_mm"), Number(model.back(), "generalisation_mm"));
  const std::string surface = test::ReadAll(folder / "out/distances.vtp");
  EXPECT_NE(surface.find("sd (mm)"), std::string::npos);
  EXPECT_NE(surface.find("z patient _ 29"), std::string::npos);
}

TEST(CohortQuality, GroupWithoutQualityRemovesFormerFiles)
{
  const CohortGroup group = BumpedGroup();
  const CohortQuality quality = FindCohortQuality(group, {10, 1});
  const TemporaryFolder folder;
  WriteCohortGroup(group, {nullptr, false, &quality}, folder / "out", "test");
  WriteCohortGroup(group, {}, folder / "out", "test");
  EXPECT_FALSE(std::filesystem::exists(folder / "out/distances.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder / "out/model_quality.csv"));
}

TEST(CohortQuality, PageNumbersCasesUnlessNamesAreAskedFor)
{
  const CohortGroup group = BumpedGroup();
  const CohortQuality quality = FindCohortQuality(group, {});
  const auto section = [&](bool showsNames)
  {
    ReportPage page;
    AddCohortQuality(page, group, quality, showsNames);
    return page.Body();
  };
  const std::string numbered = section(false);
  EXPECT_EQ(numbered.find("patient"), std::string::npos);
  EXPECT_NE(numbered.find("<td class=\"text\">30</td>"), std::string::npos);
  const std::string named = section(true);
  EXPECT_NE(named.find("<td class=\"text\">patient &amp; 29</td>"), std::string::npos);
  EXPECT_EQ(test::MarkupError("<html>" + named + "</html>"), "");
}

TEST(CohortMethods, NameVersionsAndSettingsButNoPathsOrCases)
{
  CohortGroup group = BumpedGroup();
  group.FitPrograms = {"palpate 7.8.9", "/home/someone/palpate"};
  group.FitSettings = {
      {"model", "radial"}, {"smoothing", "0.5"}, {"input", "secret"}, {"center", "/data/secret"}};
  const CohortQuality quality = FindCohortQuality(group, {300, 17});
  const CohortCorrespondence correspondence = FindCohortCorrespondence(group, {});
  CohortOutput output;
  output.Quality = &quality;
  output.Correspondence = &correspondence;
  const TemporaryFolder folder;
  WriteCohortGroup(group, output, folder / "out", "palpate 1.2.3");
  const std::string page = test::ReadAll(folder / "out/cohort.html");
  EXPECT_EQ(test::MarkupError(page), "");
  for (const char* part :
       {"30 shapes were described by the radius", "up to degree 5 (36 coefficients",
        "by palpate 7.8.9.", "Settings of all fits: model radial, smoothing 0.5.",
        "Sizes were not normalised", "29 are above rounding", "300 random shapes, seed 17",
        "weighted as in their geometric median", "Software: palpate 1.2.3, VTK "})
  {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(page.find("secret"), std::string::npos);
  EXPECT_EQ(page.find("/home"), std::string::npos);
  EXPECT_EQ(page.find("patient &amp;"), std::string::npos);
}

TEST(CohortQuality, TwoCasesHaveNoDistances)
{
  CohortGroup group = BumpedGroup();
  group.Rows.resize(2);
  group.Models.resize(2);
  group.Bodies.resize(2);
  ASSERT_TRUE(FindShapeModes(CoefficientsOf(group), group.Modes).IsOk());
  const CohortQuality quality = FindCohortQuality(group, {});
  EXPECT_TRUE(quality.Distances.empty());
  EXPECT_EQ(quality.Model.Generalisation.Values.size(), 2);
  const TemporaryFolder folder;
  WriteCohortGroup(group, {nullptr, false, &quality}, folder / "out", "test");
  EXPECT_TRUE(CsvRecordsIn(test::ReadAll(folder / "out/distances.csv")).empty());
}
} // namespace
} // namespace palpate::cohort_quality_test
