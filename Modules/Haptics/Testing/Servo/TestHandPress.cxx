#include "HandPress.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace palpate::hand_press_test
{
namespace
{
constexpr int Never = -1;
const Vector3 Rest(1.0, -2.0, 11.6);

TouchState TickAt(std::uint64_t number, double height)
{
  TouchState tick;
  tick.Tick.Number = number;
  tick.HasSample = true;
  tick.Sample.Position = PlainVector3(Rest + Vector3(0.0, 0.0, height));
  return tick;
}

// Ticks until it may press, of a hand so high above the rest (mm) by tick.
int TicksUntilPress(HandPress& press, const std::function<double(int)>& height,
                    std::uint64_t first = 1000)
{
  for (int n = 0; n < 1000; ++n)
  {
    if (press.Take(TickAt(first + static_cast<std::uint64_t>(n), height(n))))
    {
      return n;
    }
  }
  return Never;
}

TEST(HandPress, HandThatRestsThereIsReadyOnceTheLiftIsTaken)
{
  HandPress press;
  EXPECT_EQ(TicksUntilPress(
                press, [](int) { return 0.1; }, 0),
            Never)
      << "not awaited";
  press.Await(Rest, 1000);
  EXPECT_EQ(TicksUntilPress(press, [](int) { return 0.1; }), 5);
  EXPECT_FALSE(press.IsWaiting());
}

// Wherever it swings through, it waits.
TEST(HandPress, HandThatSwingsThroughItsGoalWaitsUntilItIsStill)
{
  for (double speed = 0.02; speed < 1.0; speed *= 1.5) // mm a tick
  {
    HandPress press;
    press.Await(Rest, 1000);
    const auto height = [&](int n)
    { return 28.0 * std::exp(-0.01 * n) * std::cos(speed / 3.0 * n); };
    const int ticks = TicksUntilPress(press, height);
    ASSERT_NE(ticks, Never);
    EXPECT_LT(std::abs(height(ticks)), HandPress::Hover);
    const double later = std::max(std::abs(height(ticks + 1)), std::abs(height(ticks + 2)));
    EXPECT_LT(later, HandPress::Hover) << "at the tick that takes the press";
  }
}

TEST(HandPress, HandThatFrictionHoldsPressesFromWhereItStopped)
{
  HandPress press;
  press.Await(Rest, 1000);
  EXPECT_EQ(TicksUntilPress(press, [](int n) { return std::max(0.9, 20.9 - n); }), 120);
}

// It has not moved yet.
TEST(HandPress, HandThatHasJustBeenLedAwayIsNotStopped)
{
  HandPress press;
  TicksUntilPress(
      press, [](int) { return 20.0; }, 0);
  press.Await(Rest, 1000);
  EXPECT_GE(TicksUntilPress(press, [](int n) { return std::max(0.0, 20.0 - 0.5 * n); }), 40);
}

// They may still be read after it.
TEST(HandPress, TicksBeforeThePressDoNotCount)
{
  HandPress press;
  press.Await(Rest, 1050);
  EXPECT_EQ(TicksUntilPress(press, [](int) { return 0.0; }), 55);
}

TEST(HandPress, ServoThatStartsAnewIsFollowed)
{
  HandPress press;
  TicksUntilPress(
      press, [](int) { return 0.0; }, 500000);
  press.Await(Rest, 0);
  EXPECT_EQ(TicksUntilPress(
                press, [](int) { return 0.0; }, 0),
            10);
}

TEST(HandPress, WithoutASampleItWaits)
{
  HandPress press;
  press.Await(Rest, 0);
  for (std::uint64_t n = 0; n < 300; ++n)
  {
    TouchState tick = TickAt(n, 0.0);
    tick.HasSample = false;
    EXPECT_FALSE(press.Take(tick));
  }
  press.GiveUp();
  EXPECT_EQ(TicksUntilPress(press, [](int) { return 0.0; }), Never);
}
} // namespace
} // namespace palpate::hand_press_test
