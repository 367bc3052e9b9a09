#include "DistanceTransform.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace palpate::distance_transform_test
{
namespace
{

palpate::VoxelMask RandomMask(std::mt19937_64& random, const std::array<double, 3>& spacing)
{
  palpate::VoxelMask mask;
  mask.Spacing = spacing;
  for (int& size : mask.Size)
  {
    size = 2 + static_cast<int>(random() % 8);
  }
  mask.Inside.resize(mask.Offset(0, 0, mask.Size[2]));
  const auto filled = random() % 10;
  for (unsigned char& inside : mask.Inside)
  {
    inside = random() % 10 < filled ? 1 : 0;
  }
  return mask;
}

bool IsReached(std::array<int, 3> to, std::array<int, 3> from, DistanceDomain domain)
{
  const auto axis = static_cast<std::size_t>(domain);
  return domain == DistanceDomain::Space || to[axis] == from[axis];
}

// The nearest voxel of the other kind, by brute force.
double SlowDistance(const palpate::VoxelMask& mask, std::array<int, 3> from, unsigned char value,
                    DistanceDomain domain)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < mask.Size[2]; ++k)
  {
    for (int j = 0; j < mask.Size[1]; ++j)
    {
      for (int i = 0; i < mask.Size[0]; ++i)
      {
        if (mask.Inside[mask.Offset(i, j, k)] != value && IsReached({i, j, k}, from, domain))
        {
          nearest = std::min(nearest, std::hypot((i - from[0]) * mask.Spacing[0],
                                                 (j - from[1]) * mask.Spacing[1],
                                                 (k - from[2]) * mask.Spacing[2]));
        }
      }
    }
  }
  return nearest;
}

TEST(DistanceTransform, EqualsBruteForceAtEverySpacing)
{
  std::mt19937_64 random(8);
  const std::array<std::array<double, 3>, 5> spacings{
      {{1, 1, 1}, {4, 4, 2}, {0.3, 0.3, 3.6}, {10, 0.01, 7}, {2.5, 3.1, 250}}};
  for (int round = 0; round < 60; ++round)
  {
    const palpate::VoxelMask mask =
        RandomMask(random, spacings[static_cast<std::size_t>(round) % spacings.size()]);
    for (const auto domain : {DistanceDomain::AcrossI, DistanceDomain::AcrossJ,
                              DistanceDomain::AcrossK, DistanceDomain::Space})
    {
      for (const unsigned char value : {0, 1})
      {
        const std::vector<float> distances = palpate::DistanceToOthers(mask, value, domain);
        for (int k = 0; k < mask.Size[2]; ++k)
        {
          for (int j = 0; j < mask.Size[1]; ++j)
          {
            for (int i = 0; i < mask.Size[0]; ++i)
            {
              const std::size_t at = mask.Offset(i, j, k);
              const double expected =
                  mask.Inside[at] == value ? SlowDistance(mask, {i, j, k}, value, domain) : 0.0;
              // Squares are kept in float between axes.
              ASSERT_TRUE(distances[at] == expected ||
                          std::abs(distances[at] - expected) <= 1e-6 * expected)
                  << "round " << round << ": " << distances[at] << " for " << expected;
            }
          }
        }
      }
    }
  }
}

TEST(DistanceTransform, IsInfiniteWithoutOtherVoxels)
{
  palpate::VoxelMask mask;
  mask.Size = {2, 3, 2};
  mask.Spacing = {1, 1, 1};
  mask.Inside.assign(12, 1);
  for (const float distance : palpate::DistanceToOthers(mask, 1, DistanceDomain::Space))
  {
    EXPECT_EQ(distance, std::numeric_limits<float>::infinity());
  }
}
} // namespace
} // namespace palpate::distance_transform_test
