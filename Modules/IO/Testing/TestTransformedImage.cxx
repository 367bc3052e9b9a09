#include "TransformedImage.h"

#include "InputError.h"
#include "SyntheticImages.h"

#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

namespace palpate::transformed_image_test
{
namespace
{
ImageGrid GridWith(const Eigen::Matrix3d& direction)
{
  ImageGrid grid;
  grid.Size = {12, 14, 9};
  grid.Spacing = {1.0, 0.8, 2.0};
  grid.OriginWorld = {-20, 5, 7};
  grid.Direction = direction;
  return grid;
}

double ValueAt(const Vector3& world)
{
  return 1000.0 + world.dot(Vector3(2.0, -3.0, 0.5)); // that linear interpolation keeps
}

Vector3 WorldOf(vtkImageData* image, vtkIdType voxel)
{
  int at[3];
  double world[3];
  const int* size = image->GetDimensions();
  at[0] = static_cast<int>(voxel % size[0]);
  at[1] = static_cast<int>(voxel / size[0] % size[1]);
  at[2] = static_cast<int>(voxel / size[0] / size[1]);
  image->TransformIndexToPhysicalPoint(at, world);
  return Vector3(world);
}

vtkSmartPointer<vtkImageData> Sampled(const ImageGrid& grid)
{
  vtkNew<vtkFloatArray> voxels;
  voxels->SetNumberOfTuples(grid.VoxelCount());
  auto image = MakeImage(grid, voxels);
  for (vtkIdType i = 0; i < voxels->GetNumberOfTuples(); ++i)
  {
    voxels->SetValue(i, static_cast<float>(ValueAt(WorldOf(image, i))));
  }
  return image;
}

Eigen::Affine3d Turned()
{
  return Eigen::Translation3d(3.0, -2.0, 4.0) *
         Eigen::Affine3d(Eigen::AngleAxisd(0.3, Vector3(1.0, -2.0, 2.0).normalized()));
}

TEST(TransformedImage, ResampledValuesMoveWithTheMap)
{
  for (const Eigen::Matrix3d& order : test::AllAxisOrders())
  {
    if (order.determinant() < 0.0)
    {
      continue; // readers make them right-handed
    }
    const auto image = Sampled(GridWith(order));
    ImageGrid onto = GridWith(Eigen::Matrix3d::Identity());
    onto.Size = {20, 20, 20};
    const Eigen::Affine3d map = Turned();
    const Vector3 middle = map * WorldOf(image, image->GetNumberOfPoints() / 2);
    onto.OriginWorld = middle - onto.Spacing.cwiseProduct(Vector3::Constant(9.5));
    const auto moved = ResampleMoved("a.nii", image, map, onto, ResamplingKind::Linear);
    vtkDataArray* values = moved->GetPointData()->GetScalars();
    int inside = 0;
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      const Vector3 from = map.inverse() * WorldOf(moved, i);
      double index[3];
      image->TransformPhysicalPointToContinuousIndex(from.data(), index);
      if (index[0] > 0.0 && index[0] < 11.0 && index[1] > 0.0 && index[1] < 13.0 &&
          index[2] > 0.0 && index[2] < 8.0)
      {
        ++inside;
        ASSERT_NEAR(values->GetTuple1(i), ValueAt(from), 1e-3);
      }
    }
    EXPECT_GT(inside, 500);
  }
}

TEST(TransformedImage, RigidMapKeepsVoxelsAndMovesTheirPlaces)
{
  const auto image = Sampled(GridWith(Eigen::Matrix3d::Identity()));
  const auto moved = MoveRigidly("a.nii", image, Turned());
  EXPECT_EQ(moved->GetPointData()->GetScalars(), image->GetPointData()->GetScalars());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); i += 97)
  {
    EXPECT_LT((WorldOf(moved, i) - Turned() * WorldOf(image, i)).norm(), 1e-9);
  }
}

TEST(TransformedImage, StretchAndMirrorNeedAReference)
{
  const auto image = Sampled(GridWith(Eigen::Matrix3d::Identity()));
  for (const Vector3& scales : {Vector3(1.0, 1.0, 1.01), Vector3(-1.0, 1.0, 1.0)})
  {
    EXPECT_THROW(MoveRigidly("a.nii", image, Eigen::Affine3d(scales.asDiagonal())), InputError);
  }
}

TEST(TransformedImage, PerpendicularAxesKeepVoxels)
{
  const auto image = Sampled(GridWith(Eigen::Matrix3d::Identity()));
  const Eigen::Affine3d similar = Turned() * Eigen::Scaling(1.25);
  const Eigen::Affine3d along(Eigen::Scaling(1.0, 1.2, 0.9)); // the image's own axes
  for (const Eigen::Affine3d& map : {Turned(), similar, along})
  {
    std::vector<std::string> notes;
    const auto moved = MoveAxes("a.nii", image, map, ResamplingKind::Linear, notes);
    EXPECT_TRUE(notes.empty());
    EXPECT_EQ(moved->GetPointData()->GetScalars(), image->GetPointData()->GetScalars());
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); i += 97)
    {
      EXPECT_LT((WorldOf(moved, i) - map * WorldOf(image, i)).norm(), 1e-9);
    }
  }
}

TEST(TransformedImage, ShearedAxesAreResampledWithANote)
{
  const auto image = Sampled(GridWith(Eigen::Matrix3d::Identity()));
  Eigen::Affine3d map = Turned();
  map.linear() *= (Eigen::Matrix3d() << 1.0, 0.1, 0.0, 0.0, 1.0, 0.2, 0.0, 0.0, 1.1).finished();
  std::vector<std::string> notes;
  const auto moved = MoveAxes("a.nii", image, map, ResamplingKind::Linear, notes);
  EXPECT_EQ(notes, std::vector<std::string>{ResamplingNote});
  EXPECT_FALSE(IsSheared(GridOf(moved)));
  const Eigen::AlignedBox3d inner(WorldOf(image, 0) + Vector3::Constant(0.1),
                                  WorldOf(image, image->GetNumberOfPoints() - 1) -
                                      Vector3::Constant(0.1));
  int inside = 0;
  for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
  {
    const Vector3 from = map.inverse() * WorldOf(moved, i);
    if (inner.contains(from))
    {
      ++inside;
      ASSERT_NEAR(moved->GetPointData()->GetScalars()->GetTuple1(i), ValueAt(from), 1e-3);
    }
  }
  EXPECT_GT(inside, 500);
}

TEST(TransformedImage, GridThatNoImageHasIsRefused)
{
  const auto image = Sampled(GridWith(Eigen::Matrix3d::Identity()));
  std::vector<std::string> notes;
  EXPECT_THROW(MoveAxes("a.nii", image, Eigen::Affine3d(Eigen::Scaling(1e-9)),
                        ResamplingKind::Linear, notes),
               InputError);
}
} // namespace
} // namespace palpate::transformed_image_test
