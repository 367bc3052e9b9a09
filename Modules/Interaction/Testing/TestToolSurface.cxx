#include "ToolSurface.h"

#include "vtkFeatureEdges.h"
#include "vtkMassProperties.h"
#include "vtkNew.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::tool_surface_test
{
namespace
{
vtkIdType OpenEdges(vtkPolyData* surface)
{
  vtkNew<vtkFeatureEdges> edges;
  edges->SetInputData(surface);
  edges->FeatureEdgesOff();
  edges->ManifoldEdgesOff();
  edges->Update();
  return edges->GetOutput()->GetNumberOfCells();
}

double Volume(vtkPolyData* surface)
{
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(surface);
  return mass->GetVolume();
}

TEST(ToolSurface, SphereHasItsRadius)
{
  const auto surface = MakeToolSurface(ToolShape::Sphere(3.0));
  double bounds[6];
  surface->GetBounds(bounds);
  EXPECT_NEAR(bounds[5], 3.0, 1e-6); // points are floats
}

TEST(ToolSurface, CapsuleIsHullOfItsShell)
{
  const auto surface = MakeToolSurface(ToolShape::Capsule(2.0, 10.0, 400));
  EXPECT_EQ(OpenEdges(surface), 0);
  const double exact = M_PI * 4.0 * 10.0 + 4.0 / 3.0 * M_PI * 8.0;
  // A hull lies within; facets between 400 points are about 1 mm long and cut off up to 1/16 mm.
  EXPECT_LT(Volume(surface), exact);
  EXPECT_GT(Volume(surface), 0.92 * exact);
}

TEST(ToolSurface, EllipsoidIsHullOfItsShell)
{
  const auto surface = MakeToolSurface(ToolShape::Ellipsoid({1.0, 2.0, 4.0}, 400));
  EXPECT_EQ(OpenEdges(surface), 0);
  const double exact = 4.0 / 3.0 * M_PI * 8.0;
  EXPECT_LT(Volume(surface), exact);
  EXPECT_GT(Volume(surface), 0.95 * exact); // as above; the points are denser
}
} // namespace
} // namespace palpate::tool_surface_test
