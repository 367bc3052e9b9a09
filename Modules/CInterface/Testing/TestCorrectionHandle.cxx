#include "Handles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <vector>

namespace palpate::correction_handle_test
{
namespace
{
using namespace palpate::test;

constexpr int Side = 32;
constexpr int Size[3] = {Side, Side, Side};
constexpr double Origin[3] = {0.0, 0.0, 0.0};
constexpr double Spacing[3] = {1.0, 1.0, 1.0};
constexpr double Axes[9] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};

std::size_t VoxelAt(int i, int j, int k)
{
  return static_cast<std::size_t>((k * Side + j) * Side + i);
}

std::vector<uint8_t> Sphere()
{
  std::vector<uint8_t> mask(VoxelAt(0, 0, Side));
  for (int k = 0; k < Side; ++k)
  {
    for (int j = 0; j < Side; ++j)
    {
      for (int i = 0; i < Side; ++i)
      {
        mask[VoxelAt(i, j, k)] = std::hypot(i - 16, j - 16, k - 16) < 9.0 ? 1 : 0;
      }
    }
  }
  return mask;
}

std::vector<uint8_t> MaskOf(palpate_correction* correction)
{
  std::vector<uint8_t> mask(VoxelAt(0, 0, Side), 7);
  EXPECT_EQ(palpate_correction_mask(correction, mask.data(), nullptr), 1);
  return mask;
}

Owned<palpate_correction> CorrectionOf(const std::vector<uint8_t>& mask, const uint8_t* barrier)
{
  return Owned<palpate_correction>(
      palpate_correction_of_mask(mask.data(), barrier, Size, Origin, Spacing, Axes, nullptr));
}

TEST(CorrectionHandle, AMaskIsPulledEditedAndUndone)
{
  std::vector<uint8_t> start = Sphere();
  start[VoxelAt(16, 16, 16)] = 0;
  start[VoxelAt(1, 1, 1)] = 1;
  const auto correction = CorrectionOf(start, nullptr);
  ASSERT_NE(correction, nullptr);
  EXPECT_EQ(MaskOf(correction.get()), start);
  const palpate_pull pull{{25, 16, 16}, 4.0, 0, {0, 0, 0}, 4.0, 0.0};
  ASSERT_EQ(palpate_correction_remove_islands(correction.get(), nullptr), 1);
  ASSERT_EQ(palpate_correction_fill(correction.get(), nullptr), 1);
  EXPECT_EQ(MaskOf(correction.get()), Sphere());
  ASSERT_EQ(palpate_correction_pull(correction.get(), &pull, nullptr), 1);
  const std::vector<uint8_t> pulled = MaskOf(correction.get());
  EXPECT_EQ(pulled[VoxelAt(28, 16, 16)], 1);
  EXPECT_EQ(pulled[VoxelAt(30, 16, 16)], 0);
  for (int steps = 0; steps < 3; ++steps)
  {
    EXPECT_EQ(palpate_correction_undo(correction.get()), 1);
  }
  EXPECT_EQ(palpate_correction_undo(correction.get()), 0);
  EXPECT_EQ(MaskOf(correction.get()), start);
}

TEST(CorrectionHandle, PullsStopAtTheBarrier)
{
  std::vector<uint8_t> wall(VoxelAt(0, 0, Side));
  wall[VoxelAt(27, 16, 16)] = 1;
  const auto correction = CorrectionOf(Sphere(), wall.data());
  const palpate_pull pull{{25, 16, 16}, 4.0, 0, {0, 0, 0}, 4.0, 0.0};
  ASSERT_EQ(palpate_correction_pull(correction.get(), &pull, nullptr), 1);
  EXPECT_EQ(MaskOf(correction.get())[VoxelAt(27, 16, 16)], 0);
  EXPECT_EQ(MaskOf(correction.get())[VoxelAt(27, 17, 16)], 1);
}

TEST(CorrectionHandle, AModelIsPulledToItsTarget)
{
  const auto ball = BallModel();
  const Owned<palpate_correction> correction(palpate_correction_of_model(ball.get(), nullptr));
  const palpate_pull pull{{20, 0, 0}, 0.0, 1, {23, 0, 0}, 8.0, 0.0};
  std::size_t points = 0;
  std::size_t triangles = 0;
  ASSERT_EQ(palpate_correction_surface(correction.get(), &points, &triangles, nullptr, nullptr,
                                       nullptr, nullptr, nullptr),
            1);
  EXPECT_EQ(points, palpate_mesh_point_count(24));
  EXPECT_EQ(triangles, palpate_mesh_triangle_count(24));
  std::vector<double> shown(3 * points);
  std::vector<double> moved(3 * points);
  ASSERT_EQ(palpate_correction_preview(correction.get(), &pull, shown.data(), nullptr), 1);
  ASSERT_EQ(palpate_correction_pull(correction.get(), &pull, nullptr), 1);
  ASSERT_EQ(palpate_correction_surface(correction.get(), &points, &triangles, nullptr, nullptr,
                                       moved.data(), nullptr, nullptr),
            1);
  EXPECT_EQ(moved, shown);
  const Owned<palpate_model> model(palpate_correction_model(correction.get(), nullptr));
  ASSERT_NE(model, nullptr);
  const double direction[3] = {1.0, 0.0, 0.0};
  double point[3];
  double normal[3];
  ASSERT_EQ(palpate_model_point(model.get(), direction, point, normal, nullptr), 1);
  EXPECT_NEAR(point[0], 23.0, 0.1); // the pulled point is beside the target's direction
  EXPECT_EQ(palpate_correction_undo(correction.get()), 1);
  EXPECT_EQ(palpate_correction_undo(correction.get()), 0);
}

TEST(CorrectionHandle, RefusesInWords)
{
  const auto ball = BallModel();
  const Owned<palpate_correction> model(palpate_correction_of_model(ball.get(), nullptr));
  const auto mask = CorrectionOf(Sphere(), nullptr);
  palpate_error error;
  uint8_t voxel = 0;
  EXPECT_EQ(palpate_correction_fill(model.get(), &error), 0);
  EXPECT_STREQ(error.text, "a model has no voxels to edit; pull its surface");
  EXPECT_EQ(palpate_correction_mask(model.get(), &voxel, &error), 0);
  EXPECT_STREQ(error.text, "a corrected model has no mask");
  EXPECT_EQ(palpate_correction_model(mask.get(), &error), nullptr);
  EXPECT_STREQ(error.text, "a corrected mask has no model; fit one to it");
  EXPECT_EQ(palpate_correction_smooth(mask.get(), -1.0, &error), 0);
  const std::vector<uint8_t> none(VoxelAt(0, 0, Side));
  EXPECT_EQ(palpate_correction_of_mask(none.data(), nullptr, Size, Origin, Spacing, Axes, &error),
            nullptr);
  EXPECT_STREQ(error.text, "the mask has no voxels");
}
} // namespace
} // namespace palpate::correction_handle_test
