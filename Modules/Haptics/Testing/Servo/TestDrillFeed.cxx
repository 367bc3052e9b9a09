#include "DrillFeed.h"

#include <gtest/gtest.h>

#include <random>

namespace palpate::drill_feed_test
{
namespace
{
constexpr double Radius = 2.0;
const Vector3 Up(0.0, 0.0, 3.0); // from a probe 3 mm below its proxy

ToolPose At(const Vector3& place)
{
  return {place, Eigen::Quaterniond::Identity()};
}

// The remaining distance to the probe.
double Left(DrillFeed& feed, bool cuts = true)
{
  return feed.Meet(At(Vector3::Zero()), Up, cuts).norm();
}

// Feeds by `path` in a number of ticks; orders are numbered from `number`.
int Feed(DrillFeed& feed, int ticks, double path, std::uint64_t& number)
{
  int orders = 0;
  for (int n = 0; n < ticks; ++n)
  {
    Left(feed);
    feed.Advance(path);
    CutOrder order;
    if (feed.NextCut(order))
    {
      order.Number = number++;
      feed.Ordered(order);
      ++orders;
    }
  }
  return orders;
}

TEST(DrillFeed, IsAheadByTheFeedMissingInTheVersion)
{
  DrillFeed feed(Radius, 0.0);
  std::uint64_t number = 5;
  EXPECT_EQ(Feed(feed, 8, 0.01, number), 2);
  EXPECT_NEAR(Left(feed), 2.92, 1e-14);
  feed.Arrive(5);
  EXPECT_NEAR(Left(feed), 2.92, 1e-14);
  feed.Arrive(6); // not visible in its proxy
  EXPECT_NEAR(Left(feed), 2.96, 1e-14);
  feed.Arrive(7);
  EXPECT_NEAR(Left(feed), 3.0, 1e-14);
}

TEST(DrillFeed, StaysInPlaceWhenAVersionArrives)
{
  DrillFeed feed(Radius, 0.0);
  std::uint64_t number = 0;
  Feed(feed, 8, 0.01, number);
  feed.Arrive(2);
  const Vector3 lower(0.0, 0.0, 2.92);
  EXPECT_NEAR((feed.Meet(At(Vector3::Zero()), lower, true) - lower).norm(), 0.0, 1e-14);
}

TEST(DrillFeed, StaysWithinTheClearanceOfTheProxy)
{
  constexpr double Clearance = 0.05;
  DrillFeed feed(Radius, Clearance);
  EXPECT_NEAR(Left(feed), 3.0 + Clearance, 1e-14);
  std::uint64_t number = 0;
  Feed(feed, 400, 0.01, number);
  feed.Arrive(number);
  feed.Rest();
  EXPECT_NEAR(Left(feed), 3.0 - Clearance, 1e-14);
  // Its offset from the proxy decays while nothing is cut.
  double last = Left(feed, false);
  for (int n = 0; n < 400; ++n)
  {
    const double left = Left(feed, false);
    ASSERT_GE(left, last);
    ASSERT_LE(left - last, 0.06 * Clearance);
    last = left;
  }
  EXPECT_NEAR(last, 3.0, 1e-9);
}

TEST(DrillFeed, StopsAtTheProbe)
{
  DrillFeed feed(Radius, 0.0);
  std::uint64_t number = 0;
  Feed(feed, 40, 0.5, number);
  EXPECT_NEAR(Left(feed), 0.0, 1e-12);
  EXPECT_NEAR(feed.Advance(0.5), 0.0, 1e-12);
}

// The differential equation of the class's comment: the depth at which the rise over the rim
// balances the feed is R / 2 (feed / speed)^2.
TEST(DrillFeed, DepthOfAMovingToolFollowsFeedAndSpeed)
{
  for (const double feedOfPath : {0.05, 0.1, 0.2})
  {
    DrillFeed feed(Radius, 0.0);
    constexpr double Path = 0.001; // mm per tick
    for (int n = 0; n < 20000; ++n)
    {
      feed.Meet(At({Path * n, 0.0, 0.0}), Up, true);
      feed.Advance(feedOfPath * Path);
    }
    const double depth = 3.0 - feed.Meet(At({Path * 20000, 0.0, 0.0}), Up, true).norm();
    const double wanted = 0.5 * Radius * feedOfPath * feedOfPath;
    EXPECT_NEAR(depth, wanted, 0.1 * wanted); // steps of 0.001 mm
  }
}

TEST(DrillFeed, CutsAreContiguous)
{
  DrillFeed feed(Radius, 0.0);
  Vector3 last(0.0, 0.0, 3.0); // the proxy, where it starts
  for (std::uint64_t n = 0; n < 100; ++n)
  {
    feed.Meet(At({0.001 * static_cast<double>(n), 0.0, 0.0}), Up, true);
    feed.Advance(0.02);
    CutOrder order;
    ASSERT_EQ(feed.NextCut(order), n % DrillFeed::TicksOfCut == 3);
    if (n % DrillFeed::TicksOfCut == 3)
    {
      EXPECT_EQ(Vector3(order.From.PositionWorld), last);
      EXPECT_LT(order.To.PositionWorld.Z, last[2]);
      last = order.To.PositionWorld;
      order.Number = n;
      feed.Ordered(order);
    }
  }
}

TEST(DrillFeed, CutsOnlyInPlaceAfterALongMove)
{
  DrillFeed feed(Radius, 0.0);
  CutOrder order;
  for (int n = 0; n < DrillFeed::TicksOfCut; ++n)
  {
    feed.Meet(At({1.0 * n, 0.0, 0.0}), Up, true);
    feed.Advance(0.02);
    feed.NextCut(order);
  }
  EXPECT_EQ(Vector3(order.From.PositionWorld), Vector3(order.To.PositionWorld));
  EXPECT_EQ(order.To.PositionWorld.X, 3.0);
}

TEST(DrillFeed, StopsAtTooManyPendingCuts)
{
  DrillFeed feed(Radius, 0.0);
  std::uint64_t number = 0;
  EXPECT_EQ(Feed(feed, 2000, 0.001, number), static_cast<int>(DrillFeed::MostWaiting));
  const double left = Left(feed);
  EXPECT_EQ(Feed(feed, 2000, 0.001, number), 0);
  EXPECT_NEAR(Left(feed), left, 1e-12);
  feed.Arrive(10);
  EXPECT_EQ(Feed(feed, 2000, 0.001, number), 10);
}

TEST(DrillFeed, DiscardsUnorderedFeedAtRest)
{
  DrillFeed feed(Radius, 0.0);
  std::uint64_t number = 0;
  Feed(feed, 6, 0.01, number);
  feed.Rest();
  EXPECT_NEAR(Left(feed), 2.96, 1e-14);
  CutOrder order;
  EXPECT_FALSE(feed.NextCut(order));
}
} // namespace
} // namespace palpate::drill_feed_test
