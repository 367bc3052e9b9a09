#include "SampleEffect.h"

#include "InputError.h"
#include "ModelFile.h"
#include "SceneBuilder.h"
#include "SceneFile.h"
#include "Servo.h"
#include "ServoScene.h"
#include "TemporaryFolder.h"
#include "WholeFile.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::sample_effect_test
{
namespace
{
bool GoOn(double /*fraction*/, const std::string& /*stage*/)
{
  return true;
}

// One registration is all that the program needs to support the effect.
class SampleEffectTest : public testing::Test
{
protected:
  static void SetUpTestSuite() { AddSceneEffectKind(SampleEffect::Kind()); }

  SampleEffectTest()
  {
    constexpr double Radius = 20.0; // mm
    WriteModel(this->Folder / "sphere.json",
               {RadialModel(0, {Radius * std::sqrt(4.0 * M_PI)}, Vector3::Zero()), {}});
  }
  SceneSettings SceneWith(const std::string& entry) const
  {
    WriteWholeFile(this->Folder / "scene.json",
                   R"({"format": "palpate-scene", "structures": [{"file": "sphere.json")" + entry +
                       "}]}");
    return ReadScene(this->Folder / "scene.json");
  }
  // N along z, with a point 1 mm below the top of the sphere and 0.5 N/mm.
  Vector3 ForceOf(SceneSettings scene) const
  {
    scene.Tool.Radius = 0.0;
    const BuiltScene built = BuildScene(scene, GoOn);
    auto touch = std::make_shared<TouchScene>(MakeTouchScene(built.Settings, built.Contacts, {}));
    std::vector<StructureFollower> followers;
    EXPECT_TRUE(StructureFollower::Make(touch->Structures.front(), *touch,
                                        ServoSettings().VelocityTimeConstant, followers)
                    .IsOk());
    FollowStep step;
    step.Passed = 1e-3;
    step.Last.PositionWorld = Vector3(0.0, 0.0, 20.5);
    step.Now.PositionWorld = Vector3(0.0, 0.0, 19.0);
    return followers.front().Follow(step);
  }

  test::TemporaryFolder Folder;
};

TEST_F(SampleEffectTest, RoundTripsInSceneFiles)
{
  const SceneSettings scene = this->SceneWith(R"(, "adhesion_n": 0.2)");
  EXPECT_EQ(scene.Structures.front().Number("adhesion_n"), 0.2);
  WriteWholeFile(this->Folder / "again.scene.json", SceneText(scene, this->Folder.Path()));
  EXPECT_TRUE(ReadScene(this->Folder / "again.scene.json") == scene);
  EXPECT_THROW(this->SceneWith(R"(, "adhesion_n": 5.1)"), InputError);
}

TEST_F(SampleEffectTest, AddsItsForce)
{
  const Vector3 plain = this->ForceOf(this->SceneWith(""));
  EXPECT_NEAR(plain.z(), 0.5, 1e-9);
  const Vector3 pulled = this->ForceOf(this->SceneWith(R"(, "adhesion_n": 0.2)"));
  EXPECT_NEAR((pulled - plain + Vector3(0.0, 0.0, 0.2)).norm(), 0.0, 1e-9);
}
} // namespace
} // namespace palpate::sample_effect_test
