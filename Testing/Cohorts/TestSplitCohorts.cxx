#include "SplitCohorts.h"

#include "ModelFile.h"
#include "PhantomSampler.h"
#include "ProstateLikeModel.h"
#include "TemporaryFolder.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace palpate::split_cohorts_test
{
namespace
{
using test::BumpedCases;
using test::BumpedResult;
using test::SplitCohorts;
using test::TemporaryFolder;

constexpr int Cases = 16;
constexpr int Degree = 12;
constexpr double Height = 2.0; // mm
const test::BumpPlace& Place = test::BumpPlaces()[1];

RadialModel RandomGland(std::mt19937_64& random)
{
  std::normal_distribution<double> normal(0.0, 1.0);
  std::vector<double> coefficients = MakeProstateLikeModel(6, 1, Vector3::Zero()).Coefficients();
  for (double& coefficient : coefficients)
  {
    coefficient += normal(random);
  }
  return {6, coefficients, Vector3(normal(random), normal(random), normal(random))};
}

// On voxels of 0.9 x 0.9 x 2.5 mm.
vtkSmartPointer<vtkImageData> MaskOf(const RadialModel& gland)
{
  PhantomGrid grid;
  grid.Size = {84, 84, 26};
  grid.Spacing = {0.9, 0.9, 2.5};
  grid.CenterOn(Vector3::Zero());
  PhantomAppearance look;
  look.Subdivision = 1;
  return MakePhantom(gland, grid, look).Mask;
}

void Add(const RadialModel& model, CohortGroup& group)
{
  CohortRow row;
  row.Case = std::to_string(group.Rows.size());
  row.CenterWorld = model.CenterWorld();
  BodyMoments body;
  EXPECT_TRUE(MeasureBody(model, body).IsOk());
  group.Rows.push_back(row);
  group.Bodies.push_back(body);
  group.Models.emplace_back(RadialModel(model.Degree(), model.Coefficients(), Vector3::Zero()));
}

CohortGroup RandomGroup(int cases, std::uint64_t seed)
{
  CohortGroup group;
  std::mt19937_64 random(seed);
  for (int i = 0; i < cases; ++i)
  {
    Add(RandomGland(random), group);
  }
  EXPECT_TRUE(FindShapeModes(CoefficientsOf(group), group.Modes).IsOk());
  return group;
}

test::SurfaceBump BumpOf(const CohortGroup& group, double height = Height)
{
  return {std::get<RadialModel>(ShapeOf(group, -1, 0.0)), Place.Direction, height,
          test::BumpExtent};
}

/// Models fitted to masks, and files of those fitted to the masks with a bump, on other slices.
struct SmallCohort
{
  SmallCohort()
  {
    std::mt19937_64 random(7);
    std::vector<vtkSmartPointer<vtkImageData>> masks;
    for (int i = 0; i < Cases; ++i)
    {
      masks.push_back(MaskOf(RandomGland(random)));
      Add(test::RadialFitOf(masks.back(), Degree), this->Group);
    }
    EXPECT_TRUE(FindShapeModes(CoefficientsOf(this->Group), this->Group.Modes).IsOk());
    std::filesystem::create_directories(this->Folder / "flat");
    for (std::size_t row = 0; row < masks.size(); ++row)
    {
      const double shift = (static_cast<double>(row) + 0.5) / Cases - 0.5;
      this->Fit(masks[row], row, 0.0, shift, this->Folder / "flat");
      this->Fit(masks[row], row, Height, shift, this->Folder.Path());
    }
  }

  void Fit(vtkImageData* mask, std::size_t row, double height, double shift,
           const std::filesystem::path& folder) const
  {
    const CohortRow& gland = this->Group.Rows[row];
    const auto image =
        test::BumpedImage(mask, 1, gland.CenterWorld, BumpOf(this->Group, height), shift);
    WriteModel(folder / (gland.Case + ".json"), {test::RadialFitOf(image, Degree), {}});
  }

  TemporaryFolder Folder;
  CohortGroup Group;
};

TEST(SplitCohorts, MasksWithABumpGiveWhatModelsWithABumpGive)
{
  const SmallCohort cohort;
  SplitCohorts studies(cohort.Group, 1);
  const BumpedCases bumped = studies.WithBump(studies.BumpAt(Place, Height),
                                              studies.ReadCoefficients(cohort.Folder / "flat"),
                                              studies.ReadCoefficients(cohort.Folder.Path()));
  // Within 0.1 mm for voxels of 0.9 mm.
  EXPECT_NEAR(studies.Found(bumped).mean(), studies.InModelsDegree(bumped), 0.1);
  test::SplitSettings settings;
  settings.PerGroup = Cases / 2;
  settings.Permutations = 99;
  int ideal = 0;
  int masks = 0;
  for (int i = 0; i < 100; ++i)
  {
    const BumpedResult result = studies.Next(settings, bumped);
    ideal += result.Ideal.Told <= 0.05 ? 1 : 0;
    masks += result.Masks.Told <= 0.05 ? 1 : 0;
    ASSERT_NEAR(result.Masks.Estimate, result.Ideal.Estimate, 0.5);
  }
  EXPECT_GT(ideal, 10);
  EXPECT_GE(masks, ideal - 5);
}

TEST(SplitCohorts, BumpOfTheIdealDataIsExact)
{
  const CohortGroup group = RandomGroup(Cases, 8);
  SplitCohorts studies(group, 1);
  test::SplitSettings settings;
  settings.PerGroup = Cases / 2;
  settings.Permutations = 9;
  // As if the masks had none.
  BumpedCases bumped =
      studies.WithBump(BumpOf(group), CoefficientsOf(group), CoefficientsOf(group));
  const double truth = studies.True(bumped);
  EXPECT_NEAR(truth, Height, 0.1 * Height); // but for the centre's shift
  EXPECT_LT(truth, Height);
  // Sizes, and so shifts, differ between cases; the same for all is found exactly.
  bumped.Moved = bumped.Moved.colwise().mean().replicate(bumped.Moved.rows(), 1).eval();
  for (int i = 0; i < 10; ++i)
  {
    const BumpedResult result = studies.Next(settings, bumped);
    ASSERT_NEAR(result.Ideal.Estimate, result.Masks.Estimate + truth, 1e-9);
  }
}

TEST(SplitCohorts, NeedCasesForBothGroups)
{
  SplitCohorts studies(RandomGroup(2, 10), 1);
  test::SplitSettings settings;
  settings.PerGroup = 2;
  EXPECT_THROW(studies.Next(settings), std::runtime_error);
}

TEST(SplitCohorts, BodiesWithABumpAreCentredAgain)
{
  const CohortGroup group = RandomGroup(2, 9);
  const SplitCohorts studies(group, 1);
  const BumpedCases bumped =
      studies.WithBump(BumpOf(group), CoefficientsOf(group), CoefficientsOf(group));
  const Eigen::VectorXd moved = CoefficientsOf(group).row(0) + bumped.MovedCoefficients.row(0);
  BodyMoments before;
  BodyMoments after;
  ASSERT_TRUE(MeasureBody(std::get<RadialModel>(group.Models[0]), before).IsOk());
  ASSERT_TRUE(MeasureBody({6, {moved.begin(), moved.end()}, Vector3::Zero()}, after).IsOk());
  // The bump, which moves centres by 0.1 mm, is not of degree 6: the rest is its projection's.
  EXPECT_LT((after.CentroidWorld - before.CentroidWorld).norm(), 0.02);
}
} // namespace
} // namespace palpate::split_cohorts_test
