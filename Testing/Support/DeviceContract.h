#pragma once

#include "HapticDevice.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <thread>

namespace palpate::test
{
/// Waits for a device in real time whose period is a busy machine's: until it measures anew.
inline void AwaitSample(HapticDevice& device)
{
  DeviceSample sample;
  device.Read(sample);
  const std::uint64_t known = sample.Sequence;
  for (int n = 0; n < 2000 && sample.Sequence == known; ++n)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    device.Read(sample);
  }
}

/// Contract of every back end: checks a closed device that works. `wait` lets one of the device's
/// periods pass.
inline void ExpectDeviceContract(HapticDevice& device, const std::function<void()>& wait)
{
  DeviceSample sample;
  ASSERT_EQ(device.State(), DeviceState::Closed);
  EXPECT_FALSE(device.Read(sample)) << "a closed device must give no samples";
  EXPECT_FALSE(device.Apply(Vector3::Zero())) << "a closed device must accept no forces";
  device.Close();

  const DeviceCapabilities& abilities = device.Capabilities();
  EXPECT_FALSE(abilities.Name.empty());
  EXPECT_GT(abilities.MaximumForce, 0.0) << "otherwise the safety chain blocks all forces";
  EXPECT_GT(abilities.Rate, 0.0);

  for (int session = 0; session < 2; ++session)
  {
    const Status status = device.Open();
    ASSERT_TRUE(status.IsOk()) << status.Message();
    EXPECT_FALSE(device.Open().IsOk()) << "an open device must not open again";
    for (int n = 0; n < 1000 && device.State() != DeviceState::Ready; ++n)
    {
      wait();
      EXPECT_TRUE(device.Read(sample)) << "samples end homing";
      EXPECT_TRUE(device.Apply(Vector3::Zero()));
    }
    ASSERT_EQ(device.State(), DeviceState::Ready);
    EXPECT_TRUE(device.Problem().empty());
    ASSERT_TRUE(device.Read(sample));
    for (int n = 0; n < 20; ++n)
    {
      const DeviceSample last = sample;
      wait();
      ASSERT_TRUE(device.Read(sample));
      EXPECT_GT(sample.Sequence, last.Sequence) << "a new measurement must have a new number";
      EXPECT_GT(sample.Time, last.Time);
      EXPECT_TRUE(Vector3(sample.Position).allFinite());
      EXPECT_NEAR(Eigen::Map<const Eigen::Vector4d>(sample.Orientation.data()).norm(), 1.0, 1e-6);
      EXPECT_TRUE(device.Apply(Vector3::Zero()));
    }
    device.Close();
    EXPECT_EQ(device.State(), DeviceState::Closed);
    EXPECT_FALSE(device.Read(sample));
    EXPECT_FALSE(device.Apply(Vector3::Zero()));
  }
}
} // namespace palpate::test
