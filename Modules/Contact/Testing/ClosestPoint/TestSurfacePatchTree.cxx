#include "SurfacePatchTree.h"

#include "RadiusDerivativeBounds.h"
#include "RandomShapes.h"
#include "SphericalTriangle.h"
#include "SurfacePatch.h"

#include <gtest/gtest.h>

namespace palpate::surface_patch_tree_test
{
namespace
{
using test::Random;

// A unit vector inside a triangle, sometimes on its edges and corners.
Vector3 RandomInside(Random& random, const SphericalTriangle& triangle)
{
  std::uniform_real_distribution<double> uniform(-0.1, 1.0);
  Vector3 sum = Vector3::Zero();
  for (const Vector3& corner : triangle.Corners)
  {
    sum += std::max(1e-9, uniform(random)) * corner;
  }
  return sum.normalized();
}

Vector3 RandomQuery(Random& random)
{
  std::uniform_real_distribution<double> distance(0.0, 60.0);
  return distance(random) * test::RandomDirection(random);
}

TEST(RadiusDerivativeBounds, HoldEverywhereAndAreTight)
{
  Random random(922);
  for (const int degree : {0, 1, 2, 5, 12, 24})
  {
    const RadialModel model = test::RandomOrgan(random, degree);
    const RadiusDerivativeBounds bounds(model);
    std::array<double, 5> largest{};
    for (int i = 0; i < 3000; ++i)
    {
      const Vector3 u = test::RandomDirection(random);
      const Vector3 t = u.cross(test::RandomDirection(random)).normalized();
      const auto second = [&](double angle)
      {
        const Vector3 v = std::cos(angle) * u + std::sin(angle) * t;
        const Vector3 tangent = std::cos(angle) * t - std::sin(angle) * u;
        return tangent.dot(model.EvaluateSecondOrder(v).SurfaceHessian * tangent);
      };
      const auto s = model.EvaluateSecondOrder(u);
      constexpr double H = 1e-4;
      const double third = (second(H) - second(-H)) / (2.0 * H);
      const double slope = s.SurfaceGradient.dot(t);
      const double bend = second(0.0);
      const Vector3 pointThird = (third - 3.0 * slope) * u + (3.0 * bend - s.Radius) * t;
      const std::array<double, 5> sizes{std::abs(s.Radius), std::abs(slope), std::abs(bend),
                                        std::abs(third), pointThird.norm()};
      for (std::size_t k = 0; k < sizes.size(); ++k)
      {
        largest[k] = std::max(largest[k], sizes[k]);
      }
    }
    for (std::size_t k = 0; k < 5; ++k)
    {
      const double bound = k < 4 ? bounds.Radius[k] : bounds.PointThird;
      // The difference has an error of H^2 / 6 times fifth derivatives.
      EXPECT_LE(largest[k], bound * (1.0 + 1e-5) + 1e-9) << degree << " derivative " << k;
      // Margin: a factor of 2 for gaps and for 3000 directions missing the maximum, and for the
      // third derivative Bernstein's.
      EXPECT_GE(largest[k] * (k < 3 ? 2.0 : 8.0), bound * (1.0 - 1e-5) - 1e-9)
          << degree << " derivative " << k;
    }
  }
}

TEST(SurfacePatch, ContainsItsPartOfSurface)
{
  Random random(923);
  for (const double decay : {2.0, 1.0})
  {
    std::vector<double> c = test::RandomCoefficients(random, 12, decay);
    c[0] = 10.0;
    const RadialModel model(12, c, Vector3::Zero());
    const double third = RadiusDerivativeBounds(model).PointThird;
    for (int i = 0; i < 300; ++i)
    {
      const Vector3 u = test::RandomDirection(random);
      const double reach = std::pow(10.0, std::uniform_real_distribution<double>(-4, -0.3)(random));
      const SurfacePatch patch(u, model.EvaluateSecondOrder(u), reach, third);
      for (int k = 0; k < 30; ++k)
      {
        const double angle =
            k == 0 ? reach : reach * std::uniform_real_distribution<double>()(random);
        const Vector3 t = u.cross(test::RandomDirection(random)).normalized();
        const Vector3 x = model.PointWorld(std::cos(angle) * u + std::sin(angle) * t);
        const Vector3 offset = x - patch.Point;
        const double height = offset.dot(patch.Normal);
        constexpr double Slack = 1e-13; // rounding
        EXPECT_GE(height, patch.Low - Slack);
        EXPECT_LE(height, patch.High + Slack);
        EXPECT_LE((offset - height * patch.Normal).norm(), patch.Radius + Slack);
        const Vector3 query = RandomQuery(random);
        EXPECT_LE(patch.LowerDistance(query), (x - query).norm() + 1e-12);
      }
    }
  }
}

TEST(SurfacePatchTree, NoPartIsCloserThanItsBound)
{
  Random random(924);
  const RadialModel organ = test::RandomOrgan(random, 12);
  const RadialModel model(12, organ.Coefficients(), Vector3::Zero());
  const SurfacePatchTree tree(model, RadiusDerivativeBounds(model), 3);
  ASSERT_EQ(tree.InnerCount(), 20 + 80 + 320);
  ASSERT_EQ(tree.NodeCount(), 20 + 80 + 320 + 1280);
  for (int node = 0; node < tree.NodeCount(); ++node)
  {
    const SphericalTriangle triangle = tree.Triangle(node);
    for (int k = 0; k < 10; ++k)
    {
      const Vector3 x = model.PointWorld(RandomInside(random, triangle));
      const Vector3 query = RandomQuery(random);
      EXPECT_LE(tree.LowerDistance(node, query), (x - query).norm() + 1e-12) << node;
      EXPECT_LE(tree.LowerDistance(node, x), 1e-12) << node;
      EXPECT_GE(x.norm(), tree.LeastRadius() - 1e-12);
      EXPECT_LE(x.norm(), tree.LargestRadius() + 1e-12);
    }
  }
}

TEST(SurfacePatchTree, PartsOfNodeArePartsOfTriangle)
{
  const RadialModel model;
  const SurfacePatchTree tree(model, RadiusDerivativeBounds(model), 3);
  for (int node = 0; node < tree.InnerCount(); ++node)
  {
    const auto parts = tree.Triangle(node).Split();
    for (int part = 0; part < 4; ++part)
    {
      const SphericalTriangle found = tree.Triangle(SurfacePatchTree::FirstPart(node) + part);
      EXPECT_EQ(found.Corners, parts[static_cast<std::size_t>(part)].Corners);
    }
  }
}
} // namespace
} // namespace palpate::surface_patch_tree_test
