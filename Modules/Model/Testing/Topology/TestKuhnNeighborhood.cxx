#include "KuhnNeighborhood.h"
#include "TopologyPhantoms.h"

#include <gtest/gtest.h>
#include <random>

namespace palpate::kuhn_neighborhood_test
{
namespace
{
using namespace palpate::phantoms;

constexpr unsigned AllNeighbors = (1u << palpate::KuhnNeighbors) - 1;

palpate::ShapeField RandomField(std::mt19937_64& random, double filled)
{
  std::uniform_real_distribution<double> part(0.0, 1.0);
  std::uniform_real_distribution<double> depth(0.1, 1.0);
  return Sampled(3.0, 1.0,
                 [&](const Vector3& point)
                 { return (part(random) < filled ? 1.0 : -1.0) * depth(random); });
}

TEST(KuhnNeighborhood, SimpleNodesChangeNoTopology)
{
  std::mt19937_64 random(1);
  int simple = 0;
  for (int round = 0; round < 40; ++round)
  {
    palpate::ShapeField field = RandomField(random, 0.1 + 0.02 * round);
    const palpate::KuhnOffsets steps = palpate::OffsetsOf(field.Grid);
    const std::size_t node = field.Grid.Offset(4, 4, 4);
    field.Values[node] = -1.0f;
    unsigned neighbors = 0;
    for (std::size_t n = 0; n < steps.size(); ++n)
    {
      neighbors |= (field.Values[node + static_cast<std::size_t>(steps[n])] > 0.0f ? 1u : 0u) << n;
    }
    const Topology before = TopologyOf(field);
    field.Values[node] = 1.0f;
    const bool isSimple = palpate::SimpleNodes::Get().Contains(neighbors);
    simple += isSimple ? 1 : 0;
    EXPECT_TRUE(!isSimple || TopologyOf(field) == before) << round;
  }
  EXPECT_GT(simple, 5);
}

// Among sets that are not simple, those with one part and no cavity in the link do not exist.
TEST(KuhnNeighborhood, NodesThatAreNotSimpleChangeLocalTopology)
{
  for (unsigned neighbors = 0; neighbors <= AllNeighbors; neighbors += 7)
  {
    palpate::ShapeField field = Sampled(2.0, 1.0, [](const Vector3& point) { return -1.0; });
    const std::size_t node = field.Grid.Offset(3, 3, 3);
    const palpate::KuhnOffsets steps = palpate::OffsetsOf(field.Grid);
    for (std::size_t n = 0; n < steps.size(); ++n)
    {
      field.Values[node + static_cast<std::size_t>(steps[n])] =
          (neighbors >> n & 1) != 0 ? 1.0f : -1.0f;
    }
    const Topology before = TopologyOf(field);
    field.Values[node] = 1.0f;
    const Topology after = TopologyOf(field);
    // Around an isolated link every change of topology shows.
    ASSERT_EQ(palpate::SimpleNodes::Get().Contains(neighbors), before == after) << neighbors;
  }
}

TEST(KuhnNeighborhood, TreatsInsideAndOutsideAlike)
{
  const palpate::SimpleNodes& simple = palpate::SimpleNodes::Get();
  for (unsigned neighbors = 0; neighbors <= AllNeighbors; ++neighbors)
  {
    const unsigned opposite = neighbors >> 7 | (neighbors & 127u) << 7;
    ASSERT_EQ(simple.Contains(neighbors), simple.Contains(AllNeighbors & ~neighbors));
    ASSERT_EQ(simple.Contains(neighbors), simple.Contains(opposite));
  }
  EXPECT_FALSE(simple.Contains(0));
  EXPECT_FALSE(simple.Contains(AllNeighbors));
  EXPECT_TRUE(simple.Contains(1));
}

TEST(KuhnNeighborhood, CountsPartsHandlesAndCavitiesOfPhantoms)
{
  const Vector3 beside(7.0, 0.0, 0.0);
  const auto topology = [](const auto& value) { return TopologyOf(Sampled(15.0, 0.7, value)); };
  EXPECT_TRUE(topology([](const Vector3& p) { return Sphere(p, 6.0); }) == (Topology{1, 0, 0}));
  EXPECT_TRUE(topology([](const Vector3& p) { return Ring(p, 7.0, 2.0); }) == (Topology{1, 0, 1}));
  EXPECT_TRUE(topology(
                  [&](const Vector3& p) {
                    return std::max(Ring(p - beside, 6.0, 2.0), Ring(p + beside, 6.0, 2.0));
                  }) == (Topology{1, 0, 2}));
  EXPECT_TRUE(
      topology([](const Vector3& p) { return std::min(Sphere(p, 9.0), -Sphere(p, 4.0)); }) ==
      (Topology{1, 1, 0}));
  EXPECT_TRUE(topology([&](const Vector3& p)
                       { return std::max(Sphere(p - beside, 4.0), Sphere(p + beside, 4.0)); }) ==
              (Topology{2, 0, 0}));
}
} // namespace
} // namespace palpate::kuhn_neighborhood_test
