#pragma once

#include "Clock.h"
#include "DeviceRegistry.h"
#include "HapticDevice.h"
#include "IgtlPeer.h"
#include "IgtlPoses.h"
#include "IgtlProgress.h"
#include "IgtlStream.h"
#include "IgtlTouch.h"
#include "LatestValue.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
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
/// Forces that are not renewed for 20 ms are replaced by 0 N, once. Nothing waits for the
/// connection but the newest force, and MostOnTheirWay at most are sent that are not confirmed: by
/// the peer's system, and by the peer itself if it confirms what it has read. A peer that does not
/// confirm within 30 ms is behind: Apply returns false, and only 0 N is sent until it confirms in
/// time again. What lies in the buffer of a system whose program confirms nothing cannot be seen or
/// taken back. When the connection ends, or bytes arrive that are not OpenIGTLink, the device is in
/// Error.
class OpenIGTLinkDevice final : public HapticDevice
{
public:
  /// Longest time (s) between poses that is not a fault: trackers have 20 Hz and more.
  static constexpr double LongestGap = 0.1;
  /// Forces that may be sent without being confirmed.
  static constexpr std::size_t MostOnTheirWay = 5;

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
  bool SendNews();
  void WatchPeer();
  std::uint64_t Unread() const noexcept;
  bool HasRoom(std::size_t bytes) const noexcept;
  std::optional<PlainVector3> NextForce();
  bool SendForce();
  bool SendShown();
  std::ptrdiff_t SendNow(const std::vector<std::uint8_t>& message);
  bool SendRest();
  void SendLastZero();
  void EndIn(const char* problem) noexcept;

  Clock& Time;
  IgtlPeer From;
  DeviceCapabilities Abilities;
  std::atomic<DeviceState> Life{DeviceState::Closed};
  std::atomic<const char*> Failure{""};
  std::atomic<bool> MustEnd{false};
  std::atomic<bool> IsBehind{false}; ///< the peer
  std::atomic<std::uint64_t> Refused{0};
  std::atomic<std::uint64_t> NotSent{0}; ///< forces
  LatestValue<DeviceSample> Newest;      ///< to the servo
  LatestValue<Command> Wanted;           ///< from the servo
  LatestValue<IgtlTouch> Displayed;      ///< from the servo
  std::uint64_t Commands = 0;            ///< servo thread

  // Of the thread while it runs.
  IgtlStream Stream;
  IgtlPoses Poses;
  IgtlProgress Arriving; ///< bytes, confirmed by the peer's system
  IgtlProgress Reading;  ///< forces, confirmed by the peer
  std::uint64_t ForcesSent = 0;
  DeviceSample Last;
  std::uint64_t SentNumber = 0;   ///< the last command that was sent
  bool IsAtRest = true;           ///< the last force sent is 0 N
  IgtlTouch Told;                 ///< the last that was sent
  std::vector<std::uint8_t> Rest; ///< of a message of which a part is sent
  std::thread Thread;
};

/// Adds "openigtlink:<peer>": an OpenIGTLinkDevice.
Status RegisterOpenIGTLinkDevices(DeviceRegistry& registry);
} // namespace palpate
