#include "MeshCases.h"
#include "WorstCase.h"

#include <algorithm>
#include <limits>

namespace palpate::facet_tree_test
{
namespace
{
using test::Mesh;
using test::Random;
using test::RandomDirection;
using test::WorstCase;

// Of coordinates of some 100 mm.
constexpr double Rounding = 1e-11;

// Brute force.
double DistanceByTrial(const Mesh& mesh, const Vector3& point)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    const Facet facet = mesh.FacetAt(i);
    least = std::min(least, (point - ClosestPointOnFacet(point, facet)).norm());
  }
  return least;
}

TEST(TriangleSweep, ClosestPointIsTheBestOfManySamples)
{
  Random random(6101);
  for (int sample = 0; sample < 300; ++sample)
  {
    const Facet facet{RandomDirection(random), RandomDirection(random), RandomDirection(random)};
    const Vector3 point = 2.0 * RandomDirection(random);
    const Vector3 closest = ClosestPointOnFacet(point, facet);
    double least = std::numeric_limits<double>::infinity();
    constexpr int Steps = 60;
    for (int i = 0; i <= Steps; ++i)
    {
      for (int j = 0; i + j <= Steps; ++j)
      {
        const double b = 1.0 * i / Steps;
        const double c = 1.0 * j / Steps;
        const Vector3 place = (1.0 - b - c) * facet.A + b * facet.B + c * facet.C;
        least = std::min(least, (place - point).norm());
      }
    }
    EXPECT_LE((closest - point).norm(), least + Rounding);
    EXPECT_GE((closest - point).norm(), least - 2.0 / Steps); // sides are up to 2 long
  }
}

TEST(FacetTree, NearestPointEqualsBruteForce)
{
  Random random(6102);
  const Mesh mesh = test::MeshOf(test::RandomOrgan(random, 8), 8);
  const auto tree = test::TreeOf(mesh);
  const Vector3 middle = tree->BoundsWorld().center();
  for (int sample = 0; sample < 300; ++sample)
  {
    const Vector3 point = middle + 0.2 * sample * RandomDirection(random);
    const double least = DistanceByTrial(mesh, point);
    const auto nearest = tree->NearestTo(point, std::numeric_limits<double>::infinity());
    EXPECT_NEAR(nearest.Distance, least, Rounding);
    EXPECT_NEAR((nearest.PointWorld - point).norm(), least, Rounding);
    EXPECT_EQ(tree->NearestTo(point, 0.999 * least).Distance,
              std::numeric_limits<double>::infinity());
  }
}

TEST(FacetTree, SweptSphereStopsAtFirstContact)
{
  Random random(6103);
  const RadialModel organ = test::RandomOrgan(random, 8);
  const Mesh mesh = test::MeshOf(organ, 8);
  const auto tree = test::TreeOf(mesh);
  int hits = 0;
  WorstCase gap;
  for (int sample = 0; sample < 400; ++sample)
  {
    const double radius = sample % 2 == 0 ? 1e-5 : 3.0;
    const Vector3 start = organ.CenterWorld() + 40.0 * RandomDirection(random);
    const Vector3 path = organ.CenterWorld() + 25.0 * RandomDirection(random) - start;
    const SweepHit hit = tree->Sweep({start, path, radius});
    hits += hit.IsHit ? 1 : 0;
    // No place before is nearer than the radius.
    for (int step = 0; step < 20; ++step)
    {
      const Vector3 place = start + hit.Part * step / 20.0 * path;
      ASSERT_GE(DistanceByTrial(mesh, place), radius - Rounding);
    }
    if (hit.IsHit)
    {
      const Vector3 end = start + hit.Part * path;
      gap.Add(DistanceByTrial(mesh, end) - radius);
      ASSERT_NEAR(tree->NearestTo(end - radius * hit.Normal, 1.0).Distance, 0.0, 1e-6);
    }
  }
  EXPECT_GT(hits, 200);
  EXPECT_LT(hits, 400);
  // Roots of radius^2 together with distances of 60 mm leave 60^2 1e-16 / 1e-5.
  EXPECT_LE(gap.Value(), 1e-7);
}

TEST(FacetTree, DistinguishesInsideFromOutside)
{
  Random random(6104);
  const RadialModel organ = test::RandomOrgan(random, 8);
  const auto tree = test::TreeOf(test::MeshOf(organ, 12));
  for (int sample = 0; sample < 500; ++sample)
  {
    const Vector3 u = RandomDirection(random);
    // Facets are up to 0.1 mm below the surface from which they were made.
    EXPECT_TRUE(tree->IsInside(organ.CenterWorld() + (organ.Radius(u) - 0.5) * u));
    EXPECT_FALSE(tree->IsInside(organ.CenterWorld() + (organ.Radius(u) + 0.1) * u));
  }
}

TEST(FacetTree, RejectsInvalidMesh)
{
  const Mesh box = test::BoxMesh(Vector3::Ones());
  std::shared_ptr<const FacetTree> tree;
  Mesh bad = box;
  bad.Points[3][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(FacetTree::Make(bad.Points, bad.Triangles, tree).IsOk());
  for (const int number : {-1, 8})
  {
    bad = box;
    bad.Triangles[2][1] = number;
    EXPECT_FALSE(FacetTree::Make(bad.Points, bad.Triangles, tree).IsOk());
  }
  EXPECT_FALSE(FacetTree::Make(box.Points, {{0, 0, 1}, {2, 2, 2}}, tree).IsOk());
  EXPECT_FALSE(FacetTree::Make({}, {}, tree).IsOk());
  EXPECT_EQ(tree, nullptr);
  bad = box;
  bad.Triangles.push_back({0, 0, 1}); // degenerate, so it is skipped
  ASSERT_TRUE(FacetTree::Make(bad.Points, bad.Triangles, tree).IsOk());
  EXPECT_EQ(tree->Bytes(), test::TreeOf(box)->Bytes());
}
} // namespace
} // namespace palpate::facet_tree_test
