#include "GuidingGradient.h"
#include "ManualClock.h"
#include "Study.h"
#include "StudyPhantoms.h"

#include <gtest/gtest.h>

namespace palpate::felt_edges_test
{
namespace
{
constexpr double Edge = 16.0; // mm, radius of the ball of the phantom's volume

// Label 1, a ball of 9 mm around (-15, 0, 0), is corrected and felt.
class FeltEdgesTest : public testing::Test
{
protected:
  void SetUp() override
  {
    StudyState state = this->Phantom.State();
    state.Correction.StructureId = 1;
    this->Open.New(state);
    this->Settle();
  }
  void Settle()
  {
    while (!this->Open.Jobs().IsIdle())
    {
      this->Open.Jobs().WaitForResult();
      this->Open.Deliver();
    }
  }
  // Null: none.
  std::shared_ptr<const GuidingGradient> Force() const
  {
    const auto contacts = this->Open.Contacts();
    const auto& effects = contacts.at(0).Effects;
    const bool isThere = effects != nullptr && effects->Made.count("guiding gradient") > 0;
    return isThere ? std::dynamic_pointer_cast<const GuidingGradient>(
                         effects->Made.at("guiding gradient"))
                   : nullptr;
  }

  test::StudyPhantom Phantom;
  ManualClock Time;
  Study Open{this->Time};
};

TEST_F(FeltEdgesTest, PullGentlyTowardsTheVolumesEdgeWhileSwitchedOn)
{
  EXPECT_EQ(this->Force(), nullptr);
  this->Open.FeelEdges(true);
  this->Settle();
  EXPECT_EQ(this->Open.Edges().Problem(), "");
  const auto force = this->Force();
  ASSERT_NE(force, nullptr);
  const Vector3 out = Vector3(-1.0, 0.3, 0.2).normalized();
  for (const double distance : {1.0, 1.5})
  {
    const Vector3 inside = force->ForceWorld((Edge - distance) * out);
    const Vector3 outside = force->ForceWorld((Edge + distance) * out);
    EXPECT_GT(inside.dot(out), 0.02) << distance;
    EXPECT_LT(outside.dot(out), -0.02) << distance;
    EXPECT_LE(std::max(inside.norm(), outside.norm()), 0.3);
  }
  this->Open.FeelEdges(false);
  EXPECT_EQ(this->Force(), nullptr);
}

TEST_F(FeltEdgesTest, AreThoseOfThePresentVolumeAndStructure)
{
  this->Open.FeelEdges(true);
  this->Settle();
  ASSERT_NE(this->Force(), nullptr);
  StudyState next = this->Open.State();
  next.Correction.StructureId = 2; // which is not felt
  this->Open.Change("Correct another one", next);
  this->Settle();
  EXPECT_EQ(this->Force(), nullptr);
  this->Open.Undo();
  this->Settle();
  ASSERT_NE(this->Force(), nullptr);
  next = this->Open.State();
  next.VolumeFile.clear();
  this->Open.Change("Close the volume", next);
  this->Settle();
  EXPECT_EQ(this->Force(), nullptr);
}

TEST_F(FeltEdgesTest, ReachTheSceneAsAnEffectOfTheStructureOnly)
{
  this->Open.FeelEdges(true);
  this->Settle();
  SceneSettings scene = this->Open.State();
  this->Open.Edges().AddTo(scene);
  const TouchScene felt = MakeTouchScene(scene, this->Open.Contacts(), {});
  ASSERT_EQ(felt.Structures.at(0).Effects.size(), 1U);
  EXPECT_EQ(felt.Structures.at(0).Effects.front(), this->Force());
  EXPECT_EQ(this->Open.State().Structures.at(0).Number("gradient_n_mm"), 0.0)
      << "the study's state has no such number";
}

TEST_F(FeltEdgesTest, VolumeWithoutEdgesThereIsSaid)
{
  StudyState next = this->Open.State();
  test::LabelGrid grid;
  grid.Size = {{80, 60, 60}};
  grid.CenterOnOrigin();
  WriteImage(this->Phantom.Folder / "even.nii.gz",
             test::MakeLabelImage<short>(
                 grid, [](double, double, double) { return true; }, 700));
  next.VolumeFile = this->Phantom.Folder / "even.nii.gz";
  this->Open.Change("Open another volume", next);
  this->Settle();
  this->Open.FeelEdges(true);
  this->Settle();
  EXPECT_EQ(this->Force(), nullptr);
  EXPECT_NE(this->Open.Edges().Problem().find("no edges"), std::string::npos)
      << this->Open.Edges().Problem();
}
} // namespace
} // namespace palpate::felt_edges_test
