#include "AllocationCounter.h"
#include "ComplianceAtlas.h"
#include "ComplianceMaps.h"
#include "ElasticContactModel.h"
#include "ElasticForce.h"
#include "Handles.h"
#include "ModelFile.h"
#include "SomeMaps.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

namespace palpate::tracker_handle_test
{
namespace
{
test::Owned<palpate_tracker> ToolIn(const palpate_scene* scene)
{
  palpate_error error{};
  test::Owned<palpate_tracker> tool(palpate_tracker_create(scene, &error));
  EXPECT_NE(tool, nullptr) << error.text;
  return tool;
}

palpate_contact At(palpate_tracker* tool, double x, double y, double z)
{
  const double place[3] = {x, y, z};
  palpate_contact contact{};
  EXPECT_EQ(palpate_tracker_follow(tool, place, &contact), 1);
  return contact;
}

// A mesh a hundredth smaller than the sphere: both push.
TEST(TrackerHandle, ForcesOfStructuresAddUp)
{
  const auto scene = test::BallScene();
  constexpr int Frequency = 40;
  std::vector<double> points(3 * palpate_mesh_point_count(Frequency));
  std::vector<int32_t> triangles(3 * palpate_mesh_triangle_count(Frequency));
  ASSERT_EQ(palpate_model_mesh(test::BallModel().get(), Frequency, points.data(), nullptr,
                               triangles.data(), nullptr),
            1);
  for (double& coordinate : points)
  {
    coordinate *= 0.99;
  }
  palpate_error error{};
  ASSERT_EQ(palpate_scene_add_mesh(scene.get(), 8, points.data(), points.size() / 3,
                                   triangles.data(), triangles.size() / 3, &test::Stiff, &error),
            1)
      << error.text;
  const auto tool = ToolIn(scene.get());
  At(tool.get(), 0.0, 25.0, 0.0);
  const palpate_contact contact = At(tool.get(), 0.0, 20.0, 0.0);
  EXPECT_EQ(contact.id, 7);
  EXPECT_NEAR(contact.depth, 1.0, 1e-9);
  EXPECT_NEAR(contact.proxy[1], 21.0, 1e-9);
  EXPECT_NEAR(contact.normal[1], 1.0, 1e-9);
  EXPECT_NEAR(contact.force[1], 0.5 * (1.0 + 0.8), 0.01) << "chords of the mesh are 0.02 mm low";
}

TEST(TrackerHandle, PlacesThatAreNotFiniteTouchNothing)
{
  const auto tool = ToolIn(test::BallScene().get());
  At(tool.get(), 0.0, 25.0, 0.0);
  const double nowhere[3] = {0.0, std::numeric_limits<double>::quiet_NaN(), 0.0};
  palpate_contact contact{};
  EXPECT_EQ(palpate_tracker_follow(tool.get(), nowhere, &contact), 0);
  EXPECT_EQ(contact.id, 0);
  EXPECT_EQ(contact.force[1], 0.0);
}

TEST(TrackerHandle, FollowingDoesNotAllocate)
{
  const auto tool = ToolIn(test::BallScene().get());
  At(tool.get(), 0.0, 25.0, 0.0);
  const std::size_t before = test::AllocationCount();
  const palpate_contact contact = At(tool.get(), 0.0, 20.0, 0.0);
  EXPECT_EQ(test::AllocationCount(), before);
  EXPECT_EQ(contact.id, 7);
}

TEST(TrackerHandle, ModelsThatYieldPushBackByTheirOwnForce)
{
  const test::TemporaryFolder folder;
  const std::string file = folder.Path() / "soft.json";
  const RadialModel model = test::SomeElasticModel();
  const auto maps = std::make_shared<const ComplianceMaps>(test::SomeMaps());
  WriteModel(file, {model, {}, maps});
  palpate_error error{};
  const test::Owned<palpate_model> soft(palpate_model_read(file.c_str(), &error));
  ASSERT_NE(soft, nullptr) << error.text;
  EXPECT_EQ(palpate_model_yields(soft.get()), 1);
  const test::Owned<palpate_scene> scene(palpate_scene_create());
  ASSERT_EQ(palpate_scene_set_tool_radius(scene.get(), 4.0, &error), 1);
  ASSERT_EQ(palpate_scene_add_model(scene.get(), 1, soft.get(), &test::Stiff, &error), 1)
      << error.text;
  const auto tool = ToolIn(scene.get());
  At(tool.get(), 1.0, 2.0, 30.0);
  const palpate_contact contact = At(tool.get(), 1.0, 2.0, 26.0);
  const ElasticForce wanted =
      ElasticForce::Of(ComplianceAtlas(*maps), model, Vector3::UnitZ(), 1.0, 4.0);
  EXPECT_NEAR(contact.depth, 1.0, 1e-9);
  EXPECT_NEAR(contact.force[2], wanted.ForceWorld.z(), 1e-6 * wanted.ForceWorld.z());
}
} // namespace
} // namespace palpate::tracker_handle_test
