#include "Progress.h"

#include <gtest/gtest.h>

#include <vector>

namespace palpate::progress_test
{
namespace
{
TEST(Progress, CancelsByThrowing)
{
  const ProgressFunction stop = [](double, const std::string&) { return false; };
  EXPECT_THROW(ReportProgress(stop, 0.5, "stage"), Cancelled);
}

TEST(Progress, MayBeEmpty)
{
  EXPECT_NO_THROW(ReportProgress({}, 0.5, "stage"));
  EXPECT_FALSE(PartOf(ProgressFunction(), 0.25, 0.75));
}

TEST(Progress, OfAStepIsAPartOfTheTasks)
{
  std::vector<double> told;
  const ProgressFunction task = [&told](double fraction, const std::string&)
  {
    told.push_back(fraction);
    return fraction < 0.5;
  };
  const ProgressFunction step = PartOf(task, 0.25, 0.75);
  EXPECT_NO_THROW(ReportProgress(step, 0.0, "stage"));
  EXPECT_THROW(ReportProgress(step, 1.0, "stage"), Cancelled);
  EXPECT_EQ(told, (std::vector<double>{0.25, 0.75}));
}
} // namespace
} // namespace palpate::progress_test
