#include "SlicePlane.h"

#include "AnatomicalView.h"
#include "ImageAxes.h"
#include "SyntheticFit.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <random>

namespace palpate::slice_plane_test
{
namespace
{
// A box of ones in a zero image with index axes along the given body directions.
vtkSmartPointer<vtkImageData> MakeBox(const Eigen::Matrix3d& direction)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(40, 30, 20);
  image->SetSpacing(1.0, 1.5, 2.0);
  image->SetOrigin(-11.0, 7.0, 100.0);
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = direction;
  image->SetDirectionMatrix(rows.data());
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* voxels = static_cast<unsigned char*>(image->GetScalarPointer());
  std::fill_n(voxels, image->GetNumberOfPoints(), 0);
  for (int k = 5; k <= 13; ++k)
  {
    for (int j = 8; j <= 20; ++j)
    {
      for (int i = 10; i <= 31; ++i)
      {
        *static_cast<unsigned char*>(image->GetScalarPointer(i, j, k)) = 1;
      }
    }
  }
  return image;
}

// All directions whose columns are axes of the body, right-handed.
std::vector<Eigen::Matrix3d> AxisDirections()
{
  std::vector<Eigen::Matrix3d> directions;
  for (int first = 0; first < 3; ++first)
  {
    for (int second = 0; second < 3; ++second)
    {
      for (int signs = 0; first != second && signs < 4; ++signs)
      {
        Eigen::Matrix3d direction;
        direction.col(0) = (signs & 1 ? -1.0 : 1.0) * Vector3::Unit(first);
        direction.col(1) = (signs & 2 ? -1.0 : 1.0) * Vector3::Unit(second);
        direction.col(2) = direction.col(0).cross(direction.col(1));
        directions.push_back(direction);
      }
    }
  }
  return directions;
}

TEST(SlicePlane, FollowsRadiologicalConventionForAnyAxes)
{
  for (const Eigen::Matrix3d& direction : AxisDirections())
  {
    for (const SlicePlane& plane : ChooseSlicePlanes(MakeBox(direction), 1, 3, 100))
    {
      const std::string right = OrientationLetters(plane.RightWorld);
      const std::string down = OrientationLetters(plane.DownWorld);
      EXPECT_EQ(right, plane.Name == "Sagittal" ? "P" : "L") << plane.Name << "\n" << direction;
      EXPECT_EQ(down, plane.Name == "Axial" ? "P" : "I") << plane.Name << "\n" << direction;
    }
  }
}

TEST(SlicePlane, AxialPlanesRiseThroughStructure)
{
  for (const Eigen::Matrix3d& direction : AxisDirections())
  {
    const auto planes = ChooseSlicePlanes(MakeBox(direction), 1, 3, 100);
    ASSERT_EQ(planes.size(), 5U);
    EXPECT_LT(planes[0].CornerWorld.z(), planes[1].CornerWorld.z());
    EXPECT_LT(planes[1].CornerWorld.z(), planes[2].CornerWorld.z());
    EXPECT_EQ(planes[3].Name, "Sagittal");
    EXPECT_EQ(planes[4].Name, "Coronal");
  }
}

TEST(SlicePlane, PlanesPassThroughVoxelCentres)
{
  const Eigen::Matrix3d turned =
      Eigen::AngleAxisd(0.4, Vector3(1, -2, 3).normalized()).toRotationMatrix();
  const auto image = MakeBox(turned);
  const palpate::ImageAxes axes(image);
  for (const SlicePlane& plane : ChooseSlicePlanes(image, 1, 4, 200))
  {
    for (const Eigen::Vector2d& corner :
         {Eigen::Vector2d(0, 0), Eigen::Vector2d(plane.Width, 0), Eigen::Vector2d(0, plane.Height)})
    {
      // Rounding of some additions of numbers around 100.
      EXPECT_NEAR(axes.ToIndex(plane.ToWorld(corner))[plane.SliceAxis], plane.SliceIndex, 1e-10);
    }
  }
}

TEST(SlicePlane, ImageCoordinatesAreToScaleAndInvertible)
{
  const palpate::test::SyntheticFit fit;
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(0.0, 300.0);
  for (const SlicePlane& plane : ChooseSlicePlanes(fit.Result.Mask, 1, 2, 300))
  {
    const Eigen::Vector2d a(place(random), place(random));
    const Eigen::Vector2d b(place(random), place(random));
    EXPECT_NEAR((plane.ToImage(plane.ToWorld(a)) - a).norm(), 0.0, 1e-9);
    EXPECT_NEAR((plane.ToWorld(a) - plane.ToWorld(b)).norm(),
                plane.PixelMillimeters * (a - b).norm(), 1e-9);
  }
}

TEST(SlicePlane, StructureIsInsideEveryImage)
{
  const auto image = MakeBox(Eigen::Matrix3d::Identity());
  for (const SlicePlane& plane : ChooseSlicePlanes(image, 1, 3, 150))
  {
    for (const Vector3& index : {Vector3(9.5, 7.5, 4.5), Vector3(31.5, 20.5, 13.5)})
    {
      const Eigen::Vector2d place = plane.ToImage(palpate::ImageAxes(image).ToWorld(index));
      EXPECT_GT(place.minCoeff(), 5.0) << plane.Name;
      EXPECT_LT(place.x(), plane.Width - 5.0) << plane.Name;
      EXPECT_LT(place.y(), plane.Height - 5.0) << plane.Name;
    }
  }
}

TEST(SlicePlane, AbsentValueHasNoPlanes)
{
  EXPECT_TRUE(ChooseSlicePlanes(MakeBox(Eigen::Matrix3d::Identity()), 2, 3, 100).empty());
}

TEST(SlicePlane, StructureOfOneSliceIsShownOnce)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(5, 5, 5);
  image->AllocateScalars(VTK_SHORT, 1);
  std::fill_n(static_cast<short*>(image->GetScalarPointer()), 125, short{0});
  *static_cast<short*>(image->GetScalarPointer(2, 2, 3)) = 7;
  const auto planes = ChooseSlicePlanes(image, 7, 4, 100);
  ASSERT_EQ(planes.size(), 3U);
  EXPECT_EQ(planes[0].SliceIndex, 3);
}

TEST(SlicePlane, IndicesNeedNotStartAtZero)
{
  vtkNew<vtkImageData> image;
  image->SetExtent(-3, 9, 2, 12, 5, 8);
  image->AllocateScalars(VTK_SHORT, 1);
  std::fill_n(static_cast<short*>(image->GetScalarPointer()), image->GetNumberOfPoints(), short{0});
  const Eigen::Vector3i voxel(-2, 4, 7);
  *static_cast<short*>(image->GetScalarPointer(voxel.x(), voxel.y(), voxel.z())) = 7;
  const auto planes = ChooseSlicePlanes(image, 7, 1, 100);
  ASSERT_EQ(planes.size(), 3U);
  for (const SlicePlane& plane : planes)
  {
    EXPECT_EQ(plane.SliceIndex, voxel[plane.SliceAxis]) << plane.Name;
    const Vector3 centre = plane.ToWorld({0.5 * plane.Width, 0.5 * plane.Height});
    EXPECT_NEAR((centre - voxel.cast<double>()).norm(), 0.0, 1e-12) << plane.Name;
  }
}
} // namespace
} // namespace palpate::slice_plane_test
