#include "FitCases.h"
#include "FitStructure.h"

#include "LabelImages.h"
#include "ShapeVector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace palpate::model_choice_test
{
namespace
{
using test::FitMask;
using test::HasNote;
using Outcome = palpate::FitResult::Outcome;

double Largest(const std::array<double, 3>& spacing)
{
  return *std::max_element(spacing.begin(), spacing.end());
}

// Whether the automatic choice is that of the kind whose distances are better by far, and is said.
FitResult ExpectSurfaceChosen(vtkImageData* mask, const std::string& name)
{
  FitResult chosen = FitMask(mask);
  EXPECT_EQ(chosen.State, Outcome::Fitted) << name << ": " << chosen.Message;
  EXPECT_EQ(chosen.Radial(), nullptr) << name;
  EXPECT_TRUE(HasNote(chosen, "a surface model was taken")) << name;
  return chosen;
}

// A straight tube with round ends, on voxels of 2.5 mm. A surface through their stairs stays within
// half a voxel.
TEST(ModelChoice, TakesSurfaceModelsOfStraightCapsules)
{
  constexpr double Voxel = 2.5;
  constexpr double Radius = 9.0;
  for (const double length : {60.0, 80.0, 100.0, 120.0})
  {
    const double half = 0.5 * length - Radius;
    palpate::test::LabelGrid grid;
    grid.Spacing = {Voxel, Voxel, Voxel};
    grid.Size = {14, 14, static_cast<int>(length / Voxel) + 6};
    grid.CenterOnOrigin();
    const auto mask = palpate::test::MakeLabelImage(
        grid, [half](double x, double y, double z)
        { return std::hypot(x, y, z - std::clamp(z, -half, half)) < Radius; });
    const FitResult chosen = ExpectSurfaceChosen(mask, std::to_string(length));
    EXPECT_GT(chosen.Dice, 0.995) << length;
    EXPECT_LT(chosen.ModelToMask.Maximum, 0.5 * Voxel) << length;
  }
}

// Rough bodies of the sizes of organs, mm.
bool IsInAorta(double x, double y, double z)
{
  return std::hypot(x, y) < 10.0 && std::abs(z) < 45.0;
}

// Half an ellipsoid over a dome, with a hollow for the heart.
bool IsInLung(double x, double y, double z)
{
  return std::hypot(x / 60.0, y / 78.0, (z + 20.0) / 130.0) < 1.0 && z > -70.0 &&
         std::hypot(x, y, z + 120.0) > 70.0 && std::hypot(x + 60.0, y + 30.0, z + 20.0) > 45.0;
}

// An ellipsoid cut to a wedge, with a hollow for the gallbladder.
bool IsInLiver(double x, double y, double z)
{
  return std::hypot(x / 110.0, y / 80.0, z / 75.0) < 1.0 &&
         z < 40.0 - 0.35 * std::max(x + 20.0, 0.0) && z + 0.5 * std::max(x, 0.0) > -70.0 &&
         std::hypot(x - 10.0, y - 50.0, z + 50.0) > 28.0;
}

vtkSmartPointer<vtkImageData> MaskOf(bool (*isInside)(double, double, double),
                                     std::array<double, 3> size, std::array<double, 3> spacing)
{
  palpate::test::LabelGrid grid;
  grid.Spacing = spacing;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    grid.Size[axis] = static_cast<int>(size[axis] / spacing[axis]) + 6;
  }
  grid.CenterOnOrigin();
  return palpate::test::MakeLabelImage(grid, isInside);
}

TEST(ModelChoice, TakesSurfaceModelsOfOrgansThatARadiusRoundsOff)
{
  const FitResult aorta =
      ExpectSurfaceChosen(MaskOf(IsInAorta, {20.0, 20.0, 92.0}, {3.0, 3.0, 3.0}), "aorta");
  EXPECT_GT(aorta.Dice, 0.995);
  EXPECT_LT(aorta.ModelToMask.Maximum, 1.5);
  for (const std::array<double, 3>& spacing :
       {std::array<double, 3>{4.0, 4.0, 4.0}, std::array<double, 3>{2.5, 2.5, 5.0}})
  {
    const FitResult lung =
        ExpectSurfaceChosen(MaskOf(IsInLung, {130.0, 160.0, 240.0}, spacing), "lung");
    EXPECT_LT(lung.ModelToMask.Maximum, Largest(spacing));
    const FitResult liver =
        ExpectSurfaceChosen(MaskOf(IsInLiver, {230.0, 170.0, 160.0}, spacing), "liver");
    EXPECT_LT(liver.ModelToMask.Maximum, Largest(spacing));
  }
}

// By the rules of earlier files, overlap decides.
TEST(ModelChoice, GoesByOverlapWithTheFirstRules)
{
  FitSettings settings;
  settings.Rules = 1;
  const auto aorta = MaskOf(IsInAorta, {20.0, 20.0, 92.0}, {3.0, 3.0, 3.0});
  const FitResult before = FitMask(aorta, settings);
  settings.Model = FitSettings::ModelKind::Radial;
  const FitResult radial = FitMask(aorta, settings);
  ASSERT_NE(before.Radial(), nullptr);
  ASSERT_NE(radial.Radial(), nullptr);
  EXPECT_EQ(VectorOf(before.Model), VectorOf(radial.Model));
}

bool IsInBox(double x, double y, double z)
{
  return std::abs(x) < 28.0 && std::abs(y) < 18.0 && std::abs(z) < 13.0;
}

// A box has edges at every degree. A fifth of the geometric mean of 1 and 2 mm is 0.28 mm.
TEST(DegreeGoal, ByTheVoxelsIsReachedAndNoWorseThanTheGivenDegree)
{
  const auto box = MaskOf(IsInBox, {58.0, 38.0, 28.0}, {1.0, 1.0, 2.0});
  const double goal = 0.2 * std::sqrt(2.0);
  for (const FitSettings::ModelKind kind :
       {FitSettings::ModelKind::Radial, FitSettings::ModelKind::Automatic})
  {
    FitSettings settings;
    settings.Model = kind;
    const FitResult given = FitMask(box, settings);
    settings.Tolerance = 0.0;
    const FitResult searched = FitMask(box, settings);
    ASSERT_EQ(searched.State, Outcome::Fitted) << searched.Message;
    EXPECT_LE(searched.Rms, goal);
    EXPECT_GE(searched.Dice, given.Dice);
    EXPECT_LE(searched.ModelToMask.Percentile95, given.ModelToMask.Percentile95);
    EXPECT_EQ(DegreeOf(searched.Model) > DegreeOf(given.Model), given.Rms > goal);
    EXPECT_TRUE(HasNote(searched, "within the 0.283 mm that are a fifth of a voxel"));
  }
}

// Voxels that support a lower degree than the given one do not lower it.
TEST(DegreeGoal, ByTheVoxelsIsNeverBelowTheGivenDegree)
{
  const auto box = MaskOf(IsInBox, {58.0, 38.0, 28.0}, {6.0, 6.0, 6.0});
  FitSettings settings;
  settings.Tolerance = 0.0;
  const FitResult searched = FitMask(box, settings);
  ASSERT_EQ(searched.State, Outcome::Fitted) << searched.Message;
  EXPECT_GE(DegreeOf(searched.Model), settings.Degree);
}
} // namespace
} // namespace palpate::model_choice_test
