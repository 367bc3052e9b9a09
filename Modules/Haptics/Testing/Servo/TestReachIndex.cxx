#include "ReachIndex.h"

#include "RandomShapes.h"
#include "SafetyCases.h"

#include <gtest/gtest.h>

namespace palpate::reach_index_test
{
namespace
{
using Box = Eigen::AlignedBox3d;

Box RandomBox(test::Random& random, double spread, double size)
{
  std::uniform_real_distribution<double> place(-spread, spread);
  std::uniform_real_distribution<double> extent(0.0, size);
  const Vector3 low(place(random), place(random), place(random));
  return {low, low + Vector3(extent(random), extent(random), extent(random))};
}

// Brute force.
std::vector<std::uint32_t> FoundByTrial(const std::vector<Box>& boxes, const Box& asked)
{
  std::vector<std::uint32_t> found;
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    if (asked.intersects(boxes[i]))
    {
      found.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return found;
}

std::vector<std::uint32_t> FoundBy(const ReachIndex& index, std::size_t count, const Box& asked)
{
  std::vector<std::uint32_t> found(count);
  found.resize(index.Find(asked, found.data()));
  return found;
}

TEST(ReachIndex, EqualsBruteForce)
{
  test::Random random(8801);
  std::size_t found = 0;
  for (int sample = 0; sample < 300; ++sample)
  {
    std::vector<Box> boxes;
    const std::size_t count = random() % 200;
    for (std::size_t i = 0; i < count; ++i)
    {
      // Every fifth equals an earlier one, so that centres are shared.
      boxes.push_back(i % 5 == 4 ? boxes[i / 2] : RandomBox(random, 100.0, 30.0));
    }
    const ReachIndex index(boxes);
    for (int question = 0; question < 20; ++question)
    {
      const Box asked = RandomBox(random, 120.0, question % 2 == 0 ? 0.0 : 60.0);
      const auto expected = FoundByTrial(boxes, asked);
      ASSERT_EQ(FoundBy(index, boxes.size(), asked), expected);
      found += expected.size();
    }
  }
  EXPECT_GT(found, 1000u);
}

TEST(ReachIndex, BordersBelongToBoxes)
{
  const ReachIndex index({Box(Vector3::Zero(), Vector3::Ones())});
  const Vector3 beyond = Vector3::Constant(std::nextafter(1.0, 2.0));
  EXPECT_EQ(FoundBy(index, 1, Box(Vector3::Ones(), Vector3::Ones())).size(), 1u);
  EXPECT_EQ(FoundBy(index, 1, Box(beyond, beyond)).size(), 0u);
}

TEST(ReachIndex, HandlesEmptyInfiniteAndNaNBoxesAsBruteForce)
{
  const double infinite = test::Infinite;
  const double nan = test::NotANumber;
  const std::vector<Box> odd{
      Box(),
      Box(Vector3::Constant(-infinite), Vector3::Constant(infinite)),
      Box(Vector3::Constant(-1e308), Vector3::Constant(1e308)),
      Box(Vector3(0.0, nan, 0.0), Vector3::Ones()),
      Box(Vector3::Zero(), Vector3(1.0, 1.0, nan)),
      Box(Vector3::Constant(infinite), Vector3::Constant(infinite)),
      Box(Vector3::Ones(), Vector3::Zero()),
  };
  std::vector<Box> boxes;
  test::Random random(8802);
  for (int i = 0; i < 50; ++i)
  {
    boxes.push_back(RandomBox(random, 2.0, 1.0));
    boxes.push_back(odd[static_cast<std::size_t>(i) % odd.size()]);
  }
  const ReachIndex index(boxes);
  std::vector<Box> questions = odd;
  questions.push_back(RandomBox(random, 1.0, 1.0));
  questions.emplace_back(Vector3::Constant(-3.0), Vector3::Constant(3.0));
  for (const Box& asked : questions)
  {
    EXPECT_EQ(FoundBy(index, boxes.size(), asked), FoundByTrial(boxes, asked));
  }
}

TEST(ReachIndex, FindsNothingInAnEmptyIndex)
{
  EXPECT_EQ(ReachIndex(std::vector<Box>()).Find(Box(Vector3::Zero(), Vector3::Ones()), nullptr),
            0u);
  EXPECT_EQ(ReachIndex().Find(Box(Vector3::Zero(), Vector3::Ones()), nullptr), 0u);
}

TEST(ReachIndex, AMillionBoxesEqualBruteForce)
{
  test::Random random(8803);
  std::vector<Box> boxes(1000000);
  for (Box& box : boxes)
  {
    box = RandomBox(random, 1000.0, 20.0);
  }
  const ReachIndex index(boxes);
  std::size_t found = 0;
  for (int question = 0; question < 5; ++question)
  {
    const Box asked = RandomBox(random, 1000.0, 60.0);
    const auto expected = FoundByTrial(boxes, asked);
    ASSERT_EQ(FoundBy(index, boxes.size(), asked), expected);
    found += expected.size();
  }
  EXPECT_GT(found, 10u);
}
} // namespace
} // namespace palpate::reach_index_test
