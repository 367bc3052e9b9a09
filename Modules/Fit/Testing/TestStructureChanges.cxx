#include "StructureChanges.h"

#include "FitCases.h"
#include "FitStructure.h"
#include "LabelImages.h"
#include "LabelParts.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>

namespace palpate::structure_changes_test
{
namespace
{
using test::CubesWhere;
using test::FitMask;
using test::HasNote;
using Outcome = palpate::FitResult::Outcome;

vtkSmartPointer<vtkImageData> Ball()
{
  return CubesWhere({30, 30, 30},
                    [](double x, double y, double z) { return std::hypot(x, y, z) < 11.0; });
}

// Of the voxels of 1 mm with a label.
double AllMilliliters(vtkImageData* mask)
{
  double voxels = 0.0;
  for (vtkIdType id = 0; id < mask->GetNumberOfPoints(); ++id)
  {
    voxels += mask->GetPointData()->GetScalars()->GetTuple1(id);
  }
  return 1e-3 * voxels;
}

// A ball with a hollow of 27 % of what it encloses.
vtkSmartPointer<vtkImageData> Shell()
{
  return CubesWhere({40, 40, 40},
                    [](double x, double y, double z)
                    {
                      const double radius = std::hypot(x, y, z);
                      return radius < 17.0 && radius > 11.0;
                    });
}

// A ball, and one of 27 % of both far from it.
vtkSmartPointer<vtkImageData> UnevenBalls()
{
  return CubesWhere({80, 40, 40},
                    [](double x, double y, double z) {
                      return std::hypot(x + 20.0, y, z) < 14.0 || std::hypot(x - 20.0, y, z) < 10.0;
                    });
}

constexpr std::array<FitSettings::ModelKind, 3> AllKinds{{FitSettings::ModelKind::Radial,
                                                          FitSettings::ModelKind::Surface,
                                                          FitSettings::ModelKind::Automatic}};

// What a model of one kind may not change, one of another may not.
TEST(StructureChanges, AreRefusedByOneRuleForAllKinds)
{
  for (const FitSettings::ModelKind kind : AllKinds)
  {
    FitSettings settings;
    settings.Model = kind;
    const FitResult shell = FitMask(Shell(), settings);
    EXPECT_EQ(shell.State, Outcome::Refused);
    EXPECT_EQ(shell.Message.rfind("has a cavity of ", 0), 0U) << shell.Message;
    EXPECT_NE(shell.OptionHint.find("--repair"), std::string::npos) << shell.OptionHint;
    const FitResult balls = FitMask(UnevenBalls(), settings);
    EXPECT_EQ(balls.State, Outcome::Refused);
    EXPECT_NE(balls.Message.find("parts"), std::string::npos) << balls.Message;
    EXPECT_NE(balls.OptionHint.find("--component each"), std::string::npos) << balls.OptionHint;
    EXPECT_EQ(balls.WindowHint.find("--"), std::string::npos) << balls.WindowHint;
  }
}

TEST(StructureChanges, AreSaidWhereTheyAreAccepted)
{
  for (const FitSettings::ModelKind kind : AllKinds)
  {
    FitSettings settings;
    settings.Model = kind;
    settings.Repairs = true;
    settings.MinimumDice = 0.5;
    const FitResult shell = FitMask(Shell(), settings);
    ASSERT_EQ(shell.State, Outcome::Fitted) << shell.Message;
    EXPECT_EQ(shell.Message.rfind("is modelled with 1 cavity filled, ", 0), 0U) << shell.Message;
    EXPECT_EQ(shell.Message, "is modelled with " + ChangeText(shell));
  }
  FitSettings radial;
  radial.Model = FitSettings::ModelKind::Radial;
  radial.Repairs = true;
  const FitResult balls = FitMask(UnevenBalls(), radial);
  ASSERT_EQ(balls.State, Outcome::Fitted) << balls.Message;
  EXPECT_EQ(balls.Message.rfind("is modelled with 1 part left out, 26.8 % of the volume", 0), 0U)
      << balls.Message;
  EXPECT_EQ(ChangeText(FitMask(Ball())), "");
}

// Scenes of earlier versions are touched as they were.
TEST(StructureChanges, AreAcceptedByTheFirstRules)
{
  FitSettings settings;
  settings.Rules = 1;
  const FitResult shell = FitMask(Shell(), settings);
  EXPECT_EQ(shell.State, Outcome::Fitted) << shell.Message;
  EXPECT_NE(shell.Message.find("1 cavity filled"), std::string::npos) << shell.Message;
}

// A cavity of 93 % of the diameter that is accepted: 2.3 of 2.5 mm in radius, in voxels of half a
// millimetre.
TEST(StructureChanges, NearALimitGetANote)
{
  for (const double radius : {1.5, 2.35})
  {
    palpate::test::LabelGrid grid;
    grid.Spacing = {0.5, 0.5, 0.5};
    grid.Size = {60, 60, 60};
    grid.CenterOnOrigin();
    const FitResult result =
        FitMask(palpate::test::MakeLabelImage(grid,
                                              [radius](double x, double y, double z)
                                              {
                                                const double place = std::hypot(x, y, z);
                                                return place < 13.0 && place > radius;
                                              }));
    ASSERT_EQ(result.State, Outcome::Fitted) << result.Message;
    EXPECT_EQ(HasNote(result, "accepted near a limit: a cavity of"), radius > 2.0) << radius;
  }
}

TEST(LabelParts, AreNamedBySideWhereTwoLieBesideEachOther)
{
  Segmentation segmentation;
  segmentation.Layers.emplace_back(UnevenBalls());
  Segment structure;
  structure.Label = structure.Value = 1;
  structure.Name = "Hippocampus";
  std::string leftOut;
  const std::vector<StructureToFit> sides = PartsOf(segmentation, structure, {}, leftOut);
  ASSERT_EQ(sides.size(), 2U);
  // The larger is at negative x of patient LPS: to the right.
  EXPECT_EQ(sides[0].Structure.Name, "right Hippocampus");
  EXPECT_EQ(sides[1].Structure.Name, "left Hippocampus");
  EXPECT_TRUE(leftOut.empty()) << leftOut;
  double milliliters = 0.0;
  for (const StructureToFit& side : sides)
  {
    EXPECT_TRUE(side.Settings.WantsOneComponent());
    const FitResult fitted = FitStructure(segmentation, side.Structure, side.Settings);
    ASSERT_EQ(fitted.State, Outcome::Fitted) << fitted.Message;
    EXPECT_GT(fitted.Dice, 0.97);
    milliliters += fitted.MaskMilliliters;
  }
  EXPECT_NEAR(milliliters, AllMilliliters(UnevenBalls()), 1e-9);
  segmentation.IsOriented = false;
  EXPECT_EQ(PartsOf(segmentation, structure, {}, leftOut)[0].Structure.Name, "part 1 Hippocampus");
}

TEST(LabelParts, LeaveOutSpecks)
{
  Segmentation segmentation;
  segmentation.Layers.emplace_back(
      CubesWhere({60, 40, 40}, [](double x, double y, double z)
                 { return std::hypot(x, y, z) < 15.0 || (x > 24.0 && std::hypot(y, z) < 1.0); }));
  Segment structure;
  structure.Label = structure.Value = 1;
  std::string leftOut;
  const std::vector<StructureToFit> parts = PartsOf(segmentation, structure, {}, leftOut);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].Structure.Name, "");
  EXPECT_EQ(leftOut.rfind("1 part of less than", 0), 0U) << leftOut;
}
} // namespace
} // namespace palpate::structure_changes_test
