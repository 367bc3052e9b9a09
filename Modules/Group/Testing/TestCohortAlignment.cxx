#include "CohortAlignment.h"

#include "CsvRecords.h"
#include "DecimalText.h"
#include "InputError.h"
#include "ModelFile.h"
#include "ModelMeasures.h"
#include "Progress.h"
#include "RandomShapes.h"
#include "TemporaryFolder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>

namespace palpate::cohort_alignment_test
{
namespace
{
using palpate::test::CsvRecordsIn;
using palpate::test::Random;
using palpate::test::TemporaryFolder;

void AddTo(CohortGroup& group, const std::string& name, const OrganModel& model)
{
  CohortRow row;
  row.Case = name;
  row.Result.Structure.Label = 1;
  group.Rows.push_back(row);
  BodyMoments body;
  EXPECT_TRUE(MeasureBody(std::get<RadialModel>(model), body).IsOk());
  group.Bodies.push_back(body);
  group.Models.push_back(model);
}

/// An organ turned about z by 0, 5, 10, ... degrees, and then by half a turn.
CohortGroup TurnedGroup()
{
  Random random(95);
  const RadialModel organ(5, test::RandomOrgan(random, 5).Coefficients(), Vector3::Zero());
  CohortGroup group;
  for (const double degrees : {0.0, 5.0, 10.0, -5.0, -10.0, 180.0})
  {
    const Matrix3 turn =
        Eigen::AngleAxisd(degrees * M_PI / 180.0, Vector3::UnitZ()).toRotationMatrix();
    AddTo(group, "turned by " + std::to_string(static_cast<int>(degrees)),
          TurnShape(organ, {Matrix3::Identity(), turn}));
  }
  EXPECT_TRUE(FindShapeModes(CoefficientsOf(group), group.Modes).IsOk());
  return group;
}

double AlignmentNumber(const CsvRecord& record, const std::string& column)
{
  return ParseNumber(*record.Find(column)).value();
}

TEST(CohortAlignment, TableTellsTurnsAndAmbiguousCases)
{
  CohortGroup group = TurnedGroup();
  const TemporaryFolder folder;
  WriteModel(folder / "mean.json", {group.Models.front(), {}});
  const CohortAlignment alignment = AlignCohortGroup(group, false, folder / "mean.json");
  EXPECT_EQ(group.Axes, AlignmentAxes::Procrustes);
  const auto table = CsvRecordsIn(AlignmentTable(group, alignment));
  ASSERT_EQ(table.size(), 6U);
  EXPECT_NEAR(AlignmentNumber(table[2], "turn_deg"), 10.0, 1e-6);
  EXPECT_NEAR(AlignmentNumber(table[2], "residual_mm"), 0.0, 1e-8);
  EXPECT_EQ(*table[2].Find("ambiguous"), "no");
  EXPECT_EQ(*table[5].Find("ambiguous"), "yes");
  EXPECT_EQ(std::count_if(group.Notes.begin(), group.Notes.end(),
                          [](const CohortNote& note)
                          { return note.Text.find("ambiguous") != std::string::npos; }),
            1);
  EXPECT_EQ(group.Notes.front().Case, "turned by 180");
}

TEST(CohortAlignment, AlignedCopiesHaveNoModes)
{
  CohortGroup group = TurnedGroup();
  group.Rows.pop_back();
  group.Models.pop_back();
  group.Bodies.pop_back();
  AlignCohortGroup(group, true, {});
  // RMS, mm: what the turns leave is rounding.
  EXPECT_LE(group.Modes.Deviations.size() == 0 ? 0.0 : group.Modes.Deviations[0], 1e-6);
}

TEST(CohortAlignment, FilesTellOfTheAlignment)
{
  CohortGroup group = TurnedGroup();
  const CohortAlignment alignment = AlignCohortGroup(group, false, {});
  const TemporaryFolder folder;
  CohortOutput output;
  output.Alignment = &alignment;
  WriteCohortGroup(group, output, folder / "out", "test");
  EXPECT_EQ(CsvRecordsIn(test::ReadAll(folder / "out/alignment.csv")).size(), 6U);
  EXPECT_NE(test::ReadAll(folder / "out/cohort.html").find("generalised Procrustes"),
            std::string::npos);
  EXPECT_NE(test::ReadAll(folder / "out/mean.json").find("procrustes"), std::string::npos);
  WriteCohortGroup(group, {}, folder / "out", "test");
  EXPECT_FALSE(std::filesystem::exists(folder / "out/alignment.csv"));
}

TEST(CohortAlignment, ReferenceOfHigherDegreeRaisesThatOfTheCases)
{
  CohortGroup group = TurnedGroup();
  const TemporaryFolder folder;
  const auto& first = std::get<RadialModel>(group.Models.front());
  WriteModel(folder / "mean.json", {first.WithDegree(7), {}});
  AlignCohortGroup(group, false, folder / "mean.json");
  EXPECT_EQ(DegreeOf(group.Models.back()), 7);
  EXPECT_EQ(group.Modes.Mean.size(), 64);
}

TEST(CohortAlignment, CancelThrowsAndKeepsTheGroup)
{
  CohortGroup group = TurnedGroup();
  const Eigen::MatrixXd before = CoefficientsOf(group);
  EXPECT_THROW(AlignCohortGroup(group, false, {}, [](double done) { return done < 0.4; }),
               Cancelled);
  EXPECT_EQ(CoefficientsOf(group), before);
  EXPECT_EQ(group.Axes, AlignmentAxes::Patient);
}

TEST(CohortAlignment, RejectsReferenceOfAnotherKind)
{
  CohortGroup group = TurnedGroup();
  const TemporaryFolder folder;
  const auto& first = std::get<RadialModel>(group.Models.front());
  WriteModel(folder / "surface.json", {SurfaceModel::FromModel(first), {}});
  EXPECT_THROW(AlignCohortGroup(group, false, folder / "surface.json"), InputError);
  EXPECT_THROW(AlignCohortGroup(group, false, folder / "missing.json"), InputError);
}
} // namespace
} // namespace palpate::cohort_alignment_test
