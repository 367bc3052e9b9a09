#include "SceneIsoSurface.h"

#include "FilterRun.h"
#include "LabelImages.h"
#include "MeshConversion.h"
#include "SurfaceTopology.h"

#include "vtkFeatureEdges.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

namespace palpate::scene_iso_surface_test
{
namespace
{
const Eigen::Vector3d Center(3.0, -5.0, 8.0);
constexpr double Radius = 9.0;

bool GoOn(double, const std::string&)
{
  return true;
}

// Distances to the centre of a sphere, on an oblique grid with three different spacings.
vtkSmartPointer<vtkImageData> DistanceImage(std::mt19937_64& random)
{
  test::LabelGrid grid;
  grid.Size = {{40, 36, 28}};
  grid.Spacing = {{0.9, 1.0, 1.3}};
  grid.Direction = test::RandomRotation(random);
  grid.CenterOnOrigin();
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.Origin[static_cast<std::size_t>(axis)] += Center[axis];
  }
  const auto image =
      test::MakeLabelImage<float>(grid, [](double, double, double) { return false; });
  for (vtkIdType voxel = 0; voxel < image->GetNumberOfPoints(); ++voxel)
  {
    const Eigen::Vector3d place(image->GetPoint(voxel));
    image->GetPointData()->GetScalars()->SetTuple1(voxel, Radius - (place - Center).norm());
  }
  return image;
}

TEST(SceneIsoSurface, LiesInTheWorldWhereTheImagePassesTheValue)
{
  std::mt19937_64 random(81);
  for (int round = 0; round < 5; ++round)
  {
    const auto surface = MakeIsoSurface(DistanceImage(random), 2.0, GoOn);
    ASSERT_GT(surface->GetNumberOfPoints(), 500);
    for (vtkIdType point = 0; point < surface->GetNumberOfPoints(); ++point)
    {
      // Linear between voxels: by less than 1.3^2 / 8 / 7 mm.
      EXPECT_NEAR((Eigen::Vector3d(surface->GetPoint(point)) - Center).norm(), Radius - 2.0, 0.04);
    }
  }
}

TEST(SceneIsoSurface, FacesLowerValues)
{
  std::mt19937_64 random(82);
  const double sphere = 4.0 / 3.0 * M_PI * std::pow(Radius - 2.0, 3);
  for (int round = 0; round < 5; ++round)
  {
    const auto surface = MakeIsoSurface(DistanceImage(random), 2.0, GoOn);
    EXPECT_NEAR(MeasureEnclosed(ToIndexedMesh(surface)).Volume, sphere, 0.02 * sphere)
        << "a polyhedron inside of the sphere";
  }
}

TEST(SceneIsoSurface, IsClosedAtTheImageBorder)
{
  std::mt19937_64 random(7);
  const auto image = DistanceImage(random);
  // All of the image except its corners: a surface that extends beyond every side.
  const auto surface = MakeIsoSurface(image, -12.0, GoOn);
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  EXPECT_GT(surface->GetNumberOfCells(), 0);
  EXPECT_EQ(edges->GetOutput()->GetNumberOfCells(), 0);
}

TEST(SceneIsoSurface, RejectsValueOutsideTheImagesRange)
{
  std::mt19937_64 random(83);
  try
  {
    MakeIsoSurface(DistanceImage(random), 50.0, GoOn);
    FAIL() << "a surface without voxels";
  }
  catch (const FilterError& error)
  {
    EXPECT_NE(std::string(error.what()).find("iso-value 50 gives no surface"), std::string::npos)
        << error.what();
  }
}

TEST(SceneIsoSurface, IsCancelled)
{
  std::mt19937_64 random(84);
  EXPECT_THROW(
      MakeIsoSurface(DistanceImage(random), 2.0, [](double, const std::string&) { return false; }),
      Cancelled);
}
} // namespace
} // namespace palpate::scene_iso_surface_test
