#include "Handles.h"
#include "SceneHandle.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace palpate::scene_handle_test
{
namespace
{
TEST(SceneHandle, RefusesIdsThatAreUsedOrNotPositive)
{
  const auto scene = test::BallScene();
  const auto ball = test::BallModel();
  palpate_error error{};
  EXPECT_EQ(palpate_scene_add_model(scene.get(), 7, ball.get(), &test::Stiff, &error), 0);
  EXPECT_NE(std::strstr(error.text, "id"), nullptr);
  EXPECT_EQ(palpate_scene_add_model(scene.get(), 0, ball.get(), &test::Stiff, &error), 0);
  EXPECT_EQ(palpate_scene_add_model(scene.get(), -3, ball.get(), &test::Stiff, nullptr), 0);
  EXPECT_EQ(scene->Scene.Structures.size(), 1U);
}

TEST(SceneHandle, RefusesBadLawsAndStaysAsItWas)
{
  const auto scene = test::BallScene();
  const auto ball = test::BallModel();
  palpate_error error{};
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const palpate_law& law : {palpate_law{-1.0, 0.0, 0.0, 0.0}, palpate_law{nan, 0.0, 0.0, 0.0},
                                 palpate_law{0.5, -1.0, 0.0, 0.0}, palpate_law{0.5, 0.0, 0.1, 0.2}})
  {
    EXPECT_EQ(palpate_scene_add_model(scene.get(), 8, ball.get(), &law, &error), 0)
        << law.stiffness << " " << law.damping << " " << law.static_friction;
  }
  EXPECT_EQ(scene->Scene.Structures.size(), 1U);
}

TEST(SceneHandle, RefusesLawsThatNoDeviceRenders)
{
  const auto scene = test::BallScene();
  const auto ball = test::BallModel();
  palpate_error error{};
  for (const palpate_law& law :
       {palpate_law{1000.0, 0.0, 0.0, 0.0}, palpate_law{100.1, 0.0, 0.0, 0.0},
        palpate_law{0.5, 11.0, 0.0, 0.0}, palpate_law{0.5, 0.0, 1e3, 1.0}})
  {
    EXPECT_EQ(palpate_scene_add_model(scene.get(), 8, ball.get(), &law, &error), 0);
    EXPECT_NE(std::strstr(error.text, "check its unit"), nullptr) << error.text;
  }
  EXPECT_EQ(palpate_scene_set_tool_radius(scene.get(), 101.0, &error), 0);
  const double center[3] = {0.0, 0.0, 0.0};
  EXPECT_EQ(palpate_scene_set_workspace(scene.get(), center, 1e4, &error), 0);
  const palpate_law stiffest{100.0, 10.0, 10.0, 10.0};
  EXPECT_EQ(palpate_scene_add_model(scene.get(), 8, ball.get(), &stiffest, &error), 1);
}

TEST(SceneHandle, RefusesBadMeshesToolsAndPlaces)
{
  const auto scene = test::BallScene();
  palpate_error error{};
  const double points[9] = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0};
  const int32_t beyond[3] = {0, 1, 3};
  EXPECT_EQ(palpate_scene_add_mesh(scene.get(), 8, points, 3, beyond, 1, &test::Stiff, &error), 0);
  EXPECT_EQ(palpate_scene_set_tool_radius(scene.get(), -1.0, &error), 0);
  EXPECT_EQ(scene->Scene.Tool.Radius(), 1.0);
  EXPECT_EQ(palpate_scene_set_workspace(scene.get(), points, 0.0, &error), 0);
  EXPECT_EQ(palpate_scene_set_workspace(scene.get(), points, 2.0, &error), 1);
  EXPECT_EQ(scene->Place->Scale, 2.0);
}
} // namespace
} // namespace palpate::scene_handle_test
