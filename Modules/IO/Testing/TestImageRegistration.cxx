#include "ImageRegistration.h"

#include "AffineRows.h"
#include "ImageGrid.h"
#include "InputError.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>

namespace palpate::image_registration_test
{
namespace
{
// Blobs of different sizes without symmetry, and a texture everywhere: where one value fills the
// borders, images tell most about each other if these are scaled away.
double DensityAt(const Vector3& world)
{
  const double blobs[5][5] = {{0, 0, 0, 14, 100},
                              {16, 5, -3, 6, 60},
                              {-9, 14, 6, 5, -50},
                              {4, -15, 9, 7, 45},
                              {-6, -8, -12, 4, 80}};
  double sum =
      25.0 * std::sin(world[0] / 4.5) * std::cos(world[1] / 5.0) * std::sin(1.0 + world[2] / 6.0);
  for (const auto& blob : blobs)
  {
    const double distance = (world - Vector3(blob[0], blob[1], blob[2])).squaredNorm();
    sum += blob[4] * std::exp(-0.5 * distance / (blob[3] * blob[3]));
  }
  return sum;
}

// Of a body that `map` has moved; `contrast` makes values of it.
template <typename Contrast>
vtkSmartPointer<vtkImageData> ImageOf(const Eigen::Affine3d& map, const Eigen::Matrix3d& direction,
                                      const Contrast& contrast)
{
  ImageGrid grid;
  grid.Size = {44, 40, 32};
  grid.Spacing = {1.6, 1.8, 2.2};
  grid.Direction = direction;
  grid.OriginWorld = -direction * grid.Spacing.cwiseProduct(Vector3(21.5, 19.5, 15.5));
  vtkNew<vtkFloatArray> voxels;
  voxels->SetNumberOfTuples(grid.VoxelCount());
  for (vtkIdType i = 0; i < voxels->GetNumberOfTuples(); ++i)
  {
    const Vector3 index(i % 44, i / 44 % 40, i / 44 / 40);
    const Vector3 world = grid.OriginWorld + direction * index.cwiseProduct(grid.Spacing);
    voxels->SetValue(i, static_cast<float>(contrast(DensityAt(map.inverse() * world))));
  }
  return MakeImage(grid, voxels);
}

double Plain(double density)
{
  return density;
}

// As of another modality.
double Inverse(double density)
{
  return 300.0 - 2.0 * density + 0.006 * density * density;
}

Eigen::Affine3d Moved(double shift, double degrees)
{
  return Eigen::Translation3d(shift * Vector3(2.0, -1.0, 2.0) / 3.0) *
         Eigen::Affine3d(Eigen::AngleAxisd(degrees * M_PI / 180.0, Vector3(1.0, 2.0, -2.0) / 3.0));
}

// Largest distance between the places of two maps on a body of 25 mm.
double Apart(const Eigen::Affine3d& a, const Eigen::Affine3d& b)
{
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : {-25.0, 25.0})
    {
      const Vector3 point = side * Vector3::Unit(axis);
      largest = std::max(largest, (a * point - b * point).norm());
    }
  }
  return largest;
}

const MapRows Still = ToMapRows(Eigen::Affine3d::Identity());

TEST(ImageRegistration, FindsMovedImageOfAnotherModality)
{
  const Eigen::Matrix3d oblique =
      Eigen::AngleAxisd(0.5, Vector3(1.0, 1.0, 3.0).normalized()).matrix();
  const Eigen::Affine3d truth = Moved(8.0, 9.0); // of the moving image
  const auto fixed = ImageOf(Eigen::Affine3d::Identity(), oblique, Plain);
  const auto moving = ImageOf(truth.inverse(), Eigen::Matrix3d::Identity(), Inverse);
  const auto found = RegisterImages(moving, fixed, {false, false, Still}, {});
  ASSERT_TRUE(found);
  // A tenth of a voxel.
  EXPECT_LT(Apart(ToAffine(found->Back).inverse(), truth), 0.2);
  EXPECT_GT(found->InformationAfter, found->InformationBefore);
}

TEST(ImageRegistration, FindsSizeAndShearIfTheyMayChange)
{
  Eigen::Affine3d similar = Moved(4.0, 5.0);
  similar.linear() *= 1.08;
  Eigen::Affine3d sheared = Moved(4.0, 5.0);
  sheared.linear() *= Eigen::Matrix3d{{1.05, 0.04, 0.0}, {0.0, 0.97, 0.0}, {0.0, 0.0, 1.0}};
  const auto fixed = ImageOf(Eigen::Affine3d::Identity(), Eigen::Matrix3d::Identity(), Plain);
  for (const bool isAffine : {false, true})
  {
    const Eigen::Affine3d& truth = isAffine ? sheared : similar;
    const auto moving = ImageOf(truth.inverse(), Eigen::Matrix3d::Identity(), Plain);
    const auto found = RegisterImages(moving, fixed, {!isAffine, isAffine, Still}, {});
    EXPECT_LT(Apart(ToAffine(found->Back).inverse(), truth), 0.3) << isAffine;
  }
}

TEST(ImageRegistration, GoesOnFromItsStart)
{
  const Eigen::Affine3d truth = Moved(40.0, 35.0);
  const auto fixed = ImageOf(Eigen::Affine3d::Identity(), Eigen::Matrix3d::Identity(), Plain);
  const auto moving = ImageOf(truth.inverse(), Eigen::Matrix3d::Identity(), Inverse);
  const Eigen::Affine3d start = Moved(36.0, 30.0);
  const auto found = RegisterImages(moving, fixed, {false, false, ToMapRows(start.inverse())}, {});
  EXPECT_LT(Apart(ToAffine(found->Back).inverse(), truth), 0.2);
}

TEST(ImageRegistration, RefusesImagesThatDoNotOverlapOrHaveOneValue)
{
  const auto fixed = ImageOf(Eigen::Affine3d::Identity(), Eigen::Matrix3d::Identity(), Plain);
  const Eigen::Affine3d away(Eigen::Translation3d(500.0, 0.0, 0.0));
  EXPECT_THROW(RegisterImages(fixed, fixed, {false, false, ToMapRows(away)}, {}), InputError);
  const auto flat =
      ImageOf(Eigen::Affine3d::Identity(), Eigen::Matrix3d::Identity(), [](double) { return 7.0; });
  EXPECT_THROW(RegisterImages(flat, fixed, {false, false, Still}, {}), InputError);
}

TEST(ImageRegistration, EndsWhenCancelled)
{
  const auto fixed = ImageOf(Eigen::Affine3d::Identity(), Eigen::Matrix3d::Identity(), Plain);
  int calls = 0;
  EXPECT_FALSE(RegisterImages(fixed, fixed, {false, false, Still},
                              [&calls](double part)
                              {
                                EXPECT_GE(part, 0.0);
                                EXPECT_LE(part, 1.0);
                                return ++calls < 3;
                              }));
  EXPECT_EQ(calls, 3);
}
} // namespace
} // namespace palpate::image_registration_test
