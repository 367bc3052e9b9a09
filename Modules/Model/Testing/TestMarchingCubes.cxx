#include "MarchingCubes.h"

#include "SurfaceTopology.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace palpate::marching_cubes_test
{
namespace
{
SampledGrid GridOf(const std::vector<float>& values, const std::array<int, 3>& size, float beyond)
{
  const auto row = [&values, size](int j, int k, float* to)
  {
    const auto first = static_cast<std::size_t>((k * size[1] + j) * size[0]);
    std::copy_n(&values[first], size[0], to);
  };
  return {size, row, beyond};
}

IndexedMesh Marched(const std::vector<float>& values, const std::array<int, 3>& size, float level,
                    float beyond)
{
  IndexedMesh mesh;
  EXPECT_TRUE(MarchCubes(GridOf(values, size, beyond), level, mesh));
  return mesh;
}

// Distance from a sphere's surface, positive inside.
std::vector<float> Sphere(int size, double radius)
{
  std::vector<float> values;
  const double middle = 0.5 * (size - 1) + 0.1; // no sample lies on an axis
  for (int i = 0; i < size * size * size; ++i)
  {
    const Vector3 at(i % size, i / size % size, i / size / size);
    values.push_back(static_cast<float>(radius - (at - Vector3::Constant(middle)).norm()));
  }
  return values;
}

TEST(MarchingCubes, ConvergesToASphereWithTheSquareOfTheStep)
{
  double last = 1.0;
  for (const int size : {12, 24, 48})
  {
    const double radius = 0.4 * size;
    const IndexedMesh mesh = Marched(Sphere(size, radius), {size, size, size}, 0.0F, -1e3F);
    const EnclosedMeasure measure = MeasureEnclosed(mesh);
    const double lost = 1.0 - measure.Volume / (4.0 / 3.0 * M_PI * std::pow(radius, 3));
    EXPECT_GT(lost, 0.0) << "chords lie inside, and triangles face outwards";
    EXPECT_LT(lost, 0.3 * last);
    last = lost;
  }
}

// Each of the 256 cubes is next to each other one, with every face between them.
TEST(MarchingCubes, AreClosedOrientedManifoldsForAnySamples)
{
  std::mt19937_64 random(5);
  for (int round = 0; round < 40; ++round)
  {
    const std::array<int, 3> size{9, 11, 10};
    std::bernoulli_distribution isInside(0.1 + 0.02 * round);
    std::uniform_real_distribution<float> depth(0.0F, 1.0F);
    std::vector<float> values(9 * 11 * 10);
    for (float& value : values)
    {
      value = isInside(random) ? depth(random) : -depth(random); // some of them 0
    }
    const SurfaceTopology topology = DescribeTopology(Marched(values, size, 0.0F, -1.0F));
    EXPECT_TRUE(topology.IsConsistent()) << round;
    EXPECT_EQ(topology.NonManifoldEdges, 0) << round;
    EXPECT_EQ(topology.PinchedPoints, 0) << round;
    EXPECT_EQ(topology.DegenerateTriangles + topology.FlatTriangles, 0) << round;
  }
}

TEST(MarchingCubes, SamplesAtTheLevelAreOutside)
{
  std::vector<float> values(27, 0.0F);
  EXPECT_TRUE(Marched(values, {3, 3, 3}, 0.0F, 0.0F).Triangles.empty());
  values[13] = 1.0F;
  const IndexedMesh mesh = Marched(values, {3, 3, 3}, 0.0F, 0.0F);
  EXPECT_EQ(mesh.Triangles.size(), 8U) << "an octahedron";
  for (const Vector3& point : mesh.Points)
  {
    EXPECT_NEAR((point - Vector3::Ones()).norm(), 0.999, 1e-12) << "not on the neighbours";
  }
}

TEST(MarchingCubes, AreClosedBeyondTheGrid)
{
  const IndexedMesh mesh = Marched(std::vector<float>(60, 2.0F), {3, 4, 5}, 1.0F, 0.0F);
  EXPECT_EQ(FaultOfGenusZero(DescribeTopology(mesh)), "");
  double least = 1.0;
  for (const Vector3& point : mesh.Points)
  {
    least = std::min(least, point.minCoeff());
  }
  EXPECT_DOUBLE_EQ(least, -0.5) << "half way to the samples beyond";
}
} // namespace
} // namespace palpate::marching_cubes_test
