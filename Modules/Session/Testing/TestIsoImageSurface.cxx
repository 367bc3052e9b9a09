#include "IsoImageSurface.h"

#include "FilterRun.h"
#include "IsoSurface.h"
#include "LabelImages.h"
#include "MeshTopology.h"

#include "vtkImageData.h"
#include "vtkMatrix3x3.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate
{
namespace
{
constexpr double Radius = 12.0; // mm

// How far inside a ball each node of an oblique, anisotropic grid lies, mm.
vtkSmartPointer<vtkImageData> DepthInBall(int size)
{
  std::mt19937_64 random(5);
  test::LabelGrid grid;
  grid.Size = {{size, size + 3, size - 4}};
  grid.Spacing = {{0.9, 0.8, 1.3}};
  grid.Direction = test::RandomRotation(random);
  grid.CenterOnOrigin();
  const auto image = test::MakeLabelImage<float>(grid, [](double /*x*/, double /*y*/, double /*z*/)
                                                 { return true; });
  auto* value = static_cast<float*>(image->GetScalarPointer());
  for (int k = 0; k < grid.Size[2]; ++k)
  {
    for (int j = 0; j < grid.Size[1]; ++j)
    {
      for (int i = 0; i < grid.Size[0]; ++i)
      {
        double world[3];
        image->TransformIndexToPhysicalPoint(i, j, k, world);
        *value++ = static_cast<float>(Radius - std::hypot(world[0], world[1], world[2]));
      }
    }
  }
  return image;
}

TEST(IsoImageSurface, LiesInTheWorldWhereTheValueIs)
{
  const auto surface = MakeIsoImageSurface(DepthInBall(40), 0.0);
  ASSERT_GT(surface->GetNumberOfPoints(), 1000);
  for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
  {
    double point[3];
    surface->GetPoint(p, point);
    // A chord of a voxel's 1.3 mm lies 1.3^2 / 8 / 12 = 0.02 mm below the ball.
    EXPECT_NEAR(std::hypot(point[0], point[1], point[2]), Radius, 0.02);
  }
}

TEST(IsoImageSurface, IsClosedAndFacesOutwards)
{
  const auto surface = MakeIsoImageSurface(DepthInBall(40), 0.0);
  EXPECT_EQ(test::TopologyFault(surface), "");
  const double ball = 4.0 / 3.0 * M_PI * Radius * Radius * Radius;
  // Chords leave out about two hundredths of a millimetre of 12: half a percent of the volume.
  EXPECT_NEAR(MeasureEnclosed(surface).Volume, ball, 0.006 * ball);
}

TEST(IsoImageSurface, IsClosedWhereTheImageEnds)
{
  const auto surface = MakeIsoImageSurface(DepthInBall(16), 0.0);
  EXPECT_EQ(test::TopologyFault(surface), "");
  EXPECT_GT(MeasureEnclosed(surface).Volume, 0.0);
}

TEST(IsoImageSurface, AValueThatNothingReachesIsAnError)
{
  EXPECT_THROW(MakeIsoImageSurface(DepthInBall(16), 100.0), FilterError);
}
} // namespace
} // namespace palpate
