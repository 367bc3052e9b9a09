// From a fault to 0 N on the wire, measured by the packets that the board received. The board holds
// the last torque for ever, since a real one might too.
#include "FalconRig.h"

#include <functional>
#include <string>
#include <utility>

namespace palpate::falcon_stop_test
{
namespace
{
using test::FalconRig;
using test::VirtualFalcon;
using test::VirtualFalconAnswer;

struct Rig : FalconRig
{
  Rig() { this->Press(this->Loop, 6.0, this->Wall); }

  void Mute()
  {
    this->Falcon.Faults.Spoil = [](VirtualFalconAnswer& answer) { answer.Bytes.clear(); };
  }
  void Delay(std::int64_t time)
  {
    this->Falcon.Faults.Spoil = [time](VirtualFalconAnswer& answer) { answer.Delay += time; };
  }

  std::shared_ptr<test::WallControl> Wall = std::make_shared<test::WallControl>();
  Servo Loop{this->Device, ServoSettings()};
};

struct StopCase
{
  std::string Name;
  std::function<void(Rig&)> Break;
};

void PrintTo(const StopCase& c, std::ostream* stream)
{
  *stream << c.Name;
}

const StopCase AllStops[] = {
    {"SwitchedOff", [](Rig& rig) { rig.Loop.SwitchOff(); }},
    {"SwitchedOffWhileRepliesAreOwed",
     [](Rig& rig)
     {
       rig.Mute();
       for (int n = 0; n < FalconExchange::MostOwed + 1; ++n)
       {
         rig.Tick(rig.Loop);
       }
       rig.Loop.SwitchOff();
     }},
    {"RepliesStop", [](Rig& rig) { rig.Mute(); }},
    {"RepliesStall", [](Rig& rig) { rig.Delay(1'000'000'000); }},
    {"RepliesComeLate", [](Rig& rig) { rig.Delay(15'000'000); }},
    {"InvalidContact", [](Rig& rig) { rig.Wall->Fault = test::WallFault::Invalid; }},
    {"ForceIsNaN", [](Rig& rig) { rig.Wall->Fault = test::WallFault::NaNNormal; }},
    {"ServoHeldUp", [](Rig& rig) { rig.Time.Advance(15 * FalconRig::Period); }},
    {"EncodersJump",
     [](Rig& rig)
     {
       rig.Falcon.Faults.Spoil = [](VirtualFalconAnswer& answer)
       { answer.Bytes[3] = answer.Bytes[3] == 'B' ? 'A' : 'B'; };
     }},
    {"HomeIsLost",
     [](Rig& rig)
     {
       rig.Falcon.Mechanism().Settings.CounterErrors = {};
       rig.Falcon.Mechanism().ForgetHome();
     }},
};

class FalconStop : public testing::TestWithParam<StopCase>
{
};

TEST_P(FalconStop, BoardHasZeroWithinTwoTicksOfFault)
{
  constexpr int Patience = 100; // ticks until the fault is noticed
  Rig rig;
  ASSERT_TRUE(rig.HasTorque());
  const std::int64_t broken = rig.Time.Now();
  GetParam().Break(rig);
  int n = 0;
  while (rig.Loop.Latest().Safety.Fault == SafetyFault::None && n++ < Patience)
  {
    rig.Tick(rig.Loop);
  }
  ASSERT_NE(rig.Loop.Latest().Safety.Fault, SafetyFault::None);
  const std::int64_t fault = rig.Time.Now();
  for (int more = 0; more < 300; ++more)
  {
    rig.Tick(rig.Loop);
  }
  const auto& received = rig.Received();
  const auto last = std::find_if(received.rbegin(), received.rend(),
                                 [](const auto& order) { return order.HasTorque(); });
  ASSERT_NE(last, received.rbegin());
  const std::int64_t stopped = std::prev(last)->Time;
  const auto ticksFrom = [stopped](std::int64_t start)
  { return static_cast<int>(std::ceil(static_cast<double>(stopped - start) / Rig::Period)); };
  EXPECT_LE(ticksFrom(fault), 2);
  EXPECT_EQ(rig.Falcon.Mechanism().MotorForce(), Vector3::Zero());
  this->RecordProperty("front", "virtual time");
  this->RecordProperty("fault", GetParam().Name);
  this->RecordProperty("ticks_from_cause", ticksFrom(broken));
  this->RecordProperty("ticks_from_fault", ticksFrom(fault));
}

INSTANTIATE_TEST_SUITE_P(All, FalconStop, testing::ValuesIn(AllStops),
                         [](const auto& chosen) { return chosen.param.Name; });

TEST(FalconStopAtALink, ZeroIsFirstAfterFullQueue)
{
  Rig rig;
  rig.Cable->HoldsWrites = true;
  rig.Time.Advance(FalconRig::Period / 2); // packets in flight arrive
  const std::size_t before = rig.Received().size();
  for (int n = 0; n < 100; ++n)
  {
    rig.Tick(rig.Loop);
  }
  EXPECT_NE(rig.Loop.Latest().Safety.Fault, SafetyFault::None);
  ASSERT_EQ(rig.Received().size(), before);
  rig.Cable->HoldsWrites = false;
  for (int n = 0; n < 20; ++n)
  {
    rig.Tick(rig.Loop);
  }
  ASSERT_GT(rig.Received().size(), before);
  for (std::size_t i = before; i < rig.Received().size(); ++i)
  {
    ASSERT_FALSE(rig.Received()[i].HasTorque()) << "packet " << i - before;
  }
}

TEST(FalconStopAtALink, ZeroIsFirstAfterReturnToBus)
{
  Rig rig;
  rig.Falcon.Unplug(rig.Time.Now(), VirtualFalcon::Supply::Kept);
  rig.Tick(rig.Loop);
  EXPECT_NE(rig.Tick(rig.Loop).Safety.Fault, SafetyFault::None);
  const std::size_t before = rig.Received().size();
  EXPECT_GT(rig.Falcon.Mechanism().MotorForce().norm(), 0.5)
      << "the torque persists without a cable";
  rig.Device.Close();
  rig.Falcon.Plug(rig.Time.Now());
  ASSERT_TRUE(rig.Device.Open().IsOk());
  ASSERT_GT(rig.Received().size(), before);
  EXPECT_FALSE(rig.Received()[before].HasTorque());
  EXPECT_EQ(rig.Falcon.Mechanism().MotorForce(), Vector3::Zero());
}

TEST(FalconStopAtALink, CloseWithFullQueueStopsMotors)
{
  Rig rig;
  rig.Cable->HoldsWrites = true;
  for (int n = 0; n < 4; ++n)
  {
    rig.Tick(rig.Loop);
  }
  rig.Time.Advance(FalconRig::Period / 2);
  const std::size_t before = rig.Received().size();
  rig.Cable->HoldsWrites = false;
  rig.Device.Close();
  rig.Time.Advance(FalconRig::Period);
  ASSERT_GT(rig.Received().size(), before);
  EXPECT_FALSE(rig.Received()[before].HasTorque());
}

TEST(FalconStopAtALink, OnlySentForcesAreAccepted)
{
  Rig rig;
  rig.Cable->HoldsWrites = true;
  for (int n = 0; n < 6; ++n)
  {
    const std::uint64_t requests = rig.Device.Statistics().Requests;
    const bool isTaken = rig.Tick(rig.Loop).WasTaken;
    EXPECT_EQ(isTaken, rig.Device.Statistics().Requests > requests) << n;
    EXPECT_EQ(isTaken, n < 4) << "the queue of an armed link holds four packets";
  }
}
} // namespace
} // namespace palpate::falcon_stop_test
