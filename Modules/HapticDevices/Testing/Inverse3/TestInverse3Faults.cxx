#include "Inverse3Device.h"
#include "Servo.h"
#include "SteadyClock.h"
#include "TouchDoubles.h"
#include "VirtualInverse3.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <random>
#include <string>
#include <thread>

namespace palpate::inverse3_faults_test
{
namespace
{
using test::Inverse3Fault;
using test::VirtualInverse3;

struct FaultCase
{
  const char* Name;
  Inverse3Fault Fault;
  int MostTicks; ///< from the fault's cause to 0 N, beyond those that the machine is late
};

/// A hand of 4 mm in a wall of 0.5 N/mm, in real time, until a fault comes; then the servo goes on
/// ticking. The order of forces on the wire is what counts: none may follow the first 0 N.
class Inverse3Faults : public testing::TestWithParam<FaultCase>
{
protected:
  void Touch()
  {
    DeviceRegistry registry;
    ASSERT_TRUE(RegisterInverse3Devices(registry).IsOk());
    ASSERT_TRUE(
        registry.Make("inverse3:" + this->Service.Argument(), this->Time, this->Device).IsOk());
    ASSERT_TRUE(this->Device->Open().IsOk());
    ServoSettings settings;
    settings.RampDuration = 0.02;
    this->Loop = std::make_unique<Servo>(*this->Device, settings);
    ContactLaw law;
    law.Stiffness = 0.5;
    ASSERT_TRUE(
        this->Loop->Publish(std::make_shared<TouchScene>(test::WallScene(4.0, law))).IsOk());
    for (int n = 0; n < 5000 && !(this->Force() > 1.0); ++n)
    {
      this->Tick();
      if (this->Loop->Latest().Safety.Fault != SafetyFault::None)
      {
        this->Loop->Rearm(); // the machine was late
      }
    }
    ASSERT_GT(this->Force(), 1.0);
  }
  double Force() { return Vector3(this->Loop->Latest().ForceDevice).norm(); }
  void Tick()
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    TickInfo tick;
    tick.Number = ++this->Ticks;
    tick.Started = tick.Scheduled = this->Time.Now();
    tick.BootTime = this->Time.BootTime();
    this->Loop->Tick(tick);
  }

  SteadyClock Time;
  VirtualInverse3 Service;
  std::unique_ptr<HapticDevice> Device;
  std::unique_ptr<Servo> Loop;
  std::uint64_t Ticks = 0;
};

TEST_P(Inverse3Faults, EndInZeroForceOnTheWire)
{
  // With --gtest_repeat each repetition is another case (Utilities/safety.sh).
  static unsigned seed = 0;
  std::mt19937 random(++seed);
  this->Touch();
  for (unsigned wait = random() % 7; wait > 0; --wait)
  {
    this->Tick();
  }
  const std::size_t before = this->Service.Forces().size();
  this->Service.SetFault(this->GetParam().Fault);
  int ticks = 0;
  while (this->Force() > 0.0 && ticks < 200)
  {
    this->Tick();
    ++ticks;
  }
  EXPECT_LE(ticks, this->GetParam().MostTicks) << this->Device->Problem();
  for (int n = 0; n < 60; ++n)
  {
    this->Tick();
    ASSERT_EQ(this->Force(), 0.0) << "until a person ends the fault";
  }
  this->Device->Close();
  // On the wire, as the service read them: no more forces than ticks until the servo gave 0 N, and
  // the one that was on its way.
  const std::vector<Vector3> forces = this->Service.Forces();
  const auto isPush = [](const Vector3& force) { return !force.isZero(0.0); };
  EXPECT_LE(
      std::count_if(forces.begin() + static_cast<std::ptrdiff_t>(before), forces.end(), isPush),
      ticks + 1);
  // A service that is gone reads no 0 N, and its device is idle by itself.
  const bool isGone = this->GetParam().Fault == Inverse3Fault::CutOff ||
                      this->GetParam().Fault == Inverse3Fault::CloseFrame;
  EXPECT_TRUE(isGone || forces.back().isZero(0.0));
  this->RecordProperty("front", "Inverse3");
  this->RecordProperty("fault", this->GetParam().Name);
  static std::map<std::string, int> most; // of all repetitions
  int& known = most[this->GetParam().Name];
  known = std::max(known, ticks);
  this->RecordProperty("ticks", known);
}

INSTANTIATE_TEST_SUITE_P(
    Each, Inverse3Faults,
    testing::Values(FaultCase{"ServiceIsSilent", Inverse3Fault::Silent, 12},
                    FaultCase{"HalfAMessage", Inverse3Fault::HalfMessage, 4},
                    FaultCase{"MessageOfBytes", Inverse3Fault::Binary, 4},
                    FaultCase{"StateOfAnotherDevice", Inverse3Fault::WrongDevice, 4},
                    FaultCase{"StateOfNoDevice", Inverse3Fault::NoDevice, 4},
                    FaultCase{"PositionIsNoNumber", Inverse3Fault::NotANumber, 12},
                    FaultCase{"PositionJumps", Inverse3Fault::Jump, 4},
                    FaultCase{"ServiceIsLate", Inverse3Fault::Late, 12},
                    FaultCase{"ServiceEndsTheSession", Inverse3Fault::CloseFrame, 12},
                    FaultCase{"ConnectionIsCut", Inverse3Fault::CutOff, 4},
                    FaultCase{"DeviceStopsItself", Inverse3Fault::StopsItself, 8},
                    FaultCase{"DeviceIsUnplugged", Inverse3Fault::Unplugged, 8},
                    FaultCase{"DeviceIsUsedByAnother", Inverse3Fault::UsedByAnother, 8}),
    [](const auto& tested) { return std::string(tested.param.Name); });
} // namespace
} // namespace palpate::inverse3_faults_test
