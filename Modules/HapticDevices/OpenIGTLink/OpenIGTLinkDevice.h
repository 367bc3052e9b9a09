#pragma once

#include "Clock.h"
#include "DeviceRegistry.h"
#include "HapticDevice.h"
#include "IgtlPeer.h"
#include "IgtlPoses.h"
#include "IgtlStream.h"
#include "IgtlTouch.h"
#include "LatestValue.h"

#include <atomic>
#include <cstdint>
#include <string>
#include <thread>
#include <vector>

namespace palpate
{
/// A tracked tool on the network: TRANSFORM messages of OpenIGTLink are its poses (mm, in the
/// tracker's frame), and forces (N, in that frame) are sent back as SENSOR messages named Force,
/// for a peer with motors; and for one that displays the scene, what IgtlTouchMessages names. A
/// thread of its own talks to the peer. It is homing until the first pose.
///
/// Forces that are not renewed for 20 ms are replaced by 0 N, once; nothing is sent late: of forces
/// that the connection cannot take, only the newest is kept. When the connection ends, or bytes
/// arrive that are not OpenIGTLink, the device is in Error.
class OpenIGTLinkDevice final : public HapticDevice
{
public:
  /// Longest time (s) between poses that is not a fault: trackers have 20 Hz and more.
  static constexpr double LongestGap = 0.1;

  /// Keeps the address of the clock, which must outlive it.
  OpenIGTLinkDevice(Clock& clock, IgtlPeer peer);
  ~OpenIGTLinkDevice() override { this->OpenIGTLinkDevice::Close(); }

  const DeviceCapabilities& Capabilities() const noexcept override { return this->Abilities; }
  DeviceState State() const noexcept override { return this->Life.load(); }
  std::string Problem() const override;
  std::string Guidance() const override;
  std::string ConnectionReport() const override;
  Status Open() override;
  void Close() noexcept override;
  bool Read(DeviceSample& sample) noexcept override;
  bool Apply(const Vector3& force) noexcept override;
  void Show(const TouchState& state) noexcept override;

  /// The port that is listened on while it is open.
  int Port() const noexcept { return this->Stream.Port(); }

private:
  struct Command
  {
    PlainVector3 Force;
    std::uint64_t Number = 0; ///< of the call of Apply
    std::int64_t Time = 0;    ///< ns
  };

  void Run();
  bool TakePoses();
  void AddForce();
  void AddShown();
  bool SendNews();
  void Add(const std::vector<std::uint8_t>& message);
  bool SendRest();
  void EndIn(const char* problem) noexcept;

  Clock& Time;
  IgtlPeer From;
  DeviceCapabilities Abilities;
  std::atomic<DeviceState> Life{DeviceState::Closed};
  std::atomic<const char*> Failure{""};
  std::atomic<bool> MustEnd{false};
  std::atomic<std::uint64_t> Refused{0};
  LatestValue<DeviceSample> Newest; ///< to the servo
  LatestValue<Command> Wanted;      ///< from the servo
  LatestValue<IgtlTouch> Displayed; ///< from the servo
  std::uint64_t Commands = 0;       ///< servo thread

  // Of the thread while it runs.
  IgtlStream Stream;
  IgtlPoses Poses;
  DeviceSample Last;
  std::uint64_t SentNumber = 0;   ///< the last command that was sent
  bool IsAtRest = true;           ///< the last force sent is 0 N
  IgtlTouch Told;                 ///< the last that was sent
  std::vector<std::uint8_t> Rest; ///< of what the connection has not taken yet
  std::thread Thread;
};

/// Adds "openigtlink:<peer>": an OpenIGTLinkDevice.
Status RegisterOpenIGTLinkDevices(DeviceRegistry& registry);
} // namespace palpate
