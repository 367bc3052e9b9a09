#include "SurfaceShading.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>

namespace palpate::surface_shading_test
{
namespace
{
const Vector3 Color(0.8, 0.4, 0.2);
const SurfaceLight FromViewer{false, Vector3::UnitZ(), Vector3::Ones(), Vector3::Ones()};

// Shades a point at the origin, seen along z.
Vector3 Shade(const SurfaceFinish& finish, const SurfaceLight& light, const Vector3& normal,
              const Vector3& color = Color)
{
  return SurfaceShading(finish, {light}).ColorAt(Vector3::Zero(), color, normal, Vector3::UnitZ());
}

TEST(SurfaceShading, UnshadedIsPlainColour)
{
  const SurfaceFinish flat{false, 0.3, 0.3, 0.3, 5.0};
  EXPECT_EQ(Shade(flat, FromViewer, Vector3::UnitX()), Color);
}

TEST(SurfaceShading, MatchesPhongModel)
{
  const SurfaceFinish finish{true, 0.1, 0.6, 0.25, 10.0};
  const double tilt = 0.3;
  const Vector3 normal(std::sin(tilt), 0.0, std::cos(tilt));
  const Vector3 shaded = Shade(finish, FromViewer, normal);
  // The reflected light leaves the viewing direction by twice the tilt.
  const Vector3 expected = (0.1 + 0.6 * std::cos(tilt)) * Color +
                           Vector3::Constant(0.25 * std::pow(std::cos(2.0 * tilt), 10.0));
  EXPECT_LT((shaded - expected).norm(), 1e-14);
}

TEST(SurfaceShading, SupportsFractionalPowers)
{
  const SurfaceFinish finish{true, 0.0, 0.0, 1.0, 3.7};
  const Vector3 normal(std::sin(0.2), 0.0, std::cos(0.2));
  const Vector3 shaded = Shade(finish, FromViewer, normal);
  EXPECT_NEAR(shaded[0], std::pow(std::cos(0.4), 3.7), 1e-14);
}

TEST(SurfaceShading, ShadesBothSidesAlike)
{
  const SurfaceFinish finish;
  const Vector3 normal = Vector3(0.2, -0.5, 0.6).normalized();
  EXPECT_EQ(Shade(finish, FromViewer, normal), Shade(finish, FromViewer, -normal));
}

TEST(SurfaceShading, LightBehindSurfaceAddsNothing)
{
  const SurfaceFinish finish;
  const SurfaceLight behind{false, -Vector3::UnitZ(), Vector3::Ones(), Vector3::Ones()};
  EXPECT_EQ(Shade(finish, behind, Vector3::UnitZ()), Vector3(finish.Ambient * Color));
}

TEST(SurfaceShading, PositionalLightShinesFromItsPosition)
{
  const SurfaceFinish finish{true, 0.0, 1.0, 0.0, 1.0};
  const SurfaceLight lamp{true, {3.0, 0.0, 4.0}, Vector3::Ones(), Vector3::Ones()};
  EXPECT_NEAR(Shade(finish, lamp, Vector3::UnitZ(), Vector3::Ones())[0], 0.8, 1e-15);
  EXPECT_TRUE(SurfaceShading(finish, {lamp}).NeedsPoints());
  EXPECT_FALSE(SurfaceShading(finish, {FromViewer}).NeedsPoints());
}
} // namespace
} // namespace palpate::surface_shading_test
