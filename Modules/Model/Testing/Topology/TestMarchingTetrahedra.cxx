#include "FieldVolume.h"
#include "MarchingTetrahedra.h"
#include "TopologyPhantoms.h"

#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace palpate::marching_tetrahedra_test
{
namespace
{
using namespace palpate::phantoms;

palpate::ShapeField RandomField(std::mt19937_64& random)
{
  std::uniform_real_distribution<double> depth(0.1, 1.0);
  return Sampled(3.0, 0.5,
                 [&](const Vector3& point)
                 { return (random() % 2 == 0 ? 1.0 : -1.0) * depth(random); });
}

TEST(MarchingTetrahedra, ClosesRandomFieldsWithTheirTopology)
{
  std::mt19937_64 random(2);
  for (int round = 0; round < 10; ++round)
  {
    const palpate::ShapeField field = RandomField(random);
    palpate::IndexedMesh mesh;
    ASSERT_TRUE(palpate::MarchTetrahedra(field, mesh).IsOk());
    EXPECT_TRUE(IsClosedManifold(mesh));
    // The boundary of a three-manifold has twice its Euler characteristic.
    EXPECT_EQ(EulerOf(mesh), 2 * palpate::EulerCharacteristic(field.Grid, InsideOf(field)));
    // Fractions of tetrahedra are single precision.
    EXPECT_NEAR(VolumeOf(mesh), palpate::VolumeAbove(field, 0.0f), 1e-5 * VolumeOf(mesh));
  }
}

TEST(MarchingTetrahedra, PutsSphereWhereItIs)
{
  palpate::IndexedMesh mesh;
  const double spacing = 0.4;
  ASSERT_TRUE(palpate::MarchTetrahedra(
                  Sampled(6.0, spacing, [](const Vector3& p) { return Sphere(p, 5.0); }), mesh)
                  .IsOk());
  EXPECT_TRUE(IsClosedManifold(mesh));
  EXPECT_EQ(EulerOf(mesh), 2);
  for (const Vector3& point : mesh.Points)
  {
    // Linear along an edge of up to sqrt(3) steps: at most (edge / 2)^2 / (2 radius) inside.
    EXPECT_LE(point.norm(), 5.0 + 1e-6);
    EXPECT_GE(point.norm(), 5.0 - 0.75 * spacing * spacing / 10.0 - 1e-6);
  }
  const double sphere = 4.0 / 3.0 * std::acos(-1.0) * 125.0;
  EXPECT_NEAR(VolumeOf(mesh), sphere, 0.01 * sphere);
}

TEST(MarchingTetrahedra, MakesNoDegenerateTriangles)
{
  std::mt19937_64 random(3);
  palpate::ShapeField field = RandomField(random);
  for (float& value : field.Values)
  {
    value *= random() % 3 == 0 ? 1e-12f : 1.0f;
  }
  palpate::IndexedMesh mesh;
  ASSERT_TRUE(palpate::MarchTetrahedra(field, mesh).IsOk());
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    const auto point = [&](std::size_t n) -> const Vector3&
    { return mesh.Points[static_cast<std::size_t>(t[n])]; };
    // Vertices keep 1 % of an edge from its ends, so that heights are some 0.5 % of a step.
    ASSERT_GT((point(1) - point(0)).cross(point(2) - point(0)).norm(), 1e-5 * 0.25);
  }
}

TEST(MarchingTetrahedra, RejectsOpenAndMalformedFields)
{
  palpate::IndexedMesh mesh;
  const palpate::ShapeField sphere =
      Sampled(4.0, 1.0, [](const Vector3& p) { return Sphere(p, 3.0); });
  palpate::ShapeField field = sphere;
  field.Values.back() = 1.0f;
  EXPECT_FALSE(palpate::MarchTetrahedra(field, mesh).IsOk());
  field = sphere;
  field.Values[field.Values.size() / 2] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(palpate::MarchTetrahedra(field, mesh).IsOk());
  field = sphere;
  field.Values.pop_back();
  EXPECT_FALSE(palpate::MarchTetrahedra(field, mesh).IsOk());
  EXPECT_FALSE(palpate::MarchTetrahedra({}, mesh).IsOk());
}

TEST(FieldVolume, FindsLevelOfVolume)
{
  const palpate::ShapeField field =
      Sampled(8.0, 0.5, [](const Vector3& p) { return Sphere(p, 5.0); });
  for (const double radius : {2.0, 4.9, 6.5})
  {
    const double volume = 4.0 / 3.0 * std::acos(-1.0) * radius * radius * radius;
    const float level = palpate::LevelOfVolume(field, volume, 300.0);
    EXPECT_NEAR(palpate::VolumeAbove(field, level), volume, 1.1e-4 * volume);
    // The polyhedron's chords lie inside the sphere.
    EXPECT_NEAR(level, 5.0 - radius, 0.05);
  }
}

TEST(FieldVolume, ReturnsNearestLevelOnPlateau)
{
  // A jump of one step's width between two plateaus.
  const palpate::ShapeField field = Sampled(
      8.0, 0.5, [](const Vector3& p) { return p.cwiseAbs().maxCoeff() < 4.0 ? 1.0 : -1.0; });
  const double largest = palpate::VolumeAbove(field, -0.999f);
  const float level = palpate::LevelOfVolume(field, 10.0 * largest, 300.0);
  EXPECT_TRUE(std::isfinite(level));
  EXPECT_GE(palpate::VolumeAbove(field, level), 0.99 * largest);
}
} // namespace
} // namespace palpate::marching_tetrahedra_test
