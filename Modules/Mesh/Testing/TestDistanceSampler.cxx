#include "DistanceSampler.h"

#include "MeshDistances.h"
#include "MeshShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace palpate::distance_sampler_test
{
namespace
{
// A plain rectangle in the plane z = height + slope x.
IndexedMesh Sheet(double height, double slope, double left, double right)
{
  const auto at = [&](double x, double y) { return Vector3(x, y, height + slope * x); };
  return {{at(left, 0.0), at(right, 0.0), at(right, 1.0), at(left, 1.0)}, {{0, 1, 2}, {0, 2, 3}}};
}

DistanceSamples Samples(const IndexedMesh& one, const IndexedMesh& other)
{
  ComparedSurface from;
  ComparedSurface to;
  EXPECT_TRUE(ComparedSurface::Make(one, from).IsOk());
  EXPECT_TRUE(ComparedSurface::Make(other, to).IsOk());
  return from.SamplesFrom(to);
}

// The centres of parts^2 equal parts of each triangle: an implementation of its own.
DistanceSummary ByDenseSampling(const IndexedMesh& one, const IndexedMesh& other, int parts)
{
  NearestOnMesh tree;
  EXPECT_TRUE(NearestOnMesh::Make(other, tree).IsOk());
  DistanceSamples dense;
  double area = 0.0;
  for (const std::array<int, 3>& t : one.Triangles)
  {
    const Vector3& a = one.Points[t[0]];
    const Vector3 u = (one.Points[t[1]] - a) / parts;
    const Vector3 v = (one.Points[t[2]] - a) / parts;
    for (int i = 0; i < parts; ++i)
    {
      for (int j = 0; i + j < parts; ++j)
      {
        dense.Points.emplace_back(a + (i + 1.0 / 3.0) * u + (j + 1.0 / 3.0) * v);
        if (i + j + 1 < parts)
        {
          dense.Points.emplace_back(a + (i + 2.0 / 3.0) * u + (j + 2.0 / 3.0) * v);
        }
      }
    }
    dense.Weights.resize(dense.Points.size(), u.cross(v).norm());
    area += u.cross(v).norm() * parts * parts;
  }
  for (double& weight : dense.Weights)
  {
    weight /= area;
  }
  dense.Values = tree.DistancesOf(dense.Points);
  dense.Largest = *std::max_element(dense.Values.begin(), dense.Values.end());
  return Summarise(dense);
}

void ExpectWithinOnePercent(const DistanceSummary& found, const DistanceSummary& expected)
{
  EXPECT_NEAR(found.Mean, expected.Mean, 0.01 * expected.Mean);
  EXPECT_NEAR(found.Rms, expected.Rms, 0.01 * expected.Rms);
  EXPECT_NEAR(found.Percentile95, expected.Percentile95, 0.01 * expected.Percentile95);
  EXPECT_GE(found.Largest, (1.0 - 1e-3) * expected.Largest);
}

// A surface with steps, as of a mask: of boxes side by side, whose walls inside it do not matter.
IndexedMesh Steps()
{
  IndexedMesh steps;
  for (int i = 0; i < 8; ++i)
  {
    for (int j = 0; j < 8; ++j)
    {
      const double height = 3.0 * std::floor(2.0 + std::cos(0.4 * i) + std::sin(0.5 * j));
      steps = test::Join(steps, test::Box(Vector3(i, j, 0.0), Vector3(i + 1.0, j + 1.0, height)));
    }
  }
  return steps;
}

TEST(DistanceSampler, OfTwoCrossingPlanesIsExactlyKnown)
{
  // |x - 0.3| for x in 0 to 1, over the cosine of the sheet's slope.
  const IndexedMesh sheet = Sheet(-0.3, 1.0, 0.0, 1.0);
  const IndexedMesh plane{{{-99, -99, 0}, {999, -99, 0}, {-99, 999, 0}}, {{0, 1, 2}}};
  const DistanceSummary found = Summarise(Samples(sheet, plane));
  EXPECT_NEAR(found.Mean, 0.5 * (0.09 + 0.49), 1e-3);
  EXPECT_NEAR(found.Rms, std::sqrt((0.027 + 0.343) / 3.0), 1e-3);
  EXPECT_NEAR(found.Percentile95, 0.65, 3e-3);
  EXPECT_NEAR(found.Largest, 0.7, 1e-12);
  EXPECT_NEAR(ShareWithin(Samples(sheet, plane), 0.2), 0.4, 5e-3);
}

TEST(DistanceSampler, EqualsDenseSamplingOfSteps)
{
  const IndexedMesh steps = Steps();
  const IndexedMesh smooth = test::Sphere(16, 6.0, {4.0, 4.0, 2.0});
  ExpectWithinOnePercent(Summarise(Samples(steps, smooth)), ByDenseSampling(steps, smooth, 24));
  ExpectWithinOnePercent(Summarise(Samples(smooth, steps)), ByDenseSampling(smooth, steps, 8));
}

TEST(DistanceSampler, EqualsDenseSamplingOfCoarseTriangles)
{
  // Of 12 and of 200 triangles, which the other surface's shape does not follow.
  const IndexedMesh box = test::Box({-4.0, -3.0, -2.0}, {4.0, 3.5, 2.0});
  const IndexedMesh torus = test::Torus(20, 5, 3.0, 1.0);
  ExpectWithinOnePercent(Summarise(Samples(box, torus)), ByDenseSampling(box, torus, 120));
  ExpectWithinOnePercent(Summarise(Samples(torus, box)), ByDenseSampling(torus, box, 24));
}

TEST(DistanceSampler, DoesNotDependOnTheUnitOfLength)
{
  const auto small = [](IndexedMesh mesh)
  {
    for (Vector3& point : mesh.Points)
    {
      point *= 1.0 / 64.0; // a power of two leaves the digits
    }
    return mesh;
  };
  const IndexedMesh steps = Steps();
  const IndexedMesh smooth = test::Sphere(12, 6.0, {4.0, 4.0, 2.0});
  const DistanceSummary large = Summarise(Samples(smooth, steps));
  const DistanceSummary scaled = Summarise(Samples(small(smooth), small(steps)));
  EXPECT_NEAR(64.0 * scaled.Mean, large.Mean, 1e-9);
  EXPECT_NEAR(64.0 * scaled.Percentile95, large.Percentile95, 1e-9);
  EXPECT_NEAR(64.0 * scaled.Largest, large.Largest, 1e-9);
}

TEST(DistanceSampler, FindsTheLargestDistanceWithinAFace)
{
  // From a triangle to three small ones at its corners: farthest is the circumcentre.
  IndexedMesh corners;
  const IndexedMesh triangle{{{0, 0, 0}, {10, 0, 0}, {3, 8, 0}}, {{0, 1, 2}}};
  for (const Vector3& corner : triangle.Points)
  {
    corners = test::Join(
        corners, {{corner, corner + Vector3(0, 0, 1), corner + Vector3(0, 0, 2)}, {{0, 1, 2}}});
  }
  const DistanceSamples samples = Samples(triangle, corners);
  const double sides[] = {10.0, std::sqrt(49.0 + 64.0), std::sqrt(9.0 + 64.0)};
  const double radius = sides[0] * sides[1] * sides[2] / (4.0 * 40.0);
  EXPECT_NEAR(samples.Largest, radius, 1e-3 * radius);
  EXPECT_LE(samples.Largest, radius + 1e-12);
  EXPECT_LT((samples.Farthest - Vector3(5.0, (9.0 + 64.0 - 30.0) / 16.0, 0.0)).norm(), 0.02);
}

TEST(DistanceSampler, FindsTheLargestDistanceFromABoxToASphere)
{
  // Nearest to the sphere's centre is a point of the left face, far from the box's 8 points.
  const IndexedMesh box = test::Box({-4.63, -5.2, -5.1}, {5.4, 5.6, 5.3});
  const DistanceSamples samples = Samples(box, test::Sphere(30, 20.0));
  EXPECT_NEAR(samples.Largest, 20.0 - 4.63, 1e-3 * 15.37 + 6e-3); // and the facets' depth
}

TEST(DistanceSampler, SamplesBeginWithThePointsAndWeighTheArea)
{
  const IndexedMesh mesh = test::Lobed(6);
  const DistanceSamples samples = Samples(mesh, test::Sphere(6, 1.5));
  ASSERT_GT(samples.Points.size(), mesh.Points.size());
  EXPECT_TRUE(std::equal(mesh.Points.begin(), mesh.Points.end(), samples.Points.begin()));
  EXPECT_NEAR(std::accumulate(samples.Weights.begin(), samples.Weights.end(), 0.0), 1.0, 1e-12);
  // The weighted mean of the points is that of the area.
  Vector3 centre = Vector3::Zero();
  for (std::size_t i = 0; i < samples.Points.size(); ++i)
  {
    centre += samples.Weights[i] * samples.Points[i];
  }
  Vector3 expected = Vector3::Zero();
  const std::vector<double> areas = PointAreas(mesh);
  for (std::size_t i = 0; i < areas.size(); ++i)
  {
    expected += areas[i] / std::accumulate(areas.begin(), areas.end(), 0.0) * mesh.Points[i];
  }
  EXPECT_LT((centre - expected).norm(), 1e-12);
}

TEST(DistanceSampler, TakesPointsOfACurvedSurface)
{
  // A coarse polyhedron of directions stands for the sphere itself.
  const SampledSurface sphere{test::Sphere(4),
                              [](const Vector3& place) { return Vector3(place.normalized()); }};
  DistanceSamples samples;
  ASSERT_TRUE(SampleDistances(
                  sphere,
                  [](const std::vector<Vector3>& points, std::vector<double>& distances)
                  {
                    for (const Vector3& point : points)
                    {
                      distances.push_back(2.0 - point.norm());
                    }
                    return Status::Success();
                  },
                  samples)
                  .IsOk());
  EXPECT_NEAR(Summarise(samples).Mean, 1.0, 1e-12);
  EXPECT_NEAR(samples.Largest, 1.0, 1e-12);
}

TEST(DistanceSampler, PassesFailureOn)
{
  DistanceSamples samples;
  const Status status = SampleDistances(
      {test::Sphere(2), {}},
      [](const std::vector<Vector3>&, std::vector<double>&) { return Status::Failure("no"); },
      samples);
  EXPECT_EQ(status.Message(), "no");
}

TEST(DistanceSampler, SurfaceWithoutAreaHasEqualWeights)
{
  const IndexedMesh line{{{0, 0, 1}, {1, 0, 2}, {2, 0, 3}}, {{0, 1, 2}}};
  const IndexedMesh plane{{{-99, -99, 0}, {999, -99, 0}, {-99, 999, 0}}, {{0, 1, 2}}};
  const DistanceSamples samples = Samples(line, plane);
  EXPECT_NEAR(Summarise(samples).Mean, 2.0, 1e-12);
  EXPECT_NEAR(samples.Largest, 3.0, 1e-12);
}
} // namespace
} // namespace palpate::distance_sampler_test
