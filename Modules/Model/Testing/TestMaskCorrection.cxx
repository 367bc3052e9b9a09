#include "CorrectedCases.h"
#include "MaskCorrection.h"
#include "MaskEdits.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::mask_correction_test
{
namespace
{
using namespace palpate::test;

constexpr double Radius = 18.0;

MaskCorrection Made(const VoxelMask& mask)
{
  MaskCorrection correction;
  const Status status = MaskCorrection::Make(mask, CorrectedFrame(), CorrectedImage, correction);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return correction;
}

// A bump in direction x, of this height.
double BumpAt(const Vector3& direction, double height)
{
  return height * std::exp(-(direction - Vector3::UnitX()).squaredNorm() / (2.0 * 0.3 * 0.3));
}

Eigen::Matrix3Xd Bump(const MaskCorrection& correction, double height)
{
  Eigen::Matrix3Xd displacements(3, correction.Surface().Points.size());
  for (Eigen::Index n = 0; n < displacements.cols(); ++n)
  {
    const Vector3 arm =
        correction.Surface().Points[static_cast<std::size_t>(n)] - CorrectedMiddle();
    displacements.col(n) = BumpAt(arm.normalized(), height) * arm.normalized();
  }
  return displacements;
}

TEST(MaskCorrection, ABallGetsItsBumpOrDent)
{
  for (const double height : {6.0, -6.0})
  {
    const MaskCorrection correction = Made(BallMask(Radius));
    const VoxelMask moved = correction.Moved(Bump(correction, height));
    int wrong = 0;
    ForEachVoxel(
        [&](const std::array<int, 3>& index, const Vector3& point)
        {
          const Vector3 arm = point - CorrectedMiddle();
          const double excess =
              arm.norm() - Radius - BumpAt(arm.norm() > 0.0 ? arm.normalized() : arm, height);
          // Voxels of 1 x 1 x 2 mm say where the ball's surface is to half of that.
          wrong += std::abs(excess) > 0.8 && HasVoxel(moved, index) != (excess < 0.0) ? 1 : 0;
        });
    EXPECT_LT(wrong, 3) << height;
  }
}

TEST(MaskCorrection, FarVoxelsAndCavitiesStay)
{
  // With a cavity and a loose part, and speckle at the surface.
  const VoxelMask start = MaskWhere(
      [](const Vector3& point)
      {
        const Vector3 arm = point - CorrectedMiddle();
        const bool isSpeckled = std::sin(40.0 * arm[1]) > 0.0 && arm.norm() > Radius - 1.0;
        const bool isHollow = (arm - Vector3(11.0, 0.0, 0.0)).norm() < 3.0;
        return (arm.norm() < Radius && !isSpeckled && !isHollow) ||
               (arm - Vector3(26.0, 0.0, 0.0)).norm() < 2.5;
      });
  for (const double height : {3.0, -3.0})
  {
    const MaskCorrection correction = Made(start);
    Eigen::Matrix3Xd displacements(3, correction.Surface().Points.size());
    for (Eigen::Index n = 0; n < displacements.cols(); ++n)
    {
      const Vector3 arm =
          correction.Surface().Points[static_cast<std::size_t>(n)] - CorrectedMiddle();
      const double by = arm.norm() > 14.5 ? BumpAt(arm.normalized(), height) : 0.0;
      displacements.col(n) = by * arm.normalized();
    }
    const VoxelMask moved = correction.Moved(displacements);
    int changed = 0;
    int turned = 0;
    ForEachVoxel(
        [&](const std::array<int, 3>& index, const Vector3& point)
        {
          const bool was = HasVoxel(start, index);
          const Vector3 arm = point - CorrectedMiddle();
          if (was == HasVoxel(moved, index))
          {
            return;
          }
          ++changed;
          turned += was != (height < 0.0) ? 1 : 0;
          EXPECT_GT(arm[0], 8.0);                                 // near the bump
          EXPECT_GE((arm - Vector3(11.0, 0.0, 0.0)).norm(), 3.0); // not the cavity's
        });
    EXPECT_GT(changed, 50) << height;
    EXPECT_LT(turned, changed / 5); // speckle that is carried aside
  }
}

TEST(MaskCorrection, PullsStopAtNeighbours)
{
  const auto isNeighbour = [](const std::array<int, 3>& index)
  { return index[0] == 52 || index[0] == 53; }; // a wall 2 mm outside of the ball
  const MaskCorrection correction = Made(BallMask(Radius));
  const VoxelMask moved = correction.Moved(Bump(correction, 8.0), isNeighbour);
  int before = 0;
  ForEachVoxel(
      [&](const std::array<int, 3>& index, const Vector3&)
      {
        EXPECT_FALSE(HasVoxel(moved, index) && index[0] >= 52);
        before += HasVoxel(moved, index) && index[0] == 51 ? 1 : 0;
      });
  EXPECT_GT(before, 20);
  EXPECT_TRUE(HasVoxel(correction.Moved(Bump(correction, 8.0)), {55, 31, 16}));
}

TEST(MaskCorrection, StaysWithinTheImage)
{
  const MaskCorrection correction = Made(BallMask(Radius));
  const VoxelMask moved = correction.Moved(Bump(correction, 40.0));
  long long within = 0;
  ForEachVoxel([&](const std::array<int, 3>& index, const Vector3&)
               { within += HasVoxel(moved, index) ? 1 : 0; });
  EXPECT_EQ(within, moved.Count());
  EXPECT_TRUE(HasVoxel(moved, {63, 31, 16}));
}

TEST(MaskCorrection, SmallDisplacementsChangeNothing)
{
  // Speckled at its surface, which so passes close to many centres.
  const VoxelMask start = MaskWhere(
      [](const Vector3& point)
      {
        const Vector3 arm = point - CorrectedMiddle();
        return arm.norm() < Radius - (std::sin(40.0 * arm.sum()) > 0.0 ? 1.5 : 0.0);
      });
  const MaskCorrection correction = Made(start);
  // Outwards everywhere: the surface passes some centres.
  Eigen::Matrix3Xd small(3, correction.Surface().Points.size());
  for (Eigen::Index n = 0; n < small.cols(); ++n)
  {
    small.col(n) = 0.99 * MaskCorrection::LeastDisplacement *
                   correction.Normals()[static_cast<std::size_t>(n)];
  }
  EXPECT_EQ(correction.Moved(small).Inside, start.Inside);
}

TEST(MaskCorrection, AThinPlateCanBePulled)
{
  // One voxel thick: no shape, but a boundary.
  const VoxelMask start = MaskWhere(
      [](const Vector3& point)
      {
        const Vector3 arm = point - CorrectedMiddle();
        return std::abs(arm[2]) < 0.1 && arm.head<2>().norm() < 10.0;
      });
  const MaskCorrection correction = Made(start);
  Eigen::Matrix3Xd displacements(3, correction.Surface().Points.size());
  for (Eigen::Index n = 0; n < displacements.cols(); ++n)
  {
    const double by = correction.Normals()[static_cast<std::size_t>(n)][2] > 0.5 ? 3.5 : 0.0;
    displacements.col(n) = by * Vector3::UnitZ();
  }
  const VoxelMask moved = correction.Moved(displacements);
  EXPECT_TRUE(HasVoxel(moved, {32, 31, 17}));
  EXPECT_TRUE(HasVoxel(moved, {32, 31, 18}));
  EXPECT_FALSE(HasVoxel(moved, {32, 31, 19}));
  EXPECT_FALSE(HasVoxel(moved, {32, 31, 15}));
}

TEST(MaskCorrection, RefusesAnEmptyMask)
{
  MaskCorrection correction;
  EXPECT_FALSE(
      MaskCorrection::Make(BallMask(0.0), CorrectedFrame(), CorrectedImage, correction).IsOk());
}
} // namespace
} // namespace palpate::mask_correction_test
