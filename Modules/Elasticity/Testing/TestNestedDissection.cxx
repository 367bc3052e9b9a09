#include "ElasticCases.h"
#include "NestedDissection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <set>
#include <vector>

namespace palpate::nested_dissection_test
{
namespace
{
StarMesh SphereMesh(int elementsAcross)
{
  StarMesh mesh;
  EXPECT_TRUE(StarMesh::Make(test::SphereModel(), elementsAcross, mesh).IsOk());
  return mesh;
}

// The part of each node, and the part that each part is before.
struct Tree
{
  explicit Tree(const NestedDissection& order)
      : PartOf(order.Order().size()), After(order.Parts().size(), NestedDissection::None)
  {
    for (std::size_t part = 0; part < order.Parts().size(); ++part)
    {
      const NestedDissection::Part& own = order.Parts()[part];
      for (int i = own.First; i < own.First + own.Count; ++i)
      {
        this->PartOf[static_cast<std::size_t>(order.Order()[static_cast<std::size_t>(i)])] =
            static_cast<int>(part);
      }
      for (const int before : own.Before)
      {
        if (before != NestedDissection::None)
        {
          this->After[static_cast<std::size_t>(before)] = static_cast<int>(part);
        }
      }
    }
  }

  bool IsWithin(int part, int later) const
  {
    while (part != NestedDissection::None && part != later)
    {
      part = this->After[static_cast<std::size_t>(part)];
    }
    return part == later;
  }

  std::vector<int> PartOf;
  std::vector<int> After;
};

// Entries of the Cholesky factor of a matrix with three unknowns at each node.
std::int64_t Fill(const StarMesh& mesh, const NestedDissection& order)
{
  const Tree tree(order);
  std::vector<std::set<int>> touched(order.Parts().size()); // nodes of later parts
  for (const StarMesh::Element& element : mesh.Elements())
  {
    for (const int node : element)
    {
      const int part = tree.PartOf[static_cast<std::size_t>(node)];
      std::copy_if(element.begin(), element.end(),
                   std::inserter(touched[static_cast<std::size_t>(part)],
                                 touched[static_cast<std::size_t>(part)].end()),
                   [&](int other) { return tree.PartOf[static_cast<std::size_t>(other)] > part; });
    }
  }
  std::int64_t entries = 0;
  for (std::size_t part = 0; part < touched.size(); ++part)
  {
    const std::int64_t own = 3 * order.Parts()[part].Count;
    entries += own * (own + 1) / 2 + own * 3 * static_cast<std::int64_t>(touched[part].size());
    if (const int after = tree.After[part]; after != NestedDissection::None)
    {
      std::copy_if(touched[part].begin(), touched[part].end(),
                   std::inserter(touched[static_cast<std::size_t>(after)],
                                 touched[static_cast<std::size_t>(after)].end()),
                   [&](int node) { return tree.PartOf[static_cast<std::size_t>(node)] > after; });
    }
  }
  return entries;
}

TEST(NestedDissection, OrdersEachNodeOnce)
{
  for (const int across : {2, 4, 10})
  {
    const StarMesh mesh = SphereMesh(across);
    const NestedDissection order(mesh.Places());
    std::vector<int> nodes = order.Order();
    std::sort(nodes.begin(), nodes.end());
    std::vector<int> all(mesh.Nodes().size());
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(nodes, all);
    int next = 0;
    for (const NestedDissection::Part& part : order.Parts())
    {
      EXPECT_EQ(part.First, next);
      EXPECT_GT(part.Count, 0);
      next += part.Count;
    }
    EXPECT_EQ(next, static_cast<int>(all.size()));
  }
}

TEST(NestedDissection, NoElementReachesAcrossASeparator)
{
  for (const int across : {2, 4, 10})
  {
    const StarMesh mesh = SphereMesh(across);
    const NestedDissection order(mesh.Places());
    const Tree tree(order);
    for (const StarMesh::Element& element : mesh.Elements())
    {
      for (const int one : element)
      {
        for (const int other : element)
        {
          const int first = tree.PartOf[static_cast<std::size_t>(one)];
          const int second = tree.PartOf[static_cast<std::size_t>(other)];
          ASSERT_TRUE(tree.IsWithin(std::min(first, second), std::max(first, second)));
        }
      }
    }
  }
}

// What MUMPS 5.5 counts with its own orderings: 60 million with PORD, 52 million with Scotch.
TEST(NestedDissection, FillsLessThanOrdersThatDoNotKnowTheMesh)
{
  const StarMesh mesh = SphereMesh(16);
  EXPECT_LT(Fill(mesh, NestedDissection(mesh.Places())), 50'000'000);
}

TEST(NestedDissection, HalvesAreOfSimilarSize)
{
  const StarMesh mesh = SphereMesh(16);
  const NestedDissection order(mesh.Places());
  const NestedDissection::Part& last = order.Parts().back();
  const int half = order.Parts()[static_cast<std::size_t>(last.Before[0])].First +
                   order.Parts()[static_cast<std::size_t>(last.Before[0])].Count;
  EXPECT_EQ(2 * half, last.First);
}
} // namespace
} // namespace palpate::nested_dissection_test
