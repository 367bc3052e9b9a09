#include "DrillFeed.h"

#include <gtest/gtest.h>

#include <random>

namespace palpate
{
namespace
{
const Vector3 Down(0.0, 0.0, 3.0); // from a probe 3 mm below its proxy

ToolPose At(const Vector3& place)
{
  return {place, Eigen::Quaterniond::Identity()};
}

// Feeds by `way` in so many ticks, each order numbered on from `number`.
int Feed(DrillFeed& feed, int ticks, double way, std::uint64_t& number)
{
  int orders = 0;
  for (int n = 0; n < ticks; ++n)
  {
    feed.Advance(At(Vector3::Zero()), feed.Remaining(Down), way);
    CutOrder order;
    if (feed.NextCut(2.0, order))
    {
      order.Number = number++;
      feed.Ordered(order);
      ++orders;
    }
  }
  return orders;
}

TEST(DrillFeed, IsAheadByWhatWasFedUntilAVersionShowsIt)
{
  DrillFeed feed;
  std::uint64_t number = 5;
  EXPECT_EQ(Feed(feed, 8, 0.01, number), 2);
  EXPECT_NEAR(feed.Ahead(), 0.08, 1e-15);
  EXPECT_NEAR((feed.Remaining(Down) - Vector3(0.0, 0.0, 2.92)).norm(), 0.0, 1e-14);
  feed.Arrive(5);
  EXPECT_NEAR(feed.Ahead(), 0.08, 1e-15);
  feed.Arrive(6);
  EXPECT_NEAR(feed.Ahead(), 0.04, 1e-15);
  feed.Arrive(7);
  EXPECT_EQ(feed.Ahead(), 0.0);
}

TEST(DrillFeed, GoesNoFartherThanTheProbe)
{
  DrillFeed feed;
  std::uint64_t number = 0;
  Feed(feed, 40, 0.5, number);
  EXPECT_NEAR(feed.Ahead(), 3.0, 1e-12);
  EXPECT_NEAR(feed.Remaining(Down).norm(), 0.0, 1e-12);
  EXPECT_NEAR(feed.Advance(At(Vector3::Zero()), feed.Remaining(Down), 0.5), 0.0, 1e-12);
}

TEST(DrillFeed, ACutBeginsWhereTheLastOneEnded)
{
  DrillFeed feed;
  Vector3 last(0.0, 0.0, 3.0); // the proxy, where it begins
  for (std::uint64_t n = 0; n < 100; ++n)
  {
    feed.Advance(At({0.01 * static_cast<double>(n), 0.0, 0.0}), feed.Remaining(Down), 0.02);
    CutOrder order;
    ASSERT_EQ(feed.NextCut(2.0, order), n % DrillFeed::TicksOfCut == 3);
    if (n % DrillFeed::TicksOfCut == 3)
    {
      EXPECT_EQ(Vector3(order.From.PositionWorld), last);
      last = order.To.PositionWorld;
      EXPECT_NEAR(last[2], 3.0 - 0.02 * static_cast<double>(n + 1), 1e-12);
      order.Number = n;
      feed.Ordered(order);
    }
  }
}

TEST(DrillFeed, AToolThatCameFromFarCutsOnlyWhereItIs)
{
  DrillFeed feed;
  CutOrder order;
  for (int n = 0; n < DrillFeed::TicksOfCut; ++n)
  {
    feed.Advance(At({1.0 * n, 0.0, 0.0}), feed.Remaining(Down), 0.02);
    feed.NextCut(2.0, order);
  }
  EXPECT_EQ(Vector3(order.From.PositionWorld), Vector3(order.To.PositionWorld));
  EXPECT_EQ(order.To.PositionWorld.X, 3.0);
}

TEST(DrillFeed, WaitsWhereTooManyCutsAreNotInAVersion)
{
  DrillFeed feed;
  std::uint64_t number = 0;
  EXPECT_EQ(Feed(feed, 2000, 0.001, number), static_cast<int>(DrillFeed::MostWaiting));
  const double ahead = feed.Ahead();
  EXPECT_EQ(Feed(feed, 2000, 0.001, number), 0);
  EXPECT_EQ(feed.Ahead(), ahead);
  feed.Arrive(10);
  EXPECT_EQ(Feed(feed, 2000, 0.001, number), 10);
}

TEST(DrillFeed, WhatIsNotOrderedIsForgottenWhereTheToolIsLifted)
{
  DrillFeed feed;
  std::uint64_t number = 0;
  Feed(feed, 6, 0.01, number);
  feed.Lift();
  EXPECT_NEAR(feed.Ahead(), 0.04, 1e-15);
  CutOrder order;
  EXPECT_FALSE(feed.NextCut(2.0, order));
}
} // namespace
} // namespace palpate
