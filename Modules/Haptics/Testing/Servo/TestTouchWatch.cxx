#include "TouchWatch.h"

#include <gtest/gtest.h>

namespace palpate::touch_watch_test
{
namespace
{
using Kind = TouchChange::Kind;

class TouchWatchTest : public testing::Test
{
protected:
  // Changes of the next tick, now `Tick`.
  std::vector<TouchChange> Next()
  {
    ++this->Tick.Tick.Started;
    std::vector<TouchChange> changes;
    this->Watch.Take(this->Tick, changes);
    return changes;
  }

  TouchState Tick;
  TouchWatch Watch;
};

TEST_F(TouchWatchTest, EqualTicksGiveNoChange)
{
  this->Tick.HasSample = true;
  EXPECT_TRUE(this->Next().empty());
  this->Tick.Structure = 2;
  this->Tick.Sample.Buttons = 5;
  this->Tick.Safety.Fault = SafetyFault::StaleSample;
  EXPECT_FALSE(this->Next().empty());
  EXPECT_TRUE(this->Next().empty());
}

TEST_F(TouchWatchTest, ChangeOfStructureEndsAndStartsAContact)
{
  this->Tick.Structure = 1;
  auto changes = this->Next();
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].What, Kind::ContactBegins);
  EXPECT_EQ(changes[0].Structure, 1);
  this->Tick.Structure = 0;
  changes = this->Next();
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_EQ(changes[0].What, Kind::ContactEnds);
  EXPECT_EQ(changes[0].Structure, 1);
  EXPECT_EQ(changes[1].What, Kind::ContactBegins);
  EXPECT_EQ(changes[1].Structure, 0);
  EXPECT_EQ(changes[1].Time, this->Tick.Tick.Started);
  this->Tick.Structure = -1;
  changes = this->Next();
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].What, Kind::ContactEnds);
  EXPECT_EQ(changes[0].Structure, 0);
}

TEST_F(TouchWatchTest, ReportsEachButton)
{
  this->Tick.HasSample = true;
  this->Tick.Sample.Buttons = 0x80000002;
  auto changes = this->Next();
  ASSERT_EQ(changes.size(), 2u);
  EXPECT_EQ(changes[0].Button, 1);
  EXPECT_EQ(changes[1].Button, 31);
  EXPECT_EQ(changes[1].What, Kind::ButtonPressed);
  this->Tick.Sample.Buttons = 0x80000000;
  changes = this->Next();
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].What, Kind::ButtonReleased);
  EXPECT_EQ(changes[0].Button, 1);
}

TEST_F(TouchWatchTest, TickWithoutSampleReleasesNoButton)
{
  this->Tick.HasSample = true;
  this->Tick.Sample.Buttons = 1;
  ASSERT_EQ(this->Next().size(), 1u);
  this->Tick.HasSample = false;
  this->Tick.Sample.Buttons = 0;
  EXPECT_TRUE(this->Next().empty());
}

TEST_F(TouchWatchTest, ReportsAFaultAndItsEnd)
{
  this->Tick.Safety.Fault = SafetyFault::DeviceFailed;
  auto changes = this->Next();
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].What, Kind::Fault);
  EXPECT_EQ(changes[0].Why, SafetyFault::DeviceFailed);
  this->Tick.Safety.Fault = SafetyFault::None;
  changes = this->Next();
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].What, Kind::ForcesOn);
}

TEST_F(TouchWatchTest, TellsFaultsThatEndByThemselves)
{
  this->Tick.Safety.Fault = SafetyFault::StalledTick;
  this->Tick.Safety.WillResume = true;
  auto changes = this->Next();
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_TRUE(changes[0].WillResume);
  this->Tick.Safety.Fault = SafetyFault::SwitchedOff;
  this->Tick.Safety.WillResume = false;
  changes = this->Next();
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].What, Kind::Fault);
  EXPECT_FALSE(changes[0].WillResume);
}
} // namespace
} // namespace palpate::touch_watch_test
