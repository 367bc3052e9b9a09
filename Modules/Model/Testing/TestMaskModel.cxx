#include "MaskModel.h"

#include "ModelMeasures.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <variant>

namespace palpate::mask_model_test
{
namespace
{
constexpr double Spacing[3] = {1.0, 0.8, 1.5};

VoxelMask Empty(int i, int j, int k)
{
  VoxelMask mask;
  mask.Size = {i, j, k};
  mask.Spacing = {Spacing[0], Spacing[1], Spacing[2]};
  mask.Inside.assign(mask.Offset(0, 0, k), 0);
  return mask;
}

// Adds (or, with 0, removes) the voxels of an ellipsoid; centre and semi-axes are mm along the
// axes.
void Fill(const Vector3& center, const Vector3& semiAxes, unsigned char value, VoxelMask& mask)
{
  for (int k = 0; k < mask.Size[2]; ++k)
  {
    for (int j = 0; j < mask.Size[1]; ++j)
    {
      for (int i = 0; i < mask.Size[0]; ++i)
      {
        const Vector3 point(i * Spacing[0], j * Spacing[1], k * Spacing[2]);
        if ((point - center).cwiseQuotient(semiAxes).norm() <= 1.0)
        {
          mask.Inside[mask.Offset(i, j, k)] = value;
        }
      }
    }
  }
}

const Vector3 Center(20.0, 20.0, 22.5);
const Vector3 SemiAxes(15.0, 10.0, 12.0);

VoxelMask Ellipsoid()
{
  VoxelMask mask = Empty(41, 51, 31);
  Fill(Center, SemiAxes, 1, mask);
  return mask;
}

// x runs against i, so that the axes are left-handed.
IndexToWorld Mirrored()
{
  IndexToWorld toWorld;
  toWorld.Origin = {100.0, -20.0, 5.0};
  toWorld.Axes = Vector3(-Spacing[0], Spacing[1], Spacing[2]).asDiagonal();
  return toWorld;
}

BodyMoments BodyOf(const OrganModel& model)
{
  BodyMoments moments{};
  const Status status =
      std::visit([&](const auto& surface) { return MeasureBody(surface, moments); }, model);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return moments;
}

void ExpectEllipsoid(const OrganModel& model)
{
  const BodyMoments body = BodyOf(model);
  const double volume = 4.0 / 3.0 * M_PI * SemiAxes.prod();
  EXPECT_NEAR(body.Volume / volume, 1.0, 0.01) << "as of the voxels";
  const Vector3 center(100.0 - Center[0], -20.0 + Center[1], 5.0 + Center[2]);
  EXPECT_LT((body.CentroidWorld - center).norm(), 0.1) << "a tenth of a voxel";
  EXPECT_LT((body.SemiAxes - Vector3(15.0, 12.0, 10.0)).norm(), 0.2);
}

TEST(MaskModel, BothKindsHaveTheBodyOfTheMask)
{
  for (const bool isRadial : {true, false})
  {
    OrganModel model;
    const Status status = FitMask(Ellipsoid(), Mirrored(), {8, isRadial}, model);
    ASSERT_TRUE(status.IsOk()) << status.Message();
    EXPECT_EQ(std::holds_alternative<RadialModel>(model), isRadial);
    EXPECT_EQ(DegreeOf(model), 8);
    ExpectEllipsoid(model);
    if (const auto* mapped = std::get_if<SurfaceModel>(&model))
    {
      EXPECT_GT(mapped->Volume(), 0.0) << "not inside out";
    }
  }
}

TEST(MaskModel, SmallPartsFarAwayAreLeftOut)
{
  VoxelMask mask = Ellipsoid();
  Fill({3.0, 3.0, 3.0}, {2.5, 2.5, 2.5}, 1, mask);
  for (const bool isRadial : {true, false})
  {
    OrganModel model;
    const Status status = FitMask(mask, Mirrored(), {8, isRadial}, model);
    ASSERT_TRUE(status.IsOk()) << status.Message();
    ExpectEllipsoid(model);
  }
}

TEST(MaskModel, SurfaceModelsTakeInPartsThatAreNear)
{
  VoxelMask mask = Ellipsoid();
  const long long whole = mask.Count();
  for (std::size_t voxel = mask.Offset(0, 0, 12); voxel < mask.Offset(0, 0, 13); ++voxel)
  {
    mask.Inside[voxel] = 0; // a slice of 1.5 mm
  }
  OrganModel model;
  const Status status = FitMask(mask, Mirrored(), {8, false}, model);
  ASSERT_TRUE(status.IsOk()) << status.Message();
  EXPECT_GT(BodyOf(model).Volume, 0.85 * static_cast<double>(whole) * mask.VoxelVolume());
}

TEST(MaskModel, RefusesTwoLargePartsThatAreFarApart)
{
  VoxelMask mask = Empty(90, 51, 31);
  Fill(Center, SemiAxes, 1, mask);
  Fill(Center + Vector3(45.0, 0.0, 0.0), SemiAxes, 1, mask);
  OrganModel model;
  for (const bool isRadial : {true, false})
  {
    const Status status = FitMask(mask, Mirrored(), {8, isRadial}, model);
    EXPECT_NE(status.Message().find("parts"), std::string::npos) << status.Message();
  }
}

TEST(MaskModel, RefusesEmptyAndHollowMasks)
{
  OrganModel model;
  EXPECT_FALSE(FitMask(Empty(4, 4, 4), {}, {}, model).IsOk());
  VoxelMask hollow = Ellipsoid();
  Fill(Center, 0.6 * SemiAxes, 0, hollow);
  for (const bool isRadial : {true, false})
  {
    const Status status = FitMask(hollow, Mirrored(), {8, isRadial}, model);
    EXPECT_EQ(status.Message().rfind("the mask has a cavity", 0), 0U) << status.Message();
  }
}

TEST(MaskModel, RefusesRadiiWhereMuchIsHidden)
{
  VoxelMask mask = Empty(61, 61, 31); // an L
  for (int k = 10; k < 20; ++k)
  {
    for (int j = 5; j < 55; ++j)
    {
      for (int i = 5; i < 55; ++i)
      {
        mask.Inside[mask.Offset(i, j, k)] = i < 15 || j < 18 ? 1 : 0;
      }
    }
  }
  OrganModel model;
  const Status status = FitMask(mask, Mirrored(), {8, true}, model);
  EXPECT_NE(status.Message().find("is not star-shaped"), std::string::npos) << status.Message();
}
} // namespace
} // namespace palpate::mask_model_test
