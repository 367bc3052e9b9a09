#include "DegreePlan.h"

#include <gtest/gtest.h>
#include <random>

namespace palpate
{
namespace
{
using Indices = std::vector<std::size_t>;
constexpr double Way = 4.0; // mm

DegreeChoice Choose(const std::vector<DegreeCandidate>& candidates, std::size_t room,
                    const std::vector<double>& heights = {})
{
  return ChooseDegrees(candidates, {Way, 2.0, room},
                       [&heights](std::size_t one)
                       {
                         EXPECT_LT(one, heights.size()) << "not asked where all fit";
                         return one < heights.size() ? heights[one] : 0.0;
                       });
}

TEST(DegreePlan, WhatIsWithinTheWayIsBroughtNearestFirst)
{
  const DegreeChoice choice =
      Choose({{3.0, 10, false}, {0.0, 10, false}, {4.1, 10, false}, {4.0, 10, true}}, 100);
  EXPECT_EQ(choice.Bring, (Indices{1, 0}));
  EXPECT_TRUE(choice.Drop.empty());
}

TEST(DegreePlan, WhatIsFartherStaysWhileThereIsRoomAndTheFarthestGoesFirst)
{
  const std::vector<DegreeCandidate> candidates{
      {0.0, 10, false}, {20.0, 10, true}, {60.0, 10, true}, {40.0, 10, true}};
  EXPECT_TRUE(Choose(candidates, 40).Drop.empty());
  EXPECT_EQ(Choose(candidates, 39).Drop, (Indices{2}));
  EXPECT_EQ(Choose(candidates, 20).Drop, (Indices{2, 3}));
  EXPECT_EQ(Choose(candidates, 10).Drop, (Indices{2, 3, 1}));
}

TEST(DegreePlan, WhereNotAllFitTheNearestSurfacesAreTaken)
{
  const std::vector<DegreeCandidate> candidates{
      {0.0, 10, false}, {0.0, 10, false}, {2.0, 10, false}};
  const DegreeChoice choice = Choose(candidates, 20, {9.0, -1.0, 3.0});
  EXPECT_EQ(choice.Bring, (Indices{1, 2}));
}

TEST(DegreePlan, WhatIsAtHandGivesWayOnlyToWhatIsClearlyNearer)
{
  const std::vector<DegreeCandidate> candidates{{0.0, 10, true}, {0.0, 10, false}};
  const DegreeChoice same = Choose(candidates, 10, {5.0, 3.5});
  EXPECT_TRUE(same.Bring.empty());
  EXPECT_TRUE(same.Drop.empty());
  const DegreeChoice other = Choose(candidates, 10, {5.0, 2.5});
  EXPECT_EQ(other.Bring, (Indices{1}));
  EXPECT_EQ(other.Drop, (Indices{0}));
}

TEST(DegreePlan, WhatItChoosesFits)
{
  std::mt19937_64 random(63);
  for (int trial = 0; trial < 2000; ++trial)
  {
    std::vector<DegreeCandidate> candidates;
    std::vector<double> heights;
    for (int n = 0; n < 12; ++n)
    {
      candidates.push_back(
          {static_cast<double>(random() % 12), 1 + random() % 30, random() % 2 == 0});
      heights.push_back(static_cast<double>(random() % 20));
    }
    const std::size_t room = random() % 150;
    const DegreeChoice choice = Choose(candidates, room, heights);
    std::size_t bytes = 0;
    std::size_t wanted = 0;
    for (const DegreeCandidate& one : candidates)
    {
      wanted += one.Away <= Way ? one.Bytes : 0;
    }
    for (std::size_t one = 0; one < candidates.size(); ++one)
    {
      const auto holds = [one](const Indices& list)
      { return std::find(list.begin(), list.end(), one) != list.end(); };
      ASSERT_FALSE(holds(choice.Bring) && (candidates[one].IsAtHand || candidates[one].Away > Way));
      ASSERT_FALSE(holds(choice.Drop) && !candidates[one].IsAtHand);
      const bool isThere = candidates[one].IsAtHand ? !holds(choice.Drop) : holds(choice.Bring);
      bytes += isThere ? candidates[one].Bytes : 0;
      ASSERT_TRUE(wanted > room || candidates[one].Away > Way || isThere);
    }
    ASSERT_LE(bytes, room);
  }
}
} // namespace
} // namespace palpate
