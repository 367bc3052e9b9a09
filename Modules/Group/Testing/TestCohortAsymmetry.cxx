#include "CohortAsymmetry.h"

#include "InputError.h"
#include "MarkupCheck.h"
#include "ReportPage.h"
#include "ShapeMirror.h"
#include "SurfaceFile.h"
#include "TemporaryFolder.h"

#include "vtkPointData.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <random>

namespace palpate::cohort_asymmetry_test
{
namespace
{
using namespace palpate::test;

constexpr int Degree = 3;
constexpr int Count = 16; // coefficients
constexpr double Offset = 1.5;
// Harmonics of degree 2: of order -2 x and y change its sign, of order 2 neither does.
constexpr int Antisymmetric = 4;
constexpr int Symmetric = 8;

PermutationSettings Flips()
{
  PermutationSettings settings;
  settings.Count = 499;
  return settings;
}

class SideCohort
{
public:
  void Add(const std::string& name, const Eigen::VectorXd& values)
  {
    this->Group.Rows.emplace_back();
    this->Group.Rows.back().Case = name;
    this->Group.Models.emplace_back(
        RadialModel(Degree, std::vector<double>(values.begin(), values.end()), Vector3::Zero()));
    this->Group.Bodies.emplace_back();
    this->Group.Bodies.back().Volume = 1000.0 * values[0];
  }
  // A shape of about 20 mm with noise of 0.2 mm.
  Eigen::VectorXd Shape()
  {
    Eigen::VectorXd values =
        Eigen::VectorXd::NullaryExpr(Count, [&] { return 0.2 * this->Normal(this->Random); });
    values[0] += 20.0 * std::sqrt(4.0 * M_PI);
    return values;
  }

  std::mt19937 Random{4};
  std::normal_distribution<double> Normal;
  CohortGroup Group;
};

Eigen::VectorXd Coefficients(const OrganModel& shape)
{
  const std::vector<double>& values = std::get<RadialModel>(shape).Coefficients();
  return Eigen::Map<const Eigen::VectorXd>(values.data(), Count);
}

/// Twelve individuals' left sides with `offset` more along one harmonic, and their right sides, the
/// mirror images of another shape; one has no right side.
struct PairedCohort : SideCohort
{
  explicit PairedCohort(double offset) : Table({})
  {
    std::vector<std::string> names;
    std::vector<std::string> patients;
    std::vector<std::string> sides;
    for (int i = 0; i < 25; ++i)
    {
      Eigen::VectorXd values = this->Shape();
      values[Symmetric] += i % 2 == 0 ? offset : 0.0;
      const RadialModel shape(Degree, {values.begin(), values.end()}, Vector3::Zero());
      names.push_back("c_" + std::to_string(i));
      patients.push_back("p" + std::to_string(i / 2));
      sides.emplace_back(i % 2 == 0 ? "L" : "right");
      this->Add(names.back(), i % 2 == 0 ? values : Coefficients(MirrorShape(shape)));
    }
    this->Table = CovariateTable(names);
    this->Table.Add("patient", patients);
    this->Table.Add("side", sides);
  }
  CohortAsymmetry Asymmetry()
  {
    const std::vector<SidePair> pairs =
        FindSidePairs(this->Group, this->Table, "patient", "side", this->Notes);
    MirrorRightSides(this->Group, pairs);
    return FindCohortAsymmetry(this->Group, pairs, Flips(), {});
  }

  CovariateTable Table;
  std::vector<std::string> Notes;
};

TEST(CohortAsymmetry, OfPairsIsTheOffsetOfLeftSides)
{
  PairedCohort cohort(Offset);
  const CohortAsymmetry asymmetry = cohort.Asymmetry();
  ASSERT_EQ(asymmetry.Individuals.size(), 12U);
  ASSERT_EQ(cohort.Notes.size(), 1U);
  EXPECT_NE(cohort.Notes[0].find("1 cases have no other side"), std::string::npos);
  // 2 n |mean / 2|^2 of the mean difference, whose noise is 0.2 sqrt(2 / 12) along each harmonic.
  EXPECT_NEAR(asymmetry.Anova.Side.Squares, 6.0 * Offset * Offset, 6.0);
  EXPECT_NEAR(asymmetry.Anova.Interaction.Mean(), 0.04, 0.01);
  EXPECT_LE(asymmetry.Points.WholeP, 0.005);
  EXPECT_LT(asymmetry.Points.FamilyP.minCoeff(), 0.05);
  EXPECT_EQ(asymmetry.Anova.Side.Degrees, Count);
  const SideDifference& one = asymmetry.Individuals[0];
  const double left = cohort.Group.Bodies[one.Rows.Left].Volume;
  const double right = cohort.Group.Bodies[one.Rows.Right].Volume;
  EXPECT_NEAR(one.VolumePercent, 200.0 * (left - right) / (left + right), 1e-12);
}

TEST(CohortAsymmetry, OfPairsWithoutOffsetIsNotSignificant)
{
  PairedCohort cohort(0.0);
  EXPECT_GT(cohort.Asymmetry().Points.WholeP, 0.01); // of one seed
}

TEST(CohortAsymmetry, OfTheMidlineIsTheOffsetThatMirroringTurnsRound)
{
  SideCohort cohort;
  for (int i = 0; i < 12; ++i)
  {
    Eigen::VectorXd values = cohort.Shape();
    values[Antisymmetric] += Offset;
    values[Symmetric] += 3.0;
    cohort.Add("c_" + std::to_string(i), values);
  }
  const CohortAsymmetry asymmetry = FindCohortAsymmetry(cohort.Group, {}, Flips(), {});
  EXPECT_FALSE(asymmetry.IsPaired);
  EXPECT_EQ(asymmetry.Anova.Side.Degrees, 6.0); // orders -2, 1 and 3 of degrees 1 to 3
  EXPECT_EQ(asymmetry.Anova.Individual.Degrees, 110.0);
  EXPECT_NEAR(asymmetry.Anova.Side.Squares, 24.0 * Offset * Offset, 8.0);
  EXPECT_LE(asymmetry.Points.WholeP, 0.005);
  // A place stands out as much as its mirror place is lower.
  EXPECT_NEAR(asymmetry.Points.Mean.maxCoeff(), -asymmetry.Points.Mean.minCoeff(), 0.01);
}

TEST(CohortAsymmetry, OfSymmetricShapesIsNone)
{
  SideCohort cohort;
  for (int i = 0; i < 5; ++i)
  {
    const Eigen::VectorXd values = cohort.Shape();
    const RadialModel shape(Degree, {values.begin(), values.end()}, Vector3::Zero());
    cohort.Add("c", 0.5 * (values + Coefficients(MirrorShape(shape))));
  }
  const CohortAsymmetry asymmetry = FindCohortAsymmetry(cohort.Group, {}, Flips(), {});
  EXPECT_EQ(asymmetry.Anova.Side.Squares, 0.0);
  EXPECT_EQ(asymmetry.Anova.Interaction.Squares, 0.0);
  EXPECT_EQ(asymmetry.Points.WholeP, 1.0);
}

// Ellipsoids with turned parameters, whose mirror images have others.
TEST(CohortAsymmetry, OfSurfacesDoesNotDependOnTheirParameters)
{
  SideCohort cohort;
  for (int i = 0; i < 4; ++i)
  {
    cohort.Add("c", cohort.Shape());
    const double n = std::sqrt(4.0 * M_PI / 3.0);
    // Coefficients of y, z and x of degree 1.
    const SurfaceModel ellipsoid(1, {std::vector<double>{0.0, 0.0, 0.0, 20.0 * n},
                                     {0.0, (15.0 + i) * n, 0.0, 0.0},
                                     {0.0, 0.0, 12.0 * n, 0.0}});
    cohort.Group.Models.back() = ellipsoid.Reparametrized(
        Eigen::AngleAxisd(0.1 + 0.8 * i, Vector3(0.3, 0.5, 0.8).normalized()).toRotationMatrix());
  }
  const CohortAsymmetry asymmetry = FindCohortAsymmetry(cohort.Group, {}, Flips(), {});
  EXPECT_LT(asymmetry.Anova.Side.Squares, 1e-12); // mm^2, of Newton's steps
  EXPECT_LT(asymmetry.Anova.Interaction.Squares, 1e-12);
}

TEST(CohortAsymmetry, FilesAndSectionHoldNumbersAndMaps)
{
  PairedCohort cohort(Offset);
  const CohortAsymmetry asymmetry = cohort.Asymmetry();
  const TemporaryFolder folder;
  WriteCohortAsymmetry(cohort.Group, asymmetry, folder.Path());
  EXPECT_NE(ReadAll(folder / "asymmetry.csv").find("\nc_0,c_1,"), std::string::npos);
  EXPECT_NE(ReadAll(folder / "asymmetry_anova.csv").find("\nside (directional),"),
            std::string::npos);
  const auto surface = ReadSurface(folder / "asymmetry.vtp");
  for (const char* name : {"left minus right (mm)", "sd (mm)", "t", "p", "p family", "q"})
  {
    EXPECT_NE(surface->GetPointData()->GetArray(name), nullptr) << name;
  }
  ReportPage page;
  AddCohortAsymmetry(page, asymmetry);
  EXPECT_EQ(MarkupError("<html><body>" + page.Body() + "</body></html>"), "");
  EXPECT_NE(asymmetry.Text().find("12 pairs"), std::string::npos);
}

TEST(CohortAsymmetry, RefusesWhatIsNoPairing)
{
  PairedCohort cohort(0.0);
  const auto refusal = [&](const std::string& individual, const std::string& side)
  {
    try
    {
      FindSidePairs(cohort.Group, cohort.Table, individual, side, cohort.Notes);
    }
    catch (const InputError& error)
    {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal("name", "side").find("no column name"), std::string::npos);
  EXPECT_NE(refusal("side", "patient").find("neither with l nor with r"), std::string::npos);
  EXPECT_NE(refusal("side", "side").find("two cases of one side"), std::string::npos);
  cohort.Group.Models.resize(2);
  cohort.Group.Rows.resize(2);
  EXPECT_THROW(FindCohortAsymmetry(cohort.Group, {}, Flips(), {}), InputError);
}
} // namespace
} // namespace palpate::cohort_asymmetry_test
