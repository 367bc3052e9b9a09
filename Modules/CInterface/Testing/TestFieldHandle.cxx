#include "Handles.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

namespace palpate::field_handle_test
{
namespace
{
// Minus the distance from the middle of a cube of 41 nodes a millimetre apart, mm.
std::vector<float> Ball()
{
  std::vector<float> values;
  for (int k = -20; k <= 20; ++k)
  {
    for (int j = -20; j <= 20; ++j)
    {
      for (int i = -20; i <= 20; ++i)
      {
        values.push_back(-std::sqrt(static_cast<float>(i * i + j * j + k * k)));
      }
    }
  }
  return values;
}

constexpr int Size[3] = {41, 41, 41};
constexpr double Spacing[3] = {1.0, 1.0, 1.0};
// Turned by a quarter around z: the first axis is +y, the second -x.
constexpr double Axes[9] = {0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0};
constexpr double Origin[3] = {20.0, -20.0, -20.0};

TEST(FieldHandle, ObjectIsWhereValuesReachTheIsoValue)
{
  const std::vector<float> values = Ball();
  palpate_error error{};
  const test::Owned<palpate_field> field(
      palpate_field_create(Size, Origin, Spacing, Axes, values.data(), -10.0, &error));
  ASSERT_NE(field, nullptr) << error.text;
  const double inside[3] = {0.0, 0.0, 9.9};
  const double outside[3] = {0.0, 0.0, 10.1};
  EXPECT_EQ(palpate_field_is_inside(field.get(), inside), 1);
  EXPECT_EQ(palpate_field_is_inside(field.get(), outside), 0);
}

TEST(FieldHandle, IsTouched)
{
  const std::vector<float> values = Ball();
  palpate_error error{};
  const test::Owned<palpate_field> field(
      palpate_field_create(Size, Origin, Spacing, Axes, values.data(), -10.0, &error));
  ASSERT_NE(field, nullptr) << error.text;
  const test::Owned<palpate_scene> scene(palpate_scene_create());
  ASSERT_EQ(palpate_scene_add_field(scene.get(), 3, field.get(), &test::Stiff, &error), 1)
      << error.text;
  const test::Owned<palpate_tracker> tool(palpate_tracker_create(scene.get(), &error));
  ASSERT_NE(tool, nullptr) << error.text;
  const double above[3] = {0.0, 0.0, 15.0};
  const double probe[3] = {0.0, 0.0, 10.0};
  palpate_contact contact;
  ASSERT_EQ(palpate_tracker_follow(tool.get(), above, &contact), 1);
  ASSERT_EQ(palpate_tracker_follow(tool.get(), probe, &contact), 1);
  EXPECT_EQ(contact.id, 3);
  EXPECT_NEAR(contact.depth, 1.0, 0.1) << "a shell of points, which is a tenth of a voxel rough";
}

TEST(FieldHandle, RefusesBadGridsAndEmptyObjects)
{
  const std::vector<float> values = Ball();
  palpate_error error{};
  const double mirrored[9] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, -1.0};
  EXPECT_EQ(palpate_field_create(Size, Origin, Spacing, mirrored, values.data(), -10.0, &error),
            nullptr);
  EXPECT_NE(std::strlen(error.text), 0U);
  const int flat[3] = {41, 41, 1};
  EXPECT_EQ(palpate_field_create(flat, Origin, Spacing, Axes, values.data(), -10.0, &error),
            nullptr);
  EXPECT_EQ(palpate_field_create(Size, Origin, Spacing, Axes, values.data(), 1.0, &error), nullptr);
}
} // namespace
} // namespace palpate::field_handle_test
