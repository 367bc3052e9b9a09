#include "CellVolume.h"
#include "CutSweep.h"
#include "NodeCut.h"
#include "RandomOrientation.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace palpate::cut_sweep_test
{
namespace
{
CutPose At(const Vector3& position)
{
  return {position, Eigen::Quaterniond::Identity()};
}

// A block of values 1 (iso-value 0), and what tools removed from it.
class Block
{
public:
  Block(double spacing, const Vector3& half, const Matrix3& axes) : Spacing(spacing), Axes(axes)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double extent = half[static_cast<Eigen::Index>(axis)];
      this->Size[axis] = 2 * static_cast<int>(std::ceil(extent / spacing)) + 1;
    }
    this->Distances.assign(static_cast<std::size_t>(this->Size[0] * this->Size[1] * this->Size[2]),
                           INFINITY);
  }

  void Cut(const CutSweep& sweep)
  {
    this->ForEach(0, this->Size,
                  [&](int i, int j, int k)
                  {
                    double& distance = this->Distances[this->Number(i, j, k)];
                    distance = std::min(distance, sweep.Distance(this->PointWorld(i, j, k)));
                  });
  }

  // mm^3
  double Removed() const
  {
    double cells = 0.0;
    this->ForEach(1, {{this->Size[0] - 2, this->Size[1] - 2, this->Size[2] - 2}},
                  [&](int i, int j, int k)
                  {
                    std::array<double, 8> corners{};
                    for (int n = 0; n < 8; ++n)
                    {
                      corners[static_cast<std::size_t>(n)] =
                          this->Value(i + (n & 1), j + (n >> 1 & 1), k + (n >> 2));
                    }
                    cells += 1.0 - InsidePartOfCell(corners);
                  });
    return cells * std::pow(this->Spacing, 3);
  }

private:
  double Value(int i, int j, int k) const
  {
    const NodeCut cut({0, 0.0, FieldSense::AtLeast}, 1.0 / this->Spacing, this->Spacing);
    const double around[6] = {this->DistanceAt(i - 1, j, k), this->DistanceAt(i + 1, j, k),
                              this->DistanceAt(i, j - 1, k), this->DistanceAt(i, j + 1, k),
                              this->DistanceAt(i, j, k - 1), this->DistanceAt(i, j, k + 1)};
    return cut.Apply(1.0, InterpolatedDistance(this->DistanceAt(i, j, k), around));
  }
  double DistanceAt(int i, int j, int k) const { return this->Distances[this->Number(i, j, k)]; }
  template <typename Act>
  void ForEach(int first, const std::array<int, 3>& size, const Act& act) const
  {
    for (int k = first; k < size[2]; ++k)
    {
      for (int j = first; j < size[1]; ++j)
      {
        for (int i = first; i < size[0]; ++i)
        {
          act(i, j, k);
        }
      }
    }
  }
  std::size_t Number(int i, int j, int k) const
  {
    return static_cast<std::size_t>((k * this->Size[1] + j) * this->Size[0] + i);
  }
  // The centre is the origin.
  Vector3 PointWorld(int i, int j, int k) const
  {
    const Vector3 middle(this->Size[0] / 2, this->Size[1] / 2, this->Size[2] / 2);
    return this->Axes * (this->Spacing * (Vector3(i, j, k) - middle));
  }

  double Spacing;
  Matrix3 Axes;
  std::array<int, 3> Size{};
  std::vector<double> Distances;
};

double SphereVolume(double radius)
{
  return 4.0 / 3.0 * M_PI * std::pow(radius, 3);
}

TEST(CutSweep, SphereSweepsACapsule)
{
  const CutSweep sweep(CutTool::Sphere(1.0), At(Vector3::Zero()), At(Vector3(4.0, 0.0, 0.0)), 0.1);
  EXPECT_DOUBLE_EQ(sweep.Distance(Vector3(2.0, 3.0, 0.0)), 2.0);
  EXPECT_DOUBLE_EQ(sweep.Distance(Vector3(7.0, 4.0, 0.0)), 4.0);
  EXPECT_DOUBLE_EQ(sweep.Distance(Vector3(-2.0, 0.0, 0.0)), 1.0);
  EXPECT_DOUBLE_EQ(sweep.Distance(Vector3(1.0, 0.0, 0.0)), -1.0);
}

TEST(CutSweep, WithoutMotionEqualsTheTool)
{
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(-5.0, 5.0);
  const CutTool tool = CutTool::Cylinder(1.0, 4.0);
  const CutPose pose{Vector3(1.0, 2.0, 3.0), Eigen::Quaterniond(test::RandomOrientation(random))};
  const CutSweep sweep(tool, pose, pose, 0.1);
  for (int trial = 0; trial < 100; ++trial)
  {
    const Vector3 point(place(random), place(random), place(random));
    EXPECT_NEAR(sweep.Distance(pose.PositionWorld + pose.Orientation * point), tool.Distance(point),
                1e-12);
  }
}

TEST(CutSweep, CoversEveryPoseOnThePath)
{
  constexpr double Step = 0.1;
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> part(0.0, 1.0);
  const CutTool tool = CutTool::Cylinder(0.5, 6.0);
  const CutPose from{Vector3::Zero(), Eigen::Quaterniond(test::RandomOrientation(random))};
  const CutPose to{Vector3(3.0, -2.0, 1.0), Eigen::Quaterniond(test::RandomOrientation(random))};
  const CutSweep sweep(tool, from, to, Step);
  for (int trial = 0; trial < 1000; ++trial)
  {
    const double t = part(random);
    const Vector3 inTool(0.0, 0.0, 6.0 * part(random) - 3.0);
    const Vector3 point = (1.0 - t) * from.PositionWorld + t * to.PositionWorld +
                          from.Orientation.slerp(t, to.Orientation) * inTool;
    // On the axis, or half a step from there.
    EXPECT_LE(sweep.Distance(point), tool.Distance(inTool) + 0.5 * Step);
    EXPECT_TRUE(sweep.BoundsWorld().contains(point));
  }
}

TEST(CutSweep, SphereRemovesItsVolumeWithinOnePercentFromThreeVoxels)
{
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> offset(-0.5, 0.5);
  for (const double radius : {3.0, 4.0, 6.0, 10.0}) // voxels of 1 mm
  {
    for (int trial = 0; trial < 8; ++trial)
    {
      Block block(1.0, Vector3::Constant(radius + 4.0), test::RandomOrientation(random));
      const CutPose pose = At(Vector3(offset(random), offset(random), offset(random)));
      block.Cut(CutSweep(CutTool::Sphere(radius), pose, pose, 0.25));
      EXPECT_NEAR(block.Removed() / SphereVolume(radius), 1.0, 0.01) << radius;
    }
  }
}

TEST(CutSweep, StrokeRemovesACapsuleWithinOnePercent)
{
  std::mt19937_64 random(8);
  std::uniform_real_distribution<double> offset(-0.5, 0.5);
  for (int trial = 0; trial < 8; ++trial)
  {
    constexpr double Radius = 3.0;
    Block block(1.0, Vector3::Constant(10.0), test::RandomOrientation(random));
    const Vector3 from(offset(random) - 4.0, offset(random), offset(random));
    const Vector3 to(offset(random) + 4.0, offset(random), offset(random));
    // In ticks, as a hand moves.
    constexpr int Ticks = 50;
    for (int tick = 0; tick < Ticks; ++tick)
    {
      block.Cut(CutSweep(CutTool::Sphere(Radius), At(from + tick * (to - from) / Ticks),
                         At(from + (tick + 1) * (to - from) / Ticks), 0.25));
    }
    const double capsule = SphereVolume(Radius) + M_PI * Radius * Radius * (to - from).norm();
    EXPECT_NEAR(block.Removed() / capsule, 1.0, 0.01);
  }
}

TEST(CutSweep, RemovedVolumeConvergesWithOrderTwo)
{
  // The mean over many positions of the sphere in a voxel, so that the rest is systematic.
  const auto error = [](double spacing)
  {
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> offset(-0.5, 0.5);
    double sum = 0.0;
    constexpr int Trials = 40;
    for (int trial = 0; trial < Trials; ++trial)
    {
      Block block(spacing, Vector3::Constant(3.0 + 4.0 * spacing), test::RandomOrientation(random));
      const Vector3 place{offset(random), offset(random), offset(random)}; // in voxels
      const CutPose pose = At(spacing * place);
      block.Cut(CutSweep(CutTool::Sphere(3.0), pose, pose, 0.25));
      sum += std::pow(block.Removed() / SphereVolume(3.0) - 1.0, 2);
    }
    return std::sqrt(sum / Trials);
  };
  // A quarter, or nearly; of a sphere of three voxels a little more.
  const double coarse = error(1.0);
  const double middle = error(0.5);
  const double fine = error(0.25);
  EXPECT_LT(middle, coarse / 3.0);
  EXPECT_LT(fine, middle / 3.5);
  EXPECT_LT(fine, coarse / 13.0);
}
} // namespace
} // namespace palpate::cut_sweep_test
