#include "CohortCorrespondence.h"
#include "CohortCorrespondencePage.h"
#include "ParameterColors.h"

#include "CsvRecords.h"
#include "MarkupCheck.h"
#include "ModelMeasures.h"
#include "Progress.h"
#include "ReportPage.h"
#include "SurfacePhantoms.h"
#include "TemporaryFolder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <gtest/gtest.h>
#include <set>

namespace palpate::cohort_correspondence_test
{
namespace
{
using palpate::test::CsvRecordsIn;
using palpate::test::Random;
using palpate::test::TemporaryFolder;

constexpr std::size_t Flipped = 4;
constexpr std::size_t Far = 7;

std::string SectionOf(const CohortGroup& group, const CohortCorrespondence& found, bool showsNames)
{
  ReportPage page;
  AddCohortCorrespondence(page, group, found, showsNames);
  return page.Body();
}

/// Ten variants of a bent tube. The parameters of one are turned by half a turn, another is larger.
CohortGroup FlippedGroup()
{
  Random random(401);
  const SurfaceModel tube = test::BumpyTube(random, 8);
  CohortGroup group;
  for (std::size_t i = 0; i < 10; ++i)
  {
    std::array<std::vector<double>, 3> coefficients;
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::vector<double> relief = test::RandomCoefficients(random, 8, 1.0);
      std::vector<double>& sums = coefficients[static_cast<std::size_t>(axis)];
      sums = tube.Coefficients(axis);
      for (std::size_t k = 0; k < sums.size(); ++k)
      {
        sums[k] = (i == Far ? 1.5 : 1.0) * (k == 0 ? 0.0 : sums[k] + 0.3 * relief[k]);
      }
    }
    OrganModel model = SurfaceModel(8, coefficients);
    if (i == Flipped)
    {
      const Matrix3 turn = Eigen::AngleAxisd(M_PI, Vector3::UnitZ()).toRotationMatrix();
      model = TurnShape(model, {Matrix3::Identity(), turn});
    }
    CohortRow row;
    row.Case = "patient & " + std::to_string(i);
    row.Result.Structure.Label = 1;
    group.Rows.push_back(row);
    BodyMoments body;
    EXPECT_TRUE(MeasureBody(std::get<SurfaceModel>(model), body).IsOk());
    group.Bodies.push_back(body);
    group.Models.push_back(model);
  }
  EXPECT_TRUE(FindShapeModes(CoefficientsOf(group), group.Modes).IsOk());
  return group;
}

std::size_t CountOf(const std::string& text, const std::string& part)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
  {
    ++count;
  }
  return count;
}

TEST(CohortCorrespondence, InjectedFlipIsListedAndOthersAreNot)
{
  CohortGroup group = FlippedGroup();
  const CohortCorrespondence found = FindCohortCorrespondence(group, {});
  ASSERT_EQ(found.Cases.size(), 10U);
  const auto table = CsvRecordsIn(CorrespondenceTable(group, found));
  ASSERT_EQ(table.size(), 10U);
  for (std::size_t i = 0; i < table.size(); ++i)
  {
    const bool isFlipped = *table[i].Find("case") == "patient & 4";
    EXPECT_EQ(*table[i].Find("flipped"), isFlipped ? "yes" : "no") << i;
    EXPECT_EQ(*table[i].Find("turned") == "parameters" || !isFlipped, true);
    EXPECT_GE(found.Cases[i == 0 ? 0 : i - 1].Found.Distance, found.Cases[i].Found.Distance);
  }
  EXPECT_EQ(found.Cases.front().Row, Flipped);
}

TEST(CohortCorrespondence, FarCaseIsAnOutlierButNotFlipped)
{
  CohortGroup group = FlippedGroup();
  const CohortCorrespondence found = FindCohortCorrespondence(group, {});
  EXPECT_EQ(found.Cases[1].Row, Far);
  for (const CorrespondingCase& one : found.Cases)
  {
    EXPECT_EQ(one.IsOutlier, one.Row == Far || one.Row == Flipped) << one.Row;
  }
}

TEST(CohortCorrespondence, NotesNameFlipAndOutliers)
{
  CohortGroup group = FlippedGroup();
  FindCohortCorrespondence(group, {});
  const auto notes = [&](const std::string& part)
  {
    std::set<std::string> cases;
    for (const CohortNote& note : group.Notes)
    {
      if (note.Text.find(part) != std::string::npos)
      {
        cases.insert(note.Case);
      }
    }
    return cases;
  };
  EXPECT_EQ(notes("flipped"), std::set<std::string>{"patient & 4"});
  EXPECT_EQ(notes("more than usual"), (std::set<std::string>{"patient & 4", "patient & 7"}));
}

TEST(CohortCorrespondence, PageShowsEachCaseAndMarksFlipAndOutlier)
{
  CohortGroup group = FlippedGroup();
  const CohortCorrespondence found = FindCohortCorrespondence(group, {});
  const std::string section = SectionOf(group, found, false);
  EXPECT_EQ(test::MarkupError("<html>" + section + "</html>"), "");
  EXPECT_EQ(CountOf(section, "<figure"), 11U); // and the mean
  EXPECT_EQ(CountOf(section, "class=\"marked\""), 2U);
  EXPECT_EQ(CountOf(section, ", flipped ("), 2U); // caption and label
  EXPECT_EQ(section.find("patient"), std::string::npos);
  EXPECT_NE(section.find("1 flipped, 2 outliers"), std::string::npos);
  const std::string named = SectionOf(group, found, true);
  EXPECT_NE(named.find("patient &amp; 4: "), std::string::npos);
}

TEST(CohortCorrespondence, TableIsWrittenAndRemovedWithTheGroup)
{
  CohortGroup group = FlippedGroup();
  const CohortCorrespondence found = FindCohortCorrespondence(group, {});
  const TemporaryFolder folder;
  CohortOutput output;
  output.Correspondence = &found;
  WriteCohortGroup(group, output, folder / "out", "test");
  EXPECT_EQ(CsvRecordsIn(test::ReadAll(folder / "out/correspondence.csv")).size(), 10U);
  EXPECT_NE(test::ReadAll(folder / "out/cohort.html").find(">Correspondence</h2>"),
            std::string::npos);
  WriteCohortGroup(group, {}, folder / "out", "test");
  EXPECT_FALSE(std::filesystem::exists(folder / "out/correspondence.csv"));
}

TEST(CohortCorrespondence, TwoCasesAreNotComparedAndCancelThrows)
{
  CohortGroup group = FlippedGroup();
  EXPECT_THROW(FindCohortCorrespondence(group, [](double) { return false; }), Cancelled);
  group.Rows.resize(2);
  group.Models.resize(2);
  const CohortCorrespondence found = FindCohortCorrespondence(group, {});
  EXPECT_TRUE(found.Cases.empty());
  EXPECT_EQ(SectionOf(group, found, false), "");
}

// So a flip or a turn is seen at once.
TEST(ParameterColor, NoTurnOfACubeLeavesThePatternAsItIs)
{
  Random random(402);
  const std::vector<Vector3> directions = test::RandomDirections(random, 500);
  std::array<int, 3> order{{0, 1, 2}};
  do
  {
    for (unsigned signs = 0; signs < 8; ++signs)
    {
      Matrix3 turn = Matrix3::Zero();
      for (unsigned axis = 0; axis < 3; ++axis)
      {
        turn(order[axis], axis) = (signs >> axis & 1U) != 0U ? -1.0 : 1.0;
      }
      if (turn.isIdentity())
      {
        continue;
      }
      const auto changed = std::count_if(directions.begin(), directions.end(),
                                         [&](const Vector3& u)
                                         { return ParameterColor(u) != ParameterColor(turn * u); });
      EXPECT_GT(changed, 200) << turn; // a swap of two axes keeps four octants at least in part
    }
  } while (std::next_permutation(order.begin(), order.end()));
}
} // namespace
} // namespace palpate::cohort_correspondence_test
