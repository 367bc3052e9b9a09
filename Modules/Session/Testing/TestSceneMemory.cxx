#include "ImageWriter.h"
#include "InputError.h"
#include "LabelImages.h"
#include "SceneKeeper.h"
#include "SteadyClock.h"
#include "TemporaryFolder.h"
#include "TouchRun.h"

#include "vtkPointData.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate
{
namespace
{
bool GoOn(double, const std::string&)
{
  return true;
}

// A bowl of 2 mm of bone in an image of 0.5 mm voxels, and a hand that strokes it.
class SceneMemoryTest : public testing::Test
{
protected:
  static constexpr double Radius = 22.0; // mm

  void SetUp() override
  {
    test::LabelGrid grid;
    grid.Size = {{100, 100, 100}};
    grid.Spacing = {{0.5, 0.5, 0.5}};
    grid.CenterOnOrigin();
    const auto image =
        test::MakeLabelImage<short>(grid, [](double, double, double) { return false; });
    for (vtkIdType voxel = 0; voxel < image->GetNumberOfPoints(); ++voxel)
    {
      double place[3];
      image->GetPoint(voxel, place);
      const double away = std::abs(std::hypot(place[0], place[1], place[2]) - Radius);
      image->GetPointData()->GetScalars()->SetTuple1(voxel, std::round(400.0 * (2.0 - away)));
    }
    WriteImage(this->ImagePath, image);
    this->Bone.File = this->ImagePath;
    this->Bone.Iso = 400.0;
    this->Bone.IsSeen = false;
  }

  TouchSettings Settings(std::optional<double> megabytes) const
  {
    TouchSettings settings;
    settings.Structures = {this->Bone};
    settings.Tool.Radius = 1.0;
    settings.Scale = 1.0;
    settings.MemoryMegabytes = megabytes;
    return settings;
  }
  static TouchScript Script()
  {
    TouchScript script;
    script.SweepSpeed = 90.0;
    script.Duration = 2.0;
    return script;
  }

  test::TemporaryFolder Folder;
  std::filesystem::path ImagePath = Folder / "bowl.nrrd";
  TouchStructureSettings Bone;
};

TEST_F(SceneMemoryTest, WhatIsFeltOnDemandHasTheBitsOfWhatIsInMemory)
{
  for (const FieldInterpolation method :
       {FieldInterpolation::Trilinear, FieldInterpolation::TricubicBSpline})
  {
    this->Bone.Interpolation = method;
    const PreparedTouch whole = PrepareTouch(this->Settings({}), Script(), GoOn);
    const std::size_t bytes = whole.Structures[0].Touch.Model->Bytes();
    const auto file = this->Folder / "session.touch";
    const TouchResult expected = RunTouch(whole, {true, file, {}, {}}, GoOn);
    EXPECT_EQ(expected.CoarseTicks, 0u);
    EXPECT_GT(expected.TouchedSeconds.at(0), 0.5);
    const double budget = 0.6e-6 * static_cast<double>(bytes);
    const PreparedTouch less = PrepareTouch(this->Settings(budget), Script(), GoOn);
    EXPECT_LE(less.Structures[0].Touch.Model->Bytes(), 1e6 * budget);
    const TouchResult felt = RunTouch(less, {true, this->Folder / "less.touch", {}, {}}, GoOn);
    EXPECT_EQ(felt.CoarseTicks, 0u);
    EXPECT_EQ(felt.MissingParts, "");
    EXPECT_EQ(CompareTouch(less, file).DifferentTicks, 0u);
    EXPECT_EQ(CompareTouch(whole, this->Folder / "less.touch").DifferentTicks, 0u);
    const OnDemandCounts counts = less.Structures[0].OnDemand->Counts();
    EXPECT_GT(counts.Versions, 10u);
    EXPECT_GE(counts.KeptSpeed, 100.0);
  }
}

TEST_F(SceneMemoryTest, WithoutABudgetNothingIsOnDemand)
{
  const TouchStructures made = MakeTouchStructures(this->Settings({}), false, GoOn);
  EXPECT_EQ(made.Touched.at(0).OnDemand, nullptr);
  EXPECT_EQ(made.Account.MemoryBudget, 0u);
}

TEST_F(SceneMemoryTest, WhatIsDrawnByItsFieldStaysWhole)
{
  this->Bone.IsSeen = true;
  const TouchStructures looked = MakeTouchStructures(this->Settings(1.0), true, GoOn);
  EXPECT_EQ(looked.Touched.at(0).OnDemand, nullptr);
  EXPECT_NE(looked.Touched.at(0).Looks.Field, nullptr);
  const TouchStructures unlooked = MakeTouchStructures(this->Settings(1.0), false, GoOn);
  EXPECT_NE(unlooked.Touched.at(0).OnDemand, nullptr);
}

TEST_F(SceneMemoryTest, TheAccountSaysWhatIsInMemory)
{
  const TouchStructures made = MakeTouchStructures(this->Settings(1.5), false, GoOn);
  EXPECT_EQ(made.Account.MemoryBudget, 1500000u);
  const SceneItem& contact = made.Account.Structures.at(0).Contact;
  EXPECT_NE(contact.Is.find("on demand"), std::string::npos) << contact.Is;
  EXPECT_EQ(contact.Bytes, made.Touched.at(0).Touch.Model->Bytes());
  EXPECT_LE(contact.Bytes, 1500000u);
  EXPECT_EQ(made.Touched[0].Represented, contact.Is);
}

TEST_F(SceneMemoryTest, ABudgetThatIsTooSmallIsRefusedByName)
{
  try
  {
    MakeTouchStructures(this->Settings(0.01), false, GoOn);
    FAIL() << "made of nothing";
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find("memory_mb"), std::string::npos) << error.what();
  }
}

// As in real time: a thread looks where the servo left the probe.
TEST_F(SceneMemoryTest, AKeeperFollowsTheProbeOnItsOwnThread)
{
  const TouchStructures made = MakeTouchStructures(this->Settings(1.5), false, GoOn);
  const std::shared_ptr<OnDemandField> field = made.Touched.at(0).OnDemand;
  const auto probe = std::make_shared<LatestValue<PlainVector3>>();
  const SteadyClock clock;
  SceneKeeper keeper({{field}, nullptr}, probe);
  keeper.Start(clock);
  for (const double x : {-20.0, 20.0, -20.0})
  {
    const std::uint64_t before = field->Counts().Versions;
    probe->Publish(Vector3(x, 0.0, 0.0));
    while (field->Counts().Versions == before)
    {
      std::this_thread::yield();
    }
  }
  keeper.Stop();
  EXPECT_EQ(keeper.Problem(), "");
  EXPECT_TRUE(field->Newest()->Covers({-20.0, 0.0, 0.0}, 2.0));
  EXPECT_FALSE(field->Newest()->Covers({20.0, 0.0, 0.0}, 2.0));
}
} // namespace
} // namespace palpate
