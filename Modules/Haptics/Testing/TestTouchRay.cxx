#include "FieldContactCases.h"
#include "MeshCases.h"
#include "TouchRay.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace palpate::touch_ray_test
{
namespace
{
constexpr double Radius = 20.0;    // mm, of the sphere around the origin
constexpr double ToolRadius = 1.5; // mm

RadialModel Sphere(const Vector3& center, double radius)
{
  return {0, {radius * std::sqrt(4.0 * M_PI)}, center};
}

std::shared_ptr<const ContactModel> OfVoxels()
{
  const FieldGrid grid{
      {96, 96, 96}, Vector3::Constant(-23.75), Vector3::Constant(0.5), Matrix3::Identity()};
  return test::FieldContact(
      test::SampledField(grid, test::SphereField{Vector3::Constant(47.5), 2.0 * Radius}));
}

TouchScene SceneOf(std::vector<std::shared_ptr<const ContactModel>> models)
{
  TouchScene scene;
  scene.Tool = ToolShape::SpherePoints(ToolRadius, ToolShape::NeighbourCount);
  for (auto& model : models)
  {
    scene.Structures.push_back({"structure", std::move(model), {0.5, 0.0}, {}});
  }
  return scene;
}

TouchRay RayThrough(std::vector<std::shared_ptr<const ContactModel>> models)
{
  return TouchRay(std::make_shared<const TouchScene>(SceneOf(std::move(models))));
}

// Allowed errors, mm: a sphere of triangles is 0.07 mm flatter, one of voxels off by a hundredth.
struct Kind
{
  std::shared_ptr<const ContactModel> Model;
  double Tolerance;
};

std::vector<Kind> Spheres()
{
  const RadialModel sphere = Sphere(Vector3::Zero(), Radius);
  return {{test::RadialContact(sphere), 0.01},
          {test::FacetContact(test::MeshOf(sphere, 20)), 0.1},
          {OfVoxels(), 0.03}};
}
} // namespace

TEST(TouchRay, ToolRestsWhereASphereWouldStopIt)
{
  std::mt19937_64 random(61);
  std::uniform_real_distribution<double> aside(-14.0, 14.0);
  for (const Kind& kind : Spheres())
  {
    TouchRay ray = RayThrough({kind.Model});
    for (int i = 0; i < 20; ++i)
    {
      const double x = aside(random);
      const double y = aside(random);
      const auto rest = ray.First({x, y, 300.0}, {x, y, -300.0});
      ASSERT_TRUE(rest);
      const double reach = Radius + ToolRadius;
      const Vector3 wanted(x, y, std::sqrt(reach * reach - x * x - y * y));
      EXPECT_NEAR((rest->ToolWorld - wanted).norm(), 0.0, 3.0 * kind.Tolerance) << x << " " << y;
      EXPECT_GE(rest->ToolWorld.norm(), reach - kind.Tolerance) << "outside";
      EXPECT_GT(rest->NormalWorld.dot(wanted.normalized()), 0.99);
      EXPECT_EQ(rest->Structure, 0);
    }
  }
}

TEST(TouchRay, CapsuleRestsOnItsSideAndOnItsEnd)
{
  constexpr double Length = 10.0; // mm, along z
  for (const Kind& kind : Spheres())
  {
    TouchScene scene = SceneOf({kind.Model});
    scene.Tool = ToolShape::Capsule(ToolRadius, Length, 200);
    TouchRay ray(std::make_shared<const TouchScene>(scene));
    const auto side = ray.First({60.0, 0.0, 0.0}, Vector3::Zero());
    ASSERT_TRUE(side);
    EXPECT_NEAR(side->ToolWorld.x(), Radius + ToolRadius, kind.Tolerance + 0.02);
    const auto end = ray.First({0.0, 0.0, 60.0}, Vector3::Zero());
    ASSERT_TRUE(end);
    EXPECT_NEAR(end->ToolWorld.z(), Radius + ToolRadius + 0.5 * Length, kind.Tolerance + 0.02);
  }
}

TEST(TouchRay, LinesThatMissHaveNoRest)
{
  for (const Kind& kind : Spheres())
  {
    TouchRay ray = RayThrough({kind.Model});
    EXPECT_FALSE(ray.First({22.0, 0.0, 300.0}, {22.0, 0.0, -300.0})) << "beside it";
    EXPECT_FALSE(ray.First({0.0, 0.0, 300.0}, {0.0, 0.0, 40.0})) << "ends before it";
    EXPECT_FALSE(ray.First({0.0, 0.0, 0.0}, {0.0, 0.0, 300.0})) << "begins inside";
    EXPECT_FALSE(ray.First({0.0, 0.0, 300.0}, {0.0, 0.0, 300.0})) << "no line";
    EXPECT_FALSE(ray.First({0.0, 0.0, NAN}, {0.0, 0.0, -300.0}));
  }
}

TEST(TouchRay, NearestOfSeveralStructuresHoldsTheTool)
{
  TouchRay ray = RayThrough({test::RadialContact(Sphere({0.0, 0.0, 0.0}, 10.0)),
                             test::RadialContact(Sphere({0.0, 0.0, 60.0}, 10.0)),
                             test::RadialContact(Sphere({0.0, 0.0, 30.0}, 10.0))});
  const auto from = ray.First({1.0, 0.0, 300.0}, {1.0, 0.0, -300.0});
  ASSERT_TRUE(from);
  EXPECT_EQ(from->Structure, 1);
  const auto back = ray.First({1.0, 0.0, -300.0}, {1.0, 0.0, 300.0});
  ASSERT_TRUE(back);
  EXPECT_EQ(back->Structure, 0);
}

// A plate of 1 mm, looked at from far away: steps never jump over it.
TEST(TouchRay, ThinWallsHoldTheTool)
{
  TouchRay ray = RayThrough({test::FacetContact(test::BoxMesh({80.0, 80.0, 0.5}))});
  const auto rest = ray.First({10.0, 20.0, 500.0}, {-15.0, 3.0, -500.0});
  ASSERT_TRUE(rest);
  EXPECT_NEAR(rest->ToolWorld.z(), 0.5 + ToolRadius, 0.01);
  EXPECT_GT(rest->NormalWorld.z(), 0.99);
}
} // namespace palpate::touch_ray_test
