#include "Calibre.h"

#include "ComparedCases.h"
#include "MeshShapes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace palpate::calibre_test
{
namespace
{
using Vector2 = Eigen::Vector2d;

struct TubeShape
{
  double Length;                                 // mm along the axis
  std::function<Vector3(double along)> Axis;     // in the plane x, z
  std::function<Vector2(double along)> SemiAxes; // within that plane, and along y
};

// A closed tube of rings with flat ends.
IndexedMesh TubeOf(const TubeShape& shape, int rings, int around)
{
  IndexedMesh mesh;
  for (int i = 0; i <= rings; ++i)
  {
    const double along = shape.Length * i / rings;
    const Vector3 tangent = (shape.Axis(along + 1e-4) - shape.Axis(along - 1e-4)).normalized();
    const Vector3 out = Vector3::UnitY().cross(tangent);
    const Vector2 size = shape.SemiAxes(along);
    for (int j = 0; j < around; ++j)
    {
      const double angle = 2.0 * M_PI * j / around;
      mesh.Points.emplace_back(shape.Axis(along) + size[0] * std::cos(angle) * out +
                               size[1] * std::sin(angle) * Vector3::UnitY());
    }
  }
  const int last = rings * around;
  const int low = static_cast<int>(mesh.Points.size());
  mesh.Points.push_back(shape.Axis(0.0));
  mesh.Points.push_back(shape.Axis(shape.Length));
  for (int j = 0; j < around; ++j)
  {
    const int next = (j + 1) % around;
    mesh.Triangles.push_back({low, j, next});
    mesh.Triangles.push_back({low + 1, last + next, last + j});
    for (int i = 0; i < last; i += around)
    {
      mesh.Triangles.push_back({i + j, i + around + j, i + around + next});
      mesh.Triangles.push_back({i + j, i + around + next, i + next});
    }
  }
  return mesh;
}

// Small triangles, also at the ends, turned outwards.
IndexedMesh Measured(const TubeShape& shape)
{
  return test::BodyOfMesh(TubeOf(shape, 120, 36)).Surface();
}

Calibre CalibreOf(const IndexedMesh& mesh)
{
  Calibre calibre;
  const Status status = MeasureCalibre(mesh, calibre);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return calibre;
}

std::string Refusal(const IndexedMesh& mesh)
{
  Calibre calibre;
  const Status status = MeasureCalibre(mesh, calibre);
  EXPECT_FALSE(status.IsOk());
  EXPECT_TRUE(calibre.Sections.empty());
  return status.Message();
}

TubeShape Straight(double length, double one, double other)
{
  return {length, [](double along) { return Vector3(3.0, -2.0, along); },
          [=](double) { return Vector2(one, other); }};
}

// On a circle with this radius.
TubeShape Bent(double bend, double angle, double radius)
{
  return {bend * angle,
          [bend](double along)
          { return Vector3(bend * std::cos(along / bend), 0.0, bend * std::sin(along / bend)); },
          [radius](double) { return Vector2(radius, radius); }};
}

constexpr double Percent = 0.01;

TEST(Calibre, OfACylinderIsItsDiameter)
{
  const Calibre calibre = CalibreOf(Measured(Straight(60.0, 4.0, 4.0)));
  EXPECT_NEAR(calibre.Length, 60.0, 0.5 * Percent * 60.0);
  ASSERT_GT(calibre.Sections.size(), 20U);
  for (const CalibreSection& section : calibre.Sections)
  {
    EXPECT_NEAR(section.Diameter(), 8.0, Percent * 8.0); // a polygon with 36 corners has 0.5 % less
    EXPECT_NEAR(section.Center.z() < 30.0 ? section.Center.z() : 60.0 - section.Center.z(),
                std::min(section.Along, calibre.Length - section.Along), 0.3);
    EXPECT_NEAR((section.Center - Vector3(3.0, -2.0, section.Center.z())).norm(), 0.0, 0.02);
  }
}

TEST(Calibre, OfAnEllipticCylinderHasBothWidths)
{
  for (const CalibreSection& section : CalibreOf(Measured(Straight(70.0, 3.0, 5.0))).Sections)
  {
    EXPECT_NEAR(section.Least, 6.0, 2 * Percent * 6.0);
    EXPECT_NEAR(section.Largest, 10.0, Percent * 10.0);
    EXPECT_NEAR(section.Area, 15.0 * M_PI, 2 * Percent * 15.0 * M_PI);
  }
}

TEST(Calibre, OfATorusIsThatOfItsTube)
{
  const Calibre calibre = CalibreOf(Measured(Bent(20.0, 4.5, 4.0)));
  EXPECT_NEAR(calibre.Length, 90.0, 2 * Percent * 90.0);
  for (const CalibreSection& section : calibre.Sections)
  {
    EXPECT_NEAR(section.Diameter(), 8.0, 2 * Percent * 8.0);
    EXPECT_NEAR(std::hypot(section.Center.x(), section.Center.z()), 20.0, 0.2);
  }
}

// A bend so tight that curves of equal distance from an end are far from sections.
TEST(Calibre, OfATightTorusIsThatOfItsTube)
{
  const Calibre calibre = CalibreOf(Measured(Bent(9.0, 5.2, 4.0)));
  EXPECT_NEAR(calibre.Length, 46.8, 3 * Percent * 46.8); // it goes straight on at the ends
  for (const CalibreSection& section : calibre.Sections)
  {
    EXPECT_NEAR(section.Diameter(), 8.0, 2 * Percent * 8.0);
  }
}

TEST(Calibre, OfAConeGrowsAlongIt)
{
  TubeShape cone = Straight(80.0, 0.0, 0.0);
  const auto radius = [](double along) { return 2.0 + along * 4.0 / 80.0; };
  cone.SemiAxes = [=](double along) { return Vector2(radius(along), radius(along)); };
  const Calibre calibre = CalibreOf(Measured(cone));
  EXPECT_NEAR(calibre.Length, 80.0, Percent * 80.0);
  for (const CalibreSection& section : calibre.Sections)
  {
    const double diameter = 2.0 * radius(section.Center.z());
    EXPECT_NEAR(section.Diameter(), diameter, Percent * diameter);
  }
}

// An S with a bend in each direction, whose radius changes.
TEST(Calibre, OfACurvedTubeIsItsRadiusThere)
{
  constexpr double Bend = 25.0;
  TubeShape snake = Bent(Bend, M_PI, 0.0);
  snake.Length = 2.0 * M_PI * Bend;
  snake.Axis = [](double along)
  {
    const double angle = along / Bend;
    return angle < M_PI
               ? Vector3(Bend * std::cos(angle), 0.0, Bend * std::sin(angle))
               : Vector3(-2.0 * Bend - Bend * std::cos(angle), 0.0, Bend * std::sin(angle));
  };
  const double length = snake.Length;
  const auto radius = [=](double along) { return 4.0 + std::sin(4.0 * M_PI * along / length); };
  snake.SemiAxes = [=](double along) { return Vector2(radius(along), radius(along)); };
  const Calibre calibre = CalibreOf(Measured(snake));
  EXPECT_NEAR(calibre.Length, length, 2 * Percent * length);
  const bool isTurned = calibre.Sections.front().Center.x() < 0.0;
  for (const CalibreSection& section : calibre.Sections)
  {
    const double along = isTurned ? calibre.Length - section.Along : section.Along;
    EXPECT_NEAR(section.Diameter(), 2.0 * radius(along), 2 * Percent * 2.0 * radius(along));
  }
}

TEST(Calibre, OfAMaskIsThatOfItsShape)
{
  IndexToWorld toWorld;
  toWorld.Origin = Vector3(-8.3, -8.1, -3.0);
  const auto isIn = [](const Vector3& world)
  {
    const double across = std::hypot(world.x() - 0.1 * world.z(), world.y());
    return across < 5.0 && world.z() > 0.0 && world.z() < 60.0;
  };
  const ComparedBody steps = test::BodyOfVoxels({24, 17, 70}, toWorld, isIn);
  ComparedBody body;
  ASSERT_TRUE(ComparedBody::OfMaskShape(steps.Mask()->Voxels, toWorld, body).IsOk());
  const Calibre calibre = CalibreOf(body.Surface());
  const double slant = std::hypot(1.0, 0.1);      // the axis is as much longer, a section narrower
  EXPECT_NEAR(calibre.Length, 60.0 * slant, 1.0); // a voxel
  EXPECT_NEAR(calibre.At(0.5).Diameter(), 10.0 / std::sqrt(slant), 0.15);
}

TEST(Calibre, MedianIsBetweenTheExtremes)
{
  Calibre calibre;
  for (const double area : {3.0, 9.0, 1.0})
  {
    calibre.Sections.push_back({});
    calibre.Sections.back().Area = area;
  }
  EXPECT_EQ(calibre.At(0.0).Area, 1.0);
  EXPECT_EQ(calibre.At(0.5).Area, 3.0);
  EXPECT_EQ(calibre.At(1.0).Area, 9.0);
}

// Voxels of 1 mm within 4 mm of segments from the middle to these tips, in the plane x, z.
IndexedMesh Limbs(const std::vector<Vector3>& tips)
{
  IndexToWorld toWorld;
  toWorld.Origin = Vector3(-41.0, -6.0, -66.0);
  const auto isIn = [&](const Vector3& world)
  {
    return std::any_of(tips.begin(), tips.end(),
                       [&](const Vector3& tip)
                       {
                         const double part =
                             std::clamp(world.dot(tip) / tip.squaredNorm(), 0.0, 1.0);
                         return (world - part * tip).norm() < 4.0;
                       });
  };
  return test::BodyOfVoxels({83, 13, 133}, toWorld, isIn).Surface();
}

TEST(Calibre, BranchesAreNamed)
{
  EXPECT_NE(
      Refusal(Limbs({{0.0, 0.0, -60.0}, {30.0, 0.0, 50.0}, {-30.0, 0.0, 45.0}})).find("branches"),
      std::string::npos);
  const std::string message =
      Refusal(Limbs({{0.0, 0.0, -60.0}, {0.0, 0.0, 60.0}, {16.0, 0.0, 16.0}}));
  EXPECT_NE(message.find("branches"), std::string::npos) << message;
  CalibreOf(Limbs({{0.0, 0.0, -60.0}, {30.0, 0.0, 50.0}}));
}

TEST(Calibre, RingsAreNamed)
{
  EXPECT_NE(Refusal(test::Torus(200, 30, 20.0, 3.0)).find("rings"), std::string::npos);
}

TEST(Calibre, ShortBodiesHaveNone)
{
  EXPECT_NE(Refusal(test::Sphere(20, 10.0)).find("not long"), std::string::npos);
  EXPECT_NE(Refusal({}).find("no inside"), std::string::npos);
}
} // namespace
} // namespace palpate::calibre_test
