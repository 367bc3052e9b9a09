#include "CohortGroup.h"
#include "CommandRun.h"
#include "CsvRecords.h"
#include "DecimalText.h"
#include "FilterRun.h"
#include "InputError.h"
#include "MarkupCheck.h"
#include "ModelFile.h"
#include "ModelMeasures.h"
#include "RandomOrientation.h"
#include "RandomShapes.h"
#include "SurfacePhantoms.h"
#include "TemporaryFolder.h"
#include "TurnedModel.h"
#include "WorstCase.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace palpate::cohort_group_test
{
namespace
{
using palpate::test::CsvRecordsIn;
using palpate::test::Random;
using palpate::test::TemporaryFolder;

/// A table of models in a folder.
class Cohort
{
public:
  void Add(const std::string& name, const OrganModel& model, int label = 1)
  {
    const std::string file = PlainFile(name) + "_" + std::to_string(label) + ".json";
    WriteModel(this->Folder / file, {model, {}});
    CohortRow row;
    row.Case = name;
    row.Model = file;
    row.Result.State = FitResult::Outcome::Fitted;
    row.Result.Structure.Label = label;
    row.Result.Model = model;
    row.Result.Dice = 0.97;
    this->Table.Add({row});
  }
  void AddFailure(const std::string& name)
  {
    CohortRow row;
    row.Case = name;
    row.Result.State = FitResult::Outcome::Refused;
    row.Result.Message = "is <hidden>";
    this->Table.Add({row});
  }
  CohortGroup Group(AlignmentAxes axes, const std::string& structure = {}) const
  {
    return MakeCohortGroup(this->Table, this->Folder.Path(), structure, axes);
  }

  TemporaryFolder Folder;
  CohortTable Table;

private:
  static std::string PlainFile(const std::string& name) { return name.substr(0, 1); }
};

// A mean and two modes along known coefficients, with uncorrelated scores of mean 0.
void AddKnownCases(Cohort& cohort)
{
  Random random(21);
  const RadialModel mean = palpate::test::RandomOrgan(random, 5);
  const double scores[4][2] = {{2.0, 0.5}, {-2.0, 0.5}, {2.0, -0.5}, {-2.0, -0.5}};
  const char* const names[4] = {"a", "b, with \"quotes\"", "c", "d"};
  for (int i = 0; i < 4; ++i)
  {
    std::vector<double> coefficients = mean.Coefficients();
    coefficients[6] += scores[i][0];
    coefficients[10] += scores[i][1];
    cohort.Add(names[i], RadialModel(5, coefficients, Vector3(10.0 * i, 3.0, -4.0)));
  }
}

// The same of a bent tube: a mode of its x coordinates.
void AddTubes(Cohort& cohort)
{
  Random random(22);
  const SurfaceModel mean = palpate::test::BumpyTube(random, 5);
  const double scores[3] = {1.0, 0.0, -1.0};
  for (int i = 0; i < 3; ++i)
  {
    std::vector<double> x = mean.Coefficients(0);
    x[20] += scores[i];
    const SurfaceModel tube(5, {x, mean.Coefficients(1), mean.Coefficients(2)});
    cohort.Add(std::string(1, static_cast<char>('t' + i)),
               tube.Transformed(Matrix3::Identity(), Vector3(10.0 * i, 3.0, -4.0)));
  }
}

const std::vector<double>& CoefficientsOf(const OrganModel& model)
{
  return std::get<RadialModel>(model).Coefficients();
}

double Field(const CsvRecord& record, const std::string& column)
{
  return ParseNumber(*record.Find(column)).value();
}

TEST(CohortGroup, FilesRestoreKnownMeanAndModes)
{
  Cohort cohort;
  AddKnownCases(cohort);
  const CohortGroup group = cohort.Group(AlignmentAxes::Patient);
  WriteCohortGroup(group, {}, cohort.Folder / "out", "test");
  Random random(21);
  const RadialModel mean = palpate::test::RandomOrgan(random, 5);
  const auto read = std::get<RadialModel>(ReadModel(cohort.Folder / "out/mean.json").Surface);
  palpate::test::WorstCase worst;
  for (std::size_t k = 0; k < mean.Coefficients().size(); ++k)
  {
    worst.Add(read.Coefficients()[k] - mean.Coefficients()[k]);
  }
  EXPECT_LE(worst.Value(), 1e-12); // mm; rounding of numbers of some tens
  const auto variances = CsvRecordsIn(palpate::test::ReadAll(cohort.Folder / "out/variance.csv"));
  ASSERT_EQ(variances.size(), 2U);
  EXPECT_NEAR(Field(variances[0], "deviation_mm"), std::sqrt(4.0 * 4.0 / 3.0), 1e-12);
  EXPECT_NEAR(Field(variances[1], "explained"), 0.25 / 4.25, 1e-12);
  const auto scores = CsvRecordsIn(palpate::test::ReadAll(cohort.Folder / "out/modes.csv"));
  ASSERT_EQ(scores.size(), 4U);
  EXPECT_EQ(*scores[1].Find("case"), "b, with \"quotes\"");
  EXPECT_NEAR(Field(scores[1], "mode_1"), -2.0, 1e-12);
  EXPECT_NEAR(Field(scores[2], "mode_2"), -0.5, 1e-12);
  const auto plus =
      std::get<RadialModel>(ReadModel(cohort.Folder / "out/mode_1_plus.json").Surface);
  EXPECT_NEAR(plus.Coefficients()[6] - mean.Coefficients()[6], 2.0 * std::sqrt(16.0 / 3.0), 1e-12);
}

TEST(CohortGroup, SurfaceModelsVaryInTheirThreeCoordinates)
{
  Cohort cohort;
  AddTubes(cohort);
  const CohortGroup group = cohort.Group(AlignmentAxes::Patient);
  WriteCohortGroup(group, {}, cohort.Folder / "out", "test");
  ASSERT_GE(group.Modes.Explained.size(), 1);
  EXPECT_GT(group.Modes.Explained[0], 0.99); // the rest is what the centroid moves
  // Standard deviation of -1, 0 and 1; the centroid hardly moves by a harmonic of degree 4.
  EXPECT_NEAR(group.Modes.Deviations[0], 1.0, 0.05);
  const auto coefficients =
      CsvRecordsIn(palpate::test::ReadAll(cohort.Folder / "out/coefficients.csv"));
  EXPECT_NEAR(Field(coefficients[0], "x_4_0") - Field(coefficients[2], "x_4_0"), 2.0, 1e-9);
  EXPECT_NEAR(Field(coefficients[0], "z_4_0"), Field(coefficients[2], "z_4_0"), 1e-9);
  const auto plus =
      std::get<SurfaceModel>(ReadModel(cohort.Folder / "out/mode_1_plus.json").Surface);
  EXPECT_EQ(plus.Degree(), 5);
  EXPECT_EQ(palpate::test::MarkupError(palpate::test::ReadAll(cohort.Folder / "out/cohort.html")),
            "");
}

TEST(CohortGroup, OmitsModelsOfTheRarerKind)
{
  Cohort cohort;
  AddKnownCases(cohort);
  AddTubes(cohort);
  const CohortGroup group = cohort.Group(AlignmentAxes::Patient);
  EXPECT_EQ(group.Rows.size(), 4U);
  EXPECT_EQ(std::count_if(group.Notes.begin(), group.Notes.end(),
                          [](const CohortNote& note)
                          { return note.Text.find("has a surface model") != std::string::npos; }),
            3);
}

TEST(CohortGroup, TablesHaveOneRowPerCase)
{
  Cohort cohort;
  AddKnownCases(cohort);
  const CohortGroup group = cohort.Group(AlignmentAxes::Patient);
  WriteCohortGroup(group, {}, cohort.Folder / "out", "test");
  const std::string table = palpate::test::ReadAll(cohort.Folder / "out/coefficients.csv");
  const auto coefficients = CsvRecordsIn(table);
  ASSERT_EQ(coefficients.size(), 4U);
  const std::size_t row = table.find('\n') + 1;
  EXPECT_EQ(std::count(&table[row], &table[table.find('\n', row)], ','), 36 + 1);
  const RadialModel& last = *cohort.Table.Rows()[3].Result.Radial();
  EXPECT_EQ(Field(coefficients[3], "c_0_0"), last.Coefficients()[0]);
  EXPECT_EQ(Field(coefficients[3], "c_1_-1"), last.Coefficients()[1]);
  EXPECT_EQ(Field(coefficients[3], "c_5_5"), last.Coefficients()[35]);
  const auto measures = CsvRecordsIn(palpate::test::ReadAll(cohort.Folder / "out/measures.csv"));
  EXPECT_NEAR(Field(measures[3], "volume_ml"), VolumeOf(last) / 1000.0, 1e-9);
  EXPECT_EQ(Field(measures[3], "dice"), 0.97);
}

TEST(CohortGroup, RotatedAndMovedCopiesAlignToOneShape)
{
  Random random(22);
  const RadialModel model = palpate::test::RandomOrgan(random, 6);
  Cohort cohort;
  cohort.Add("0", model);
  for (int copy = 1; copy < 5; ++copy)
  {
    const palpate::Matrix3 turn = palpate::test::RandomOrientation(random);
    cohort.Add(std::to_string(copy), palpate::test::TurnedModel(model, turn, {1.0, 20.0, -9.0}));
  }
  const CohortGroup group = cohort.Group(AlignmentAxes::Ellipsoid);
  palpate::test::WorstCase worst;
  for (const OrganModel& aligned : group.Models)
  {
    for (std::size_t k = 0; k < CoefficientsOf(aligned).size(); ++k)
    {
      worst.Add(CoefficientsOf(aligned)[k] - CoefficientsOf(group.Models.front())[k]);
    }
  }
  EXPECT_LE(worst.Value(), 1e-9); // mm; rounding over the distance of the second moments
}

TEST(CohortGroup, LowerDegreesArePaddedWithZeros)
{
  Cohort cohort;
  Random random(23);
  cohort.Add("a", palpate::test::RandomOrgan(random, 3));
  cohort.Add("b", palpate::test::RandomOrgan(random, 6));
  const CohortGroup group = cohort.Group(AlignmentAxes::Patient);
  EXPECT_EQ(CoefficientsOf(group.Models[0]).size(), 49U);
  EXPECT_EQ(CoefficientsOf(group.Models[0])[48], 0.0);
  EXPECT_EQ(group.Modes.Modes.cols(), 1);
}

TEST(CohortGroup, PageIsSelfContainedAndListsOmissions)
{
  Cohort cohort;
  AddKnownCases(cohort);
  cohort.AddFailure("x & y");
  WriteCohortGroup(cohort.Group(AlignmentAxes::Patient), {nullptr, true}, cohort.Folder / "out",
                   "test");
  const std::string html = palpate::test::ReadAll(cohort.Folder / "out/cohort.html");
  EXPECT_EQ(palpate::test::MarkupError(html), "");
  EXPECT_EQ(html.find("http"), std::string::npos);
  EXPECT_NE(html.find("4 shapes, degree 5"), std::string::npos);
  EXPECT_NE(html.find("Mode 2: 5.9 %"), std::string::npos);
  // A slider over nine images, of which the mean is shown.
  EXPECT_NE(html.find("aria-label=\"Mode 2\""), std::string::npos);
  EXPECT_NE(html.find("<div data-step=\"0\"><figure>"), std::string::npos);
  EXPECT_NE(html.find("<div data-step=\"-3\" hidden=\"hidden\"><figure>"), std::string::npos);
  EXPECT_NE(html.find("x &amp; y has no model and is omitted: is &lt;hidden&gt;"),
            std::string::npos);
}

/// Organs and tubes in turn, with other centres, in the order of `numbers`.
CohortGroup NumberedGroup(const std::vector<int>& numbers, bool isRadial, AlignmentAxes axes)
{
  Cohort cohort;
  for (const int number : numbers)
  {
    Random random(100 + static_cast<unsigned>(number));
    const Vector3 center(3.0 * number, -number, 40.0);
    const std::string name(1, static_cast<char>('a' + number));
    const RadialModel organ = palpate::test::RandomOrgan(random, 5);
    if (isRadial)
    {
      cohort.Add(name, RadialModel(5, organ.Coefficients(), center));
    }
    else
    {
      cohort.Add(name,
                 palpate::test::BumpyTube(random, 5).Transformed(Matrix3::Identity(), center));
    }
  }
  return cohort.Group(axes);
}

// As each is placed by itself.
TEST(CohortGroup, AddingAndRemovingCasesChangesNoOther)
{
  for (const AlignmentAxes axes : {AlignmentAxes::Patient, AlignmentAxes::Ellipsoid})
  {
    for (const bool isRadial : {true, false})
    {
      const Eigen::MatrixXd all = CoefficientsOf(NumberedGroup({0, 1, 2, 3, 4, 5}, isRadial, axes));
      const Eigen::MatrixXd some = CoefficientsOf(NumberedGroup({5, 0, 3}, isRadial, axes));
      EXPECT_EQ(some.row(0), all.row(5));
      EXPECT_EQ(some.row(1), all.row(0));
      EXPECT_EQ(some.row(2), all.row(3));
    }
  }
}

// Signs, too: the largest entry of a mode is positive.
TEST(CohortGroup, ReorderingCasesKeepsMeanAndModes)
{
  for (const bool isRadial : {true, false})
  {
    const CohortGroup group = NumberedGroup({0, 1, 2, 3, 4, 5}, isRadial, AlignmentAxes::Patient);
    const CohortGroup other = NumberedGroup({4, 2, 5, 1, 0, 3}, isRadial, AlignmentAxes::Patient);
    ASSERT_EQ(group.Modes.Modes.cols(), other.Modes.Modes.cols());
    // mm; rounding of sums of numbers of some 70, over the distance of the variances.
    EXPECT_LE((group.Modes.Mean - other.Modes.Mean).cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_LE((group.Modes.Deviations - other.Modes.Deviations).cwiseAbs().maxCoeff(), 1e-11);
    EXPECT_LE((group.Modes.Modes - other.Modes.Modes).cwiseAbs().maxCoeff(), 1e-10);
    EXPECT_LE((group.Modes.Scores.row(4) - other.Modes.Scores.row(0)).cwiseAbs().maxCoeff(), 1e-9);
  }
}

TEST(CohortGroup, ReadingReportsProgressAndCancels)
{
  Cohort cohort;
  AddKnownCases(cohort);
  std::vector<double> steps;
  const auto read = [&](double end)
  {
    return MakeCohortGroup(cohort.Table, cohort.Folder.Path(), {}, AlignmentAxes::Patient,
                           [&](double done)
                           {
                             steps.push_back(done);
                             return done < end;
                           });
  };
  EXPECT_EQ(read(2.0).Rows.size(), 4U);
  EXPECT_EQ(steps.size(), 8U); // read and placed
  EXPECT_TRUE(std::is_sorted(steps.begin(), steps.end()));
  EXPECT_THROW(read(0.1), Cancelled);
  EXPECT_THROW(read(0.6), Cancelled);
}

TEST(CohortGroup, SeveralStructuresRequireChoice)
{
  Cohort cohort;
  Random random(24);
  for (const char* name : {"a", "b", "c"})
  {
    cohort.Add(name, palpate::test::RandomOrgan(random, 2), 1);
    cohort.Add(name, palpate::test::RandomOrgan(random, 2), 2);
  }
  EXPECT_THROW(cohort.Group(AlignmentAxes::Patient), InputError);
  EXPECT_EQ(cohort.Group(AlignmentAxes::Patient, "2").Rows.size(), 3U);
  EXPECT_THROW(cohort.Group(AlignmentAxes::Patient, "3"), InputError);
}

// As of two folders whose cases have the same names.
TEST(CohortGroup, RepeatedCaseIsNamed)
{
  Cohort cohort;
  Random random(24);
  for (const char* name : {"a", "b", "b"})
  {
    cohort.Add(name, palpate::test::RandomOrgan(random, 2));
  }
  try
  {
    cohort.Group(AlignmentAxes::Patient, "1");
    ADD_FAILURE() << "accepted";
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find("more than one case b;"), std::string::npos)
        << error.what();
  }
}

TEST(CohortGroup, CommandRatesAlignsAndSynthesizes)
{
  Cohort cohort;
  AddKnownCases(cohort);
  cohort.Table.Write(cohort.Folder / "cohort.csv");
  const auto run = palpate::test::RunPalpate(
      {"cohort", ".", "--align", "procrustes", "--shape", "1:2"}, cohort.Folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_EQ(CsvRecordsIn(palpate::test::ReadAll(cohort.Folder / "alignment.csv")).size(), 4U);
  EXPECT_EQ(CsvRecordsIn(palpate::test::ReadAll(cohort.Folder / "distances.csv")).size(), 4U);
  EXPECT_GE(CsvRecordsIn(palpate::test::ReadAll(cohort.Folder / "model_quality.csv")).size(), 2U);
  const OrganModel shape = ReadModel(cohort.Folder / "shape.json").Surface;
  const OrganModel plus = ReadModel(cohort.Folder / "mode_1_plus.json").Surface;
  EXPECT_EQ(CoefficientsOf(shape), CoefficientsOf(plus));
  for (const auto& wrong : {std::vector<std::string>{"--scale"},
                            {"--align-to", "mean.json"},
                            {"--shape", "9:1"},
                            {"--align", "procrustes", "--align-to", "missing.json"}})
  {
    std::vector<std::string> words{"cohort", "."};
    words.insert(words.end(), wrong.begin(), wrong.end());
    EXPECT_EQ(palpate::test::RunPalpate(words, cohort.Folder.Path()).Code, 2) << wrong.front();
  }
}

TEST(CohortGroup, RejectsInvalidCohortWithOneMessage)
{
  const TemporaryFolder folder;
  palpate::test::WriteAll(folder / "cohort.csv", "case,mask\na,b\n");
  const auto run = palpate::test::RunPalpate({"cohort", "."}, folder.Path());
  EXPECT_EQ(run.Code, 2);
  EXPECT_NE(run.Errors.find("is not a cohort table"), std::string::npos) << run.Errors;
  EXPECT_EQ(palpate::test::RunPalpate({"cohort", "nowhere"}, folder.Path()).Code, 2);
  EXPECT_EQ(folder.EntryCount(), 1U);
}
} // namespace
} // namespace palpate::cohort_group_test
