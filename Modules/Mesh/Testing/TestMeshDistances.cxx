#include "MeshDistances.h"

#include "InstructionSets.h"
#include "MeshShapes.h"
#include "NearestOnMesh.h"
#include "RandomShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace palpate::mesh_distances_test
{
namespace
{
TEST(NearestOnMesh, EqualsBruteForce)
{
  test::Random random(71);
  std::normal_distribution<double> normal;
  for (const IndexedMesh& mesh : {test::Lobed(8), test::Torus(20, 10), test::MoebiusStrip(5)})
  {
    NearestOnMesh tree;
    ASSERT_TRUE(NearestOnMesh::Make(mesh, tree).IsOk());
    for (int i = 0; i < 200; ++i)
    {
      const Vector3 query = 15.0 * Vector3(normal(random), normal(random), normal(random));
      double least = std::numeric_limits<double>::infinity();
      for (const auto& t : mesh.Triangles)
      {
        least = std::min(least, (NearestOnTriangle(query, mesh.Points[t[0]], mesh.Points[t[1]],
                                                   mesh.Points[t[2]]) -
                                 query)
                                    .norm());
      }
      const NearestOnMesh::Result found = tree.Find(query);
      EXPECT_EQ(found.Distance, least);
      EXPECT_EQ((found.Point - query).norm(), least);
    }
  }
}

// Flat triangles and triangles of a point among the others; points on the mesh, near it and far.
IndexedMesh WithFlatTriangles(IndexedMesh mesh)
{
  const std::size_t triangles = mesh.Triangles.size();
  for (std::size_t i = 0; i < triangles; i += 7)
  {
    const std::array<int, 3> t = mesh.Triangles[i];
    mesh.Triangles.push_back({t[0], t[0], t[1]});
    mesh.Triangles.push_back({t[2], t[2], t[2]});
  }
  return mesh;
}

std::vector<Vector3> PointsAround(const IndexedMesh& mesh, test::Random& random)
{
  std::normal_distribution<double> normal;
  const auto offset = [&] { return Vector3(normal(random), normal(random), normal(random)); };
  std::vector<Vector3> points;
  for (const Vector3& point : mesh.Points)
  {
    points.insert(points.end(), {point, point + 0.1 * offset(), point + 30.0 * offset()});
  }
  return points;
}

TEST(NearestOnMesh, DistancesOfManyPointsAreThoseOfEachWithAnyInstructions)
{
  test::Random random(73);
  for (const IndexedMesh& whole : {test::Lobed(8), test::Torus(20, 10), test::MoebiusStrip(5)})
  {
    const IndexedMesh mesh = WithFlatTriangles(whole);
    const std::vector<Vector3> points = PointsAround(mesh, random);
    NearestOnMesh tree;
    ASSERT_TRUE(NearestOnMesh::Make(mesh, tree).IsOk());
    for (const InstructionSet set : test::RunnableInstructionSets())
    {
      const std::vector<double> distances = tree.DistancesOf(points, set);
      const std::vector<NearestOnMesh::Result> results = tree.FindAll(points, set);
      ASSERT_EQ(distances.size(), points.size());
      ASSERT_EQ(results.size(), points.size());
      for (std::size_t i = 0; i < distances.size(); ++i)
      {
        // Rounding, of coordinates up to 50 mm.
        EXPECT_NEAR(distances[i], tree.Find(points[i]).Distance, 1e-13) << i;
        EXPECT_NEAR(results[i].Distance, distances[i], 1e-13) << i;
        EXPECT_EQ((results[i].Point - points[i]).norm(), results[i].Distance) << i;
      }
    }
  }
}

// Against the definition: the least of the distances to a dense set of the triangle's points.
TEST(NearestOnMesh, OfTriangleIsNoFartherThanAnyOfItsPoints)
{
  test::Random random(72);
  std::normal_distribution<double> normal;
  const auto point = [&] { return Vector3(normal(random), normal(random), normal(random)); };
  for (int i = 0; i < 300; ++i)
  {
    const Vector3 a = point();
    const Vector3 b = point();
    const Vector3 c = point();
    const Vector3 query = 2.0 * point();
    const Vector3 nearest = NearestOnTriangle(query, a, b, c);
    constexpr int Parts = 40;
    double toPoints = std::numeric_limits<double>::infinity();
    double toNearest = std::numeric_limits<double>::infinity();
    for (int u = 0; u <= Parts; ++u)
    {
      for (int v = 0; u + v <= Parts; ++v)
      {
        const Vector3 p = a + (b - a) * u / Parts + (c - a) * v / Parts;
        toPoints = std::min(toPoints, (p - query).norm());
        toNearest = std::min(toNearest, (p - nearest).norm());
      }
    }
    EXPECT_LE((nearest - query).norm(), toPoints + 1e-12);
    // It is a point of the triangle: within a part of its edges of one of the others.
    EXPECT_LE(toNearest, ((b - a).norm() + (c - a).norm()) / Parts);
  }
}

TEST(NearestOnMesh, TreatsFlatTrianglesAsSegments)
{
  const IndexedMesh mesh{{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {9, 9, 9}},
                         {{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {3, 3, 3}, {1, 1, 2}}};
  NearestOnMesh tree;
  ASSERT_TRUE(NearestOnMesh::Make(mesh, tree).IsOk());
  EXPECT_NEAR(tree.Find({2, 2, 5}).Distance, std::sqrt(6.0), 1e-14);
  // Not quite on a line, by rounding.
  test::Random random(73);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i)
  {
    const Vector3 step(normal(random), normal(random), normal(random));
    const Vector3 from(normal(random), normal(random), normal(random));
    const IndexedMesh needle{{from + 0.1 * step, from - step, from + 2.0 * step}, {{0, 1, 2}}};
    ASSERT_TRUE(NearestOnMesh::Make(needle, tree).IsOk());
    const Vector3 out = step.unitOrthogonal();
    EXPECT_NEAR(tree.Find(from + 1.7 * step + out).Distance, 1.0, 1e-14);
    EXPECT_NEAR(tree.Find(from - 0.9 * step + out).Distance, 1.0, 1e-14);
  }
}

TEST(NearestOnMesh, FindsNearestFlatTriangle)
{
  const IndexedMesh mesh{{{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {9, 9, 9}},
                         {{0, 1, 2}, {0, 2, 1}, {1, 2, 0}, {3, 3, 3}, {1, 1, 2}}};
  NearestOnMesh tree;
  ASSERT_TRUE(NearestOnMesh::Make(mesh, tree).IsOk());
  EXPECT_NEAR(tree.Find({9, 9, 10}).Distance, 1.0, 1e-14);
  EXPECT_EQ(tree.Find({9, 9, 10}).Triangle, 3);
  EXPECT_NEAR(tree.Find({-1, -1, -1}).Distance, std::sqrt(3.0), 1e-14);
}

TEST(NearestOnMesh, KeepsDigitsFarFromOrigin)
{
  // Single precision has steps of 64 mm here.
  const Vector3 far(1e9, 1e9, -1e9);
  NearestOnMesh tree;
  ASSERT_TRUE(NearestOnMesh::Make(test::Box(far, far + Vector3(1, 1, 1)), tree).IsOk());
  EXPECT_EQ(tree.Find(far + Vector3(0.5, 0.5, 3.0)).Distance, 2.0);
  EXPECT_EQ(tree.Find(far + Vector3(0.5, 0.25, 0.5)).Distance, 0.25);
}

TEST(MeshDistances, OfConcentricBoxesAreKnown)
{
  // The inner box is 1 mm inside; from the outer one's faces of 6 mm it has the distance of a
  // square of 4 mm in a plane 1 mm below.
  MeshDistances distances;
  ASSERT_TRUE(MeasureMeshDistances(test::Box({1, 1, 1}, {5, 5, 5}), test::Box({0, 0, 0}, {6, 6, 6}),
                                   distances)
                  .IsOk());
  for (const double value : {distances.OneToOther.Mean, distances.OneToOther.Rms,
                             distances.OneToOther.Percentile95, distances.OneToOther.Largest})
  {
    EXPECT_NEAR(value, 1.0, 1e-13);
  }
  constexpr int Steps = 600;
  double mean = 0.0;
  double square = 0.0;
  for (int i = 0; i < Steps; ++i)
  {
    for (int j = 0; j < Steps; ++j)
    {
      const double y = std::max(0.0, std::abs(-3.0 + 6.0 * (i + 0.5) / Steps) - 2.0);
      const double z = std::max(0.0, std::abs(-3.0 + 6.0 * (j + 0.5) / Steps) - 2.0);
      mean += std::sqrt(1.0 + y * y + z * z) / (Steps * Steps);
      square += (1.0 + y * y + z * z) / (Steps * Steps);
    }
  }
  EXPECT_NEAR(distances.OtherToOne.Mean, mean, 1e-3);
  EXPECT_NEAR(distances.OtherToOne.Rms, std::sqrt(square), 1e-3);
  EXPECT_NEAR(distances.OtherToOne.Largest, std::sqrt(3.0), 1e-13);
  EXPECT_NEAR(distances.Both.Mean, 0.5 * (1.0 + mean), 1e-3);
  EXPECT_NEAR(distances.Both.Rms, std::sqrt(0.5 * (1.0 + square)), 1e-3);
  EXPECT_NEAR(distances.Both.Largest, std::sqrt(3.0), 1e-13);
}

TEST(NearestOnMesh, IsIndependentOfStart)
{
  test::Random random(73);
  std::normal_distribution<double> normal;
  const IndexedMesh mesh = test::Lobed(8);
  NearestOnMesh tree;
  ASSERT_TRUE(NearestOnMesh::Make(mesh, tree).IsOk());
  const auto count = static_cast<int>(mesh.Triangles.size());
  for (int i = 0; i < 200; ++i)
  {
    const Vector3 query = 15.0 * Vector3(normal(random), normal(random), normal(random));
    EXPECT_EQ(tree.FindFrom(query, 37 * i % count).Distance, tree.Find(query).Distance);
  }
}

// Against sorting all distances; few different values, so that many are equal.
TEST(MeshDistances, PercentileIsThatOfSortedDistances)
{
  test::Random random(74);
  std::uniform_int_distribution<int> value(0, 60);
  std::uniform_real_distribution<double> weight(0.0, 1.0);
  for (int round = 0; round < 50; ++round)
  {
    DistanceSamples samples;
    std::vector<double>& distances = samples.Values;
    std::vector<double>& weights = samples.Weights;
    distances.resize(1 + static_cast<std::size_t>(round) * 7);
    weights.resize(distances.size());
    std::generate(distances.begin(), distances.end(), [&] { return 0.1 * value(random); });
    std::generate(weights.begin(), weights.end(), [&] { return weight(random); });
    const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
    std::for_each(weights.begin(), weights.end(), [sum](double& w) { w /= sum; });
    const double found = Summarise(samples).Percentile95;
    double beyond = 0.0;
    double before = 0.0; // of the next smaller distance
    double next = -1.0;
    for (std::size_t i = 0; i < distances.size(); ++i)
    {
      beyond += distances[i] > found ? weights[i] : 0.0;
      next = distances[i] < found ? std::max(next, distances[i]) : next;
    }
    for (std::size_t i = 0; i < distances.size(); ++i)
    {
      before += distances[i] > next ? weights[i] : 0.0;
    }
    EXPECT_LE(beyond, 0.05);
    EXPECT_GT(before, 0.05);
  }
}

TEST(MeshDistances, WhatIsAtTheToleranceIsWithin)
{
  const DistanceSamples samples{{}, {-2.0, 1.0, 2.0, 2.5}, {0.1, 0.2, 0.3, 0.4}};
  EXPECT_DOUBLE_EQ(ShareWithin(samples, 2.0), 0.6);
  EXPECT_DOUBLE_EQ(ShareWithin(samples, 1.0), 0.2);
  EXPECT_EQ(ShareWithin(samples, 0.5), 0.0);
  EXPECT_EQ(ShareWithin(samples, 3.0), 1.0);
}

TEST(MeshDistances, SummaryHasNoSigns)
{
  const DistanceSamples samples{{}, {-2.0, 1.0, 2.0, 2.5}, {0.1, 0.2, 0.3, 0.4}};
  const DistanceSummary summary = Summarise(samples);
  EXPECT_DOUBLE_EQ(summary.Mean, 2.0);
  EXPECT_DOUBLE_EQ(summary.Rms, std::sqrt(4.3));
  EXPECT_EQ(summary.Percentile95, 2.5);
}

TEST(MeshDistances, AreSymmetric)
{
  MeshDistances there;
  MeshDistances back;
  ASSERT_TRUE(MeasureMeshDistances(test::Sphere(4), test::Lobed(8), there).IsOk());
  ASSERT_TRUE(MeasureMeshDistances(test::Lobed(8), test::Sphere(4), back).IsOk());
  EXPECT_EQ(there.Both.Mean, back.Both.Mean);
  EXPECT_EQ(there.Both.Rms, back.Both.Rms);
  EXPECT_EQ(there.Both.Percentile95, back.Both.Percentile95);
  EXPECT_EQ(there.Both.Largest, back.Both.Largest);
}

TEST(MeshDistances, WeighTrianglesByArea)
{
  // 40 small triangles at height 1 have 4 % of the area of a large one at height 3.
  IndexedMesh mesh;
  const auto add = [&mesh](double x, double size, double height)
  {
    const int first = static_cast<int>(mesh.Points.size());
    mesh.Points.emplace_back(x, 0.0, height);
    mesh.Points.emplace_back(x + size, 0.0, height);
    mesh.Points.emplace_back(x, size, height);
    mesh.Triangles.push_back({first, first + 1, first + 2});
  };
  add(0.0, 10.0, 3.0);
  for (int i = 0; i < 40; ++i)
  {
    add(0.1 * i, std::sqrt(0.1), 1.0);
  }
  const IndexedMesh plane{{{-99, -99, 0}, {999, -99, 0}, {-99, 999, 0}}, {{0, 1, 2}}};
  MeshDistances distances;
  ASSERT_TRUE(MeasureMeshDistances(mesh, plane, distances).IsOk());
  EXPECT_NEAR(distances.OneToOther.Mean, (3.0 * 100.0 + 4.0) / 104.0, 1e-12);
  EXPECT_NEAR(distances.OneToOther.Percentile95, 3.0, 1e-12);
  const std::vector<double> areas = PointAreas(mesh);
  EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), 52.0, 1e-12);
}

TEST(MeshDistances, RejectBadInput)
{
  MeshDistances distances;
  const IndexedMesh sphere = test::Sphere(2);
  EXPECT_FALSE(MeasureMeshDistances(sphere, {}, distances).IsOk());
  EXPECT_FALSE(MeasureMeshDistances({}, sphere, distances).IsOk());
  IndexedMesh bad = sphere;
  bad.Points[1][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(MeasureMeshDistances(sphere, bad, distances).IsOk());
}
} // namespace
} // namespace palpate::mesh_distances_test
