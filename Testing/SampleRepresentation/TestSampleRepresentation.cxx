#include "SampleRepresentation.h"

#include "InputError.h"
#include "SceneBuilder.h"
#include "SceneFile.h"
#include "TradeCases.h"
#include "WholeFile.h"

#include <gtest/gtest.h>

namespace palpate::sample_representation_test
{
namespace
{
// One registration is all that the program needs to support the representation.
class SampleRepresentationTest : public testing::Test
{
protected:
  static void SetUpTestSuite() { AddSceneRepresentation(SampleRepresentation()); }

  SceneSettings SceneWith(double margin) const
  {
    SceneSettings scene = this->Mask.Scene;
    scene.Structures.front().Representation = "sphere";
    scene.Structures.front().SetNumber("sphere_margin_mm", margin);
    return scene;
  }

  test::MaskTrade Mask = test::SphereMask();
};

TEST_F(SampleRepresentationTest, RoundTripsInSceneFiles)
{
  const test::TemporaryFolder folder;
  const SceneSettings scene = this->SceneWith(1.5);
  WriteWholeFile(folder / "ball.scene.json", SceneText(scene, folder.Path()));
  EXPECT_TRUE(ReadScene(folder / "ball.scene.json").Structures.front() == scene.Structures.front());
  SceneSettings unknown = scene;
  unknown.Structures.front().Representation = "cube";
  WriteWholeFile(folder / "cube.scene.json", SceneText(unknown, folder.Path()));
  EXPECT_THROW(ReadScene(folder / "cube.scene.json"), InputError);
}

TEST_F(SampleRepresentationTest, CanBeTouched)
{
  for (const double margin : {0.0, 1.5})
  {
    const BuiltScene built = BuildScene(this->SceneWith(margin), test::GoOn);
    EXPECT_EQ(built.Touched.front().Represented, "sphere");
    const Vector3 size = built.Contacts.front().Contact->Model->BoundsWorld().sizes();
    EXPECT_NEAR(size.x(), 2.0 * (14.0 + margin), 0.1) << "the mask is a sphere of 14 mm";
  }
}

TEST_F(SampleRepresentationTest, RefusesOtherSources)
{
  SceneSettings scene = this->SceneWith(0.0);
  scene.Structures.front().Labels.clear();
  scene.Structures.front().Iso = 0.5;
  scene.Structures.front().SetNumber("sphere_margin_mm", 3.0);
  try
  {
    BuildScene(scene, test::GoOn);
    FAIL() << "built";
  }
  catch (const InputError& error)
  {
    EXPECT_NE(std::string(error.what()).find("since it is an image"), std::string::npos)
        << error.what();
  }
}

TEST_F(SampleRepresentationTest, IsComparedInTheTradeOff)
{
  StructureTrade trade = this->Mask.Trade();
  const std::vector<ContactSetting> candidates = trade.Candidates(test::GoOn);
  const auto sphere =
      std::find_if(candidates.begin(), candidates.end(),
                   [](const ContactSetting& one) { return KeyOf(one) == "sphere"; });
  ASSERT_NE(sphere, candidates.end());
  const TradeRow row = trade.Measure(*sphere, test::GoOn);
  EXPECT_EQ(row.State, TradeRow::Outcome::Measured) << row.Message;
  EXPECT_LT(row.SurfaceMean, 0.3) << "exact for a sphere, except for the voxels";
}
} // namespace
} // namespace palpate::sample_representation_test
