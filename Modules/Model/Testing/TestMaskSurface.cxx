#include "MaskSurface.h"

#include "SurfaceTopology.h"

#include <gtest/gtest.h>

namespace palpate::mask_surface_test
{
namespace
{
VoxelMask Empty(int side)
{
  VoxelMask mask;
  mask.Size = {side, side, side};
  mask.Spacing = {1.0, 1.0, 1.0};
  mask.Inside.assign(mask.Offset(0, 0, side), 0);
  return mask;
}

void Fill(const Vector3& center, double radius, unsigned char value, VoxelMask& mask)
{
  for (std::size_t voxel = 0; voxel < mask.Inside.size(); ++voxel)
  {
    const auto side = static_cast<std::size_t>(mask.Size[0]);
    const Vector3 at(static_cast<double>(voxel % side), static_cast<double>(voxel / side % side),
                     static_cast<double>(voxel / side / side));
    mask.Inside[voxel] = (at - center).norm() < radius ? value : mask.Inside[voxel];
  }
}

MaskSurface Made(const VoxelMask& mask, const MaskSurfaceSettings& settings)
{
  MaskSurface surface;
  const Status status = MakeMaskSurface(mask, {}, settings, {}, surface);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return surface;
}

TEST(MaskSurface, EnclosesVoxelsAndCavities)
{
  VoxelMask mask = Empty(40);
  Fill({19.0, 20.0, 18.0}, 15.0, 1, mask);
  const double whole = static_cast<double>(mask.Count());
  Fill({19.0, 20.0, 18.0}, 4.0, 0, mask);
  for (const int cells : {0, 2000})
  {
    const MaskSurface surface = Made(mask, {false, {1.0, cells}, 1});
    EXPECT_NEAR(surface.SurfaceVolume, whole, 1e-3 * whole);
    EXPECT_DOUBLE_EQ(surface.MaskVolume + surface.FilledCavities.Volume, whole);
    EXPECT_EQ(surface.Changes().FilledCavities.Count, 1);
    EXPECT_EQ(FaultOfGenusZero(DescribeTopology(surface.Mesh)), "");
  }
}

TEST(MaskSurface, HasTheComponentThatIsAskedFor)
{
  VoxelMask mask = Empty(50);
  Fill({14.0, 14.0, 14.0}, 11.0, 1, mask);
  Fill({38.0, 38.0, 38.0}, 8.0, 1, mask);
  for (const bool isPlain : {false, true})
  {
    const MaskSurface first = Made(mask, {isPlain, {}, 1});
    const MaskSurface second = Made(mask, {isPlain, {}, 2});
    const MaskSurface both = Made(mask, {isPlain, {}, 0});
    ASSERT_EQ(both.ComponentVolumes.size(), 2U);
    EXPECT_DOUBLE_EQ(first.MaskVolume, both.ComponentVolumes[0]);
    EXPECT_DOUBLE_EQ(second.MaskVolume, both.ComponentVolumes[1]);
    EXPECT_EQ(DescribeTopology(second.Mesh).Parts, 1);
    EXPECT_EQ(DescribeTopology(both.Mesh).Parts, 2);
  }
}

TEST(MaskSurface, SaysWhyThereIsNone)
{
  MaskSurface surface;
  const auto message = [&surface](const VoxelMask& mask, int component) {
    return MakeMaskSurface(mask, {}, {false, {}, component}, {}, surface).Message();
  };
  EXPECT_EQ(message(Empty(8), 1), "has no voxels");
  VoxelMask mask = Empty(20);
  Fill({9.0, 9.0, 9.0}, 6.0, 1, mask);
  EXPECT_EQ(message(mask, 2), "has 1 connected component: there is no component 2");
}

TEST(MaskSurface, IsCancelledByItsProgress)
{
  VoxelMask mask = Empty(20);
  Fill({9.0, 9.0, 9.0}, 6.0, 1, mask);
  for (const double last : {0.1, 0.5, 0.8})
  {
    MaskSurface surface;
    const auto until = [last](double fraction) { return fraction < last; };
    EXPECT_FALSE(MakeMaskSurface(mask, {}, {}, until, surface).IsOk()) << last;
  }
}
} // namespace
} // namespace palpate::mask_surface_test
