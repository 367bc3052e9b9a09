#pragma once

#include "DeviceRegistry.h"
#include "StandIn.h"
#include "SteadyClock.h"
#include "VendorDevice.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <dlfcn.h>
#include <memory>
#include <string>
#include <thread>

namespace palpate::test
{
struct Maker
{
  const char* Kind;
  const char* Variable;
  const char* Library;
  Vector3 Place;      ///< of the library, which is 10, 20, 30 mm here
  Vector3 Force;      ///< of the library, for 1, 2, 0.5 N here
  Vector3 Torque;     ///< of the library, for 20, 40, 10 N mm here
  double Limit;       ///< N
  double TorqueLimit; ///< in the library's unit
};

/// Force Dimension's axes are others, in m and N m.
inline const Maker Makers[] = {
    {"openhaptics", "PALPATE_LIBHD", PALPATE_STAND_IN_HD, Vector3(10.0, 20.0, 30.0),
     Vector3(1.0, 2.0, 0.5), Vector3(20.0, 40.0, 10.0), 7.9, 300.0},
    {"forcedimension", "PALPATE_LIBDHD", PALPATE_STAND_IN_DHD, Vector3(0.030, 0.010, 0.020),
     Vector3(0.5, 1.0, 2.0), Vector3(0.010, 0.020, 0.040), 8.0, 0.150}};

/// Each maker's library is replaced by a stand-in, which is opened as the real one would be.
class StandInTest : public testing::Test
{
protected:
  void Use(const Maker& maker)
  {
    this->Variable = maker.Variable;
    setenv(maker.Variable, maker.Library, 1);
    void* const library = dlopen(maker.Library, RTLD_NOW);
    ASSERT_NE(library, nullptr) << dlerror();
    this->Arm = static_cast<StandInArm*>(dlsym(library, "StandIn"));
    ASSERT_NE(this->Arm, nullptr);
    this->Arm->IsMissing = false;
    this->Arm->Fails = false;
    this->Arm->Turns = true;
    this->Arm->LargestForce = 0.0;
    this->Arm->LargestTorque = 0.0;
    this->Arm->Buttons = 0;
    ASSERT_TRUE(RegisterVendorDevices(this->Registry).IsOk());
    ASSERT_TRUE(this->Registry.Make(maker.Kind, this->Time, this->Device).IsOk());
  }
  void TearDown() override
  {
    this->Device.reset();
    unsetenv(this->Variable);
  }
  template <typename Condition>
  bool TickUntil(const Condition& isTrue, const Vector3& force = Vector3::Zero(),
                 const Vector3& torque = Vector3::Zero())
  {
    for (int n = 0; n < 3000; ++n)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      this->IsRead = this->Device->Read(this->Sample);
      this->Device->ApplyWrench(force, torque);
      if (isTrue())
      {
        return true;
      }
    }
    return false;
  }
  bool BecomesReady()
  {
    return this->TickUntil([this] { return this->Device->State() == DeviceState::Ready; });
  }
  Vector3 Displayed() const
  {
    return {this->Arm->Force[0], this->Arm->Force[1], this->Arm->Force[2]};
  }
  Vector3 DisplayedTorque() const
  {
    return {this->Arm->Torque[0], this->Arm->Torque[1], this->Arm->Torque[2]};
  }
  bool IsDisplaying() const
  {
    return !this->Displayed().isZero(0.0) || !this->DisplayedTorque().isZero(0.0);
  }

  SteadyClock Time;
  DeviceRegistry Registry;
  std::unique_ptr<HapticDevice> Device;
  StandInArm* Arm = nullptr;
  DeviceSample Sample;
  bool IsRead = false;

private:
  const char* Variable = "";
};
} // namespace palpate::test
