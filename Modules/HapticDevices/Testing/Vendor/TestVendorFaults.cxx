#include "ContactCases.h"
#include "Servo.h"
#include "StandInTest.h"

#include <algorithm>
#include <limits>
#include <map>
#include <random>
#include <tuple>

namespace palpate::vendor_faults_test
{
namespace
{
constexpr double BodyRadius = 15.0; // mm
constexpr double ToolRadius = 2.0;  // mm

enum class VendorFault
{
  LibraryReportsAnError,
  PositionIsNoNumber,
  PositionJumps,
  SwitchedOff,
  Closed
};

struct FaultCase
{
  const char* Name;
  VendorFault Fault;
  int MostTicks; ///< from the fault's cause, beyond those that the machine is late
};

/// A capsule that lies across a ball and is pressed beside its middle, so that the arm of a
/// stand-in pushes and turns, in real time, until a fault comes; then the servo goes on ticking.
class PressedArm : public test::StandInTest
{
protected:
  virtual const test::Maker& Maker() const = 0;
  bool IsOpenHaptics() const { return std::string(this->Maker().Kind) == "openhaptics"; }

  // The stand-ins' arms are turned so that a tool lies along z here, or along x.
  Matrix3 Turn() const
  {
    return this->IsOpenHaptics()
               ? Eigen::AngleAxisd(0.5 * M_PI, Vector3::UnitY()).toRotationMatrix()
               : Matrix3(Matrix3::Identity());
  }
  void MoveTo(double depth)
  {
    const Vector3 world(4.0, 0.0, BodyRadius + ToolRadius - depth);
    const Vector3 here = this->Turn().transpose() * world;
    const Vector3 place =
        this->IsOpenHaptics() ? here : Vector3(1e-3 * Vector3(here.z(), here.x(), here.y()));
    for (int part = 0; part < 3; ++part)
    {
      this->Arm->Place[part] = place[part];
    }
  }

  void Touch()
  {
    this->Use(this->Maker());
    this->MoveTo(-3.0);
    ASSERT_TRUE(this->Device->Open().IsOk());
    ServoSettings settings;
    settings.RampDuration = 0.02;
    this->Loop = std::make_unique<Servo>(*this->Device, settings);
    auto scene = std::make_shared<TouchScene>();
    scene->Tool = ToolShape::Capsule(ToolRadius, 20.0, 200);
    scene->Structures.push_back(
        {"ball",
         test::RadialContact({0, {BodyRadius * std::sqrt(4.0 * M_PI)}, Vector3::Zero()}),
         {0.5, 0.0},
         {}});
    scene->Frame = DeviceFrame(this->Turn(), 1.0, Vector3::Zero());
    ASSERT_TRUE(this->Loop->Publish(scene).IsOk());
    for (int trial = 0; trial < 20 && !this->IsFelt(); ++trial)
    {
      this->Loop->Rearm(); // the machine was late
      for (int n = -30; n < 150; ++n)
      {
        this->MoveTo(std::min(0.1 * n, 1.5));
        this->Tick();
      }
    }
    ASSERT_TRUE(this->IsFelt());
  }
  bool IsFelt()
  {
    const TouchState& state = this->Loop->Latest();
    return Vector3(state.ForceDevice).norm() > 0.3 && Vector3(state.TorqueDevice).norm() > 0.3;
  }
  bool IsPushing()
  {
    const TouchState& state = this->Loop->Latest();
    return !Vector3(state.ForceDevice).isZero(0.0) || !Vector3(state.TorqueDevice).isZero(0.0);
  }
  void Tick()
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    TickInfo tick;
    tick.Number = ++this->Ticks;
    tick.Started = tick.Scheduled = this->Time.Now();
    tick.BootTime = this->Time.BootTime();
    this->Loop->Tick(tick);
  }
  void Cause(VendorFault fault)
  {
    switch (fault)
    {
    case VendorFault::LibraryReportsAnError:
      this->Arm->Fails = true;
      break;
    case VendorFault::PositionIsNoNumber:
      this->Arm->Place[1] = std::numeric_limits<double>::quiet_NaN();
      break;
    case VendorFault::PositionJumps:
      this->Arm->Place[1] = 1000.0;
      break;
    case VendorFault::SwitchedOff:
      this->Loop->SwitchOff();
      break;
    case VendorFault::Closed:
      this->Device->Close();
      break;
    }
  }

  std::unique_ptr<Servo> Loop;
  std::uint64_t Ticks = 0;
};

class VendorFaults : public PressedArm,
                     public testing::WithParamInterface<std::tuple<test::Maker, FaultCase>>
{
protected:
  const test::Maker& Maker() const override { return std::get<0>(this->GetParam()); }
};

TEST_P(VendorFaults, EndInZeroForceAndZeroTorqueInTheLibrary)
{
  const FaultCase& fault = std::get<1>(this->GetParam());
  // With --gtest_repeat each repetition is another case (Utilities/safety.sh).
  static unsigned seed = 0;
  std::mt19937 random(++seed);
  this->Touch();
  for (unsigned wait = random() % 7; wait > 0; --wait)
  {
    this->Tick();
  }
  ASSERT_GT(this->DisplayedTorque().norm(), 0.0);
  this->Cause(fault.Fault);
  int ticks = 0;
  while (this->IsPushing() && ticks < 200)
  {
    this->Tick();
    ++ticks;
  }
  EXPECT_LE(ticks, fault.MostTicks) << this->Device->Problem();
  const int pushes = this->Arm->Pushes;
  for (int n = 0; n < 60; ++n)
  {
    this->Tick();
    ASSERT_FALSE(this->IsPushing()) << "until a person ends the fault";
  }
  EXPECT_LE(this->Arm->Pushes, pushes + 1) << "but for the step that was under way";
  EXPECT_FALSE(this->IsDisplaying());
  this->RecordProperty("front", "library");
  this->RecordProperty("fault", fault.Name);
  static std::map<std::string, int> most; // of all repetitions and makers
  int& known = most[fault.Name];
  known = std::max(known, ticks);
  this->RecordProperty("ticks", known);
}

class VendorSilence : public PressedArm, public testing::WithParamInterface<test::Maker>
{
protected:
  const test::Maker& Maker() const override { return this->GetParam(); }
};

TEST_P(VendorSilence, NoStepFollowsAnErrorOfTheLibrary)
{
  this->Touch();
  this->Arm->Fails = true;
  for (int n = 0; n < 50; ++n)
  {
    this->Tick();
  }
  EXPECT_EQ(this->Loop->Latest().Safety.Fault, SafetyFault::DeviceFailed);
  EXPECT_EQ(this->Device->State(), DeviceState::Error);
  EXPECT_NE(this->Device->Problem().find("open it again"), std::string::npos);
  const int steps = this->Arm->Steps;
  std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(this->Arm->Steps, steps);
}

TEST_P(VendorSilence, ServoThatHangsIsFollowedByNothing)
{
  this->Touch();
  for (int n = 0; n < 2000 && this->IsDisplaying(); ++n)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_FALSE(this->IsDisplaying());
}

INSTANTIATE_TEST_SUITE_P(
    Each, VendorFaults,
    testing::Combine(
        testing::ValuesIn(test::Makers),
        testing::Values(FaultCase{"LibraryReportsAnError", VendorFault::LibraryReportsAnError, 12},
                        FaultCase{"PositionIsNoNumber", VendorFault::PositionIsNoNumber, 12},
                        FaultCase{"PositionJumps", VendorFault::PositionJumps, 12},
                        FaultCase{"SwitchedOff", VendorFault::SwitchedOff, 2},
                        FaultCase{"Closed", VendorFault::Closed, 2})),
    [](const auto& tested)
    { return std::string(std::get<0>(tested.param).Kind) + std::get<1>(tested.param).Name; });
INSTANTIATE_TEST_SUITE_P(Each, VendorSilence, testing::ValuesIn(test::Makers),
                         [](const auto& tested) { return std::string(tested.param.Kind); });
} // namespace
} // namespace palpate::vendor_faults_test
