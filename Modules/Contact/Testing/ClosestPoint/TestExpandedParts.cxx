#include "ExpandedParts.h"

#include "CenteredSurfaceSample.h"
#include "SphericalTriangle.h"
#include "SurfacePhantoms.h"

#include <array>
#include <gtest/gtest.h>
#include <vector>

namespace palpate::expanded_parts_test
{
namespace
{
using test::Random;
using Descent = ClosestPointDescentOf<CenteredSurface>;

struct Part
{
  SphericalCap Cap;
  CenteredSurface::SecondOrderSample Sample;
  Descent::CapBounds Bounds;
};

// Over the cap of a random triangle, quartered up to seven times.
Part RandomPart(const CenteredSurface& shape, const Descent& descent, Random& random)
{
  SphericalTriangle triangle = SphericalTriangle::Icosahedron()[random() % 20];
  for (std::size_t split = random() % 8; split > 0; --split)
  {
    triangle = triangle.Split()[random() % 4];
  }
  const SphericalCap cap = triangle.Cap();
  const auto sample = shape.EvaluateSecondOrder(cap.Center);
  return {cap, sample, descent.BoundsWithin(cap.Center, sample, cap.Radius)};
}

std::vector<InstructionSet> SupportedSets()
{
  std::vector<InstructionSet> sets{InstructionSet::Portable};
  if (FastestInstructionSet() != InstructionSet::Portable)
  {
    sets.push_back(FastestInstructionSet());
  }
  return sets;
}

TEST(ExpandedParts, FourBoundsAreThoseOfEachPart)
{
  Random random(9411);
  const CenteredSurface shape(test::BumpyTube(random));
  const Descent descent(shape);
  std::uniform_real_distribution<double> height(-8.0, 8.0); // mm
  for (int trial = 0; trial < 2000; ++trial)
  {
    ExpandedParts parts;
    std::array<Part, ExpandedParts::Count> each;
    for (std::size_t i = 0; i < each.size(); ++i)
    {
      each[i] = RandomPart(shape, descent, random);
      parts.Set(i, each[i].Sample, each[i].Cap.Radius, each[i].Bounds);
    }
    // Of the first one the place is on the normal, so that its expansion ends within the cap.
    const Vector3 place = each[0].Sample.Point + height(random) * NormalOf(each[0].Sample);
    for (const InstructionSet set : SupportedSets())
    {
      alignas(sizeof(FourLanes)) FourLanes lower;
      parts.LowerDistance(place, set, lower);
      for (std::size_t i = 0; i < each.size(); ++i)
      {
        const Part& part = each[i];
        const double alone = descent.LowerDistance(place, part.Cap.Center, part.Sample,
                                                   part.Cap.Radius, part.Bounds);
        // Squares of up to 100 mm are rounded, and a root near 0 makes more of it.
        ASSERT_NEAR(lower[i], alone, 1e-6) << trial << " " << i;
        if (alone > 0.1)
        {
          ASSERT_NEAR(lower[i], alone, 1e-10) << trial << " " << i;
        }
      }
    }
  }
}

TEST(ExpandedParts, MissingPartsDoNotDisturbTheOthers)
{
  Random random(9412);
  const CenteredSurface shape(test::Bowl());
  const Descent descent(shape);
  const Part part = RandomPart(shape, descent, random);
  const Vector3 place = part.Sample.Point + 3.0 * NormalOf(part.Sample);
  for (std::size_t lane = 0; lane < ExpandedParts::Count; ++lane)
  {
    ExpandedParts parts;
    parts.Set(lane, part.Sample, part.Cap.Radius, part.Bounds);
    alignas(sizeof(FourLanes)) FourLanes lower;
    parts.LowerDistance(place, FastestInstructionSet(), lower);
    const double alone =
        descent.LowerDistance(place, part.Cap.Center, part.Sample, part.Cap.Radius, part.Bounds);
    EXPECT_GT(alone, 0.1);
    EXPECT_NEAR(lower[lane], alone, 1e-10);
    for (std::size_t other = 0; other < ExpandedParts::Count; ++other)
    {
      EXPECT_TRUE(other == lane || lower[other] == 0.0) << lane << " " << other;
    }
  }
}

TEST(ExpandedParts, ForgottenPartsHaveNoBound)
{
  Random random(9413);
  const CenteredSurface shape(test::Bowl());
  const Descent descent(shape);
  ExpandedParts parts;
  Part part{};
  for (std::size_t lane = 0; lane < ExpandedParts::Count; ++lane)
  {
    part = RandomPart(shape, descent, random);
    parts.Set(lane, part.Sample, part.Cap.Radius, part.Bounds);
  }
  parts.Forget();
  for (const double height : {0.0, 3.0, 300.0})
  {
    for (const InstructionSet set : SupportedSets())
    {
      alignas(sizeof(FourLanes)) FourLanes lower;
      parts.LowerDistance(part.Sample.Point + height * NormalOf(part.Sample), set, lower);
      for (std::size_t lane = 0; lane < ExpandedParts::Count; ++lane)
      {
        EXPECT_EQ(lower[lane], 0.0) << lane;
      }
    }
  }
}

TEST(ExpandedParts, PointAndExtentEncloseThePart)
{
  Random random(9414);
  const CenteredSurface shape(test::BumpyTube(random));
  const Descent descent(shape);
  ExpandedParts parts;
  for (int trial = 0; trial < 200; ++trial)
  {
    const Part part = RandomPart(shape, descent, random);
    const std::size_t lane = random() % ExpandedParts::Count;
    parts.Set(lane, part.Sample, part.Cap.Radius, part.Bounds);
    for (int k = 0; k < 20; ++k)
    {
      const Vector3 across = part.Cap.Center.cross(test::RandomDirection(random)).normalized();
      const double angle =
          part.Cap.Radius * std::uniform_real_distribution<double>(0.0, 1.0)(random);
      const Vector3 u = std::cos(angle) * part.Cap.Center + std::sin(angle) * across;
      const double away = (shape.EvaluateSecondOrder(u).Point - parts.PointOf(lane)).norm();
      EXPECT_LE(away, parts.ExtentOf(lane) + 1e-9); // rounding
    }
  }
}
} // namespace
} // namespace palpate::expanded_parts_test
