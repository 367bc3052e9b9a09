#include "StageClock.h"

#include <gtest/gtest.h>

namespace palpate::stage_clock_test
{
namespace
{
TEST(StageClock, StageThatRunsAgainAddsToItsEntry)
{
  std::vector<std::pair<std::string, double>> stages{{"map", 100.0}, {"fit", 200.0}};
  palpate::StageClock clock(stages);
  clock.EndStage("map");
  clock.EndStage("quality");
  ASSERT_EQ(stages.size(), 3U);
  EXPECT_EQ(stages[2].first, "quality");
  EXPECT_GE(stages[0].second, 100.0);
  EXPECT_LT(stages[0].second, 200.0); // less than 100 s passed
  EXPECT_EQ(stages[1].second, 200.0);
}
} // namespace
} // namespace palpate::stage_clock_test
