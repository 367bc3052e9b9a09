#include "NearestOnSurfaces.h"

#include "vtkSphereSource.h"

#include <gtest/gtest.h>

namespace palpate::nearest_on_surfaces_test
{
namespace
{
vtkSmartPointer<vtkPolyData> Sphere(const Vector3& center, double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(center.x(), center.y(), center.z());
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(200);
  sphere->SetPhiResolution(200);
  sphere->Update();
  return sphere->GetOutput();
}

// Of triangles of 1 mm on 30 mm: the chord of one is 0.004 mm inside.
constexpr double Flat = 0.01;

TEST(NearestOnSurfaces, FindsTheNearestOfAll)
{
  const auto left = Sphere({30.0, 0.0, 0.0}, 20.0);
  const auto right = Sphere({-40.0, 0.0, 0.0}, 20.0);
  NearestOnSurfaces all;
  all.SetSurfaces({left, right});
  const auto found = all.Find(Vector3::Zero(), 100.0);
  ASSERT_TRUE(found.has_value());
  EXPECT_LT((*found - Vector3(10.0, 0.0, 0.0)).norm(), 0.5) << "within a triangle";
  EXPECT_NEAR(found->norm(), 10.0, Flat);
  EXPECT_NEAR(all.Find({-15.0, 0.0, 0.0}, 100.0)->x(), -20.0, Flat);
}

TEST(NearestOnSurfaces, HasAReach)
{
  const auto sphere = Sphere({30.0, 0.0, 0.0}, 20.0);
  NearestOnSurfaces all;
  EXPECT_FALSE(all.Find(Vector3::Zero(), 100.0).has_value());
  all.SetSurfaces({sphere});
  EXPECT_FALSE(all.Find(Vector3::Zero(), 9.9).has_value());
  EXPECT_TRUE(all.Find(Vector3::Zero(), 10.1).has_value());
  all.SetSurfaces({});
  EXPECT_FALSE(all.Find(Vector3::Zero(), 100.0).has_value());
}

TEST(NearestOnSurfaces, FollowsASurfaceThatMoves)
{
  const auto sphere = Sphere({30.0, 0.0, 0.0}, 20.0);
  NearestOnSurfaces all;
  all.SetSurfaces({sphere});
  EXPECT_NEAR(all.Find(Vector3::Zero(), 100.0)->norm(), 10.0, Flat);
  sphere->DeepCopy(Sphere({35.0, 0.0, 0.0}, 20.0));
  EXPECT_NEAR(all.Find(Vector3::Zero(), 100.0)->norm(), 15.0, Flat);
}
} // namespace
} // namespace palpate::nearest_on_surfaces_test
