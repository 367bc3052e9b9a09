#include "PixelRays.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"

#include <gtest/gtest.h>
#include <random>

namespace palpate::pixel_rays_test
{
namespace
{
Eigen::Matrix4d MatrixOf(vtkCamera* camera, double aspect)
{
  return Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(
      camera->GetCompositeProjectionTransformMatrix(aspect, 0.0, 1.0)->GetData());
}

// Oblique view, perspective or parallel.
PixelRays SomeRays(bool isParallel)
{
  vtkNew<vtkCamera> camera;
  camera->SetPosition(120.0, -310.0, 80.0);
  camera->SetFocalPoint(4.0, 7.0, -3.0);
  camera->SetViewUp(0.1, 0.2, 0.9);
  camera->SetClippingRange(150.0, 600.0);
  camera->SetParallelScale(90.0);
  camera->SetParallelProjection(isParallel ? 1 : 0);
  return {MatrixOf(camera, 4.0 / 3.0), 400, 300};
}

TEST(PixelRays, RunFromNearToFarPlane)
{
  for (const bool isParallel : {false, true})
  {
    const PixelRays rays = SomeRays(isParallel);
    ASSERT_TRUE(rays.IsUsable());
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(0.0, 300.0);
    for (int i = 0; i < 200; ++i)
    {
      const FieldRay ray = rays.At(place(random), place(random));
      // A few rounding errors of depths, which are below 1.
      EXPECT_NEAR(rays.Depth(ray.Origin), 0.0, 1e-12);
      EXPECT_NEAR(rays.Depth(ray.Origin + ray.Direction), 1.0, 1e-12);
    }
  }
}

TEST(PixelRays, CentralRayPointsToFocus)
{
  for (const bool isParallel : {false, true})
  {
    const FieldRay ray = SomeRays(isParallel).At(200.0, 150.0);
    const Vector3 expected = (Vector3(4.0, 7.0, -3.0) - Vector3(120.0, -310.0, 80.0)).normalized();
    EXPECT_LT((ray.Direction.normalized() - expected).norm(), 1e-12);
    EXPECT_LT((Vector3(4.0, 7.0, -3.0) - ray.Origin).cross(expected).norm(), 1e-10); // mm
  }
}

TEST(PixelRays, RayPassesThroughPixelCentre)
{
  const PixelRays rays = SomeRays(false);
  const FieldRay pixel = rays.OfPixel(17, 33);
  const FieldRay place = rays.At(17.5, 33.5);
  EXPECT_EQ(pixel.Origin, place.Origin);
  EXPECT_EQ(pixel.Direction, place.Direction);
}

TEST(PixelRays, ParameterAtDepthInvertsDepth)
{
  for (const bool isParallel : {false, true})
  {
    const PixelRays rays = SomeRays(isParallel);
    const FieldRay ray = rays.At(111.0, 222.0);
    for (const double t : {0.0, 0.1, 0.5, 0.9, 1.0})
    {
      const double depth = rays.Depth(ray.Origin + t * ray.Direction);
      // The ratio of far to near plane, 4, times rounding errors.
      EXPECT_NEAR(rays.ParameterAtDepth(ray, depth), t, 1e-13);
    }
  }
}

TEST(PixelRays, AreUnusableWithoutPixelsOrInverse)
{
  EXPECT_FALSE(PixelRays().IsUsable());
  EXPECT_FALSE(PixelRays(Eigen::Matrix4d::Identity(), 0, 10).IsUsable());
  EXPECT_FALSE(PixelRays(Eigen::Matrix4d::Zero(), 10, 10).IsUsable());
}
} // namespace
} // namespace palpate::pixel_rays_test
