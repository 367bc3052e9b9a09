#pragma once

#include "Vector3.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace palpate::test
{
/// What the service does wrong, from when it is set.
enum class Inverse3Fault
{
  None,
  Silent,        ///< no reply
  HalfMessage,   ///< text that ends early
  Binary,        ///< bytes that are no text
  WrongDevice,   ///< a state of another id
  NoDevice,      ///< an empty list
  NotANumber,    ///< a position of null
  Jump,          ///< 300 mm away
  Late,          ///< each reply after 30 ms
  CloseFrame,    ///< a polite end
  CutOff,        ///< the connection is gone
  StopsItself,   ///< an event: emergency brake
  Unplugged,     ///< an event: device lost
  UsedByAnother, ///< an event: device busy
};

/// Stands for Haply's service: a WebSocket server on this machine that answers each message with a
/// state, after docs.haply.co. It refuses a force under the field's name of another version, by
/// staying idle.
class VirtualInverse3
{
public:
  struct Settings
  {
    bool TakesVector = true; ///< 3.5; false: 3.1
    std::string Type = "inverse3";
    bool HasGrip = true;
    int DeviceCount = 1;
  };

  VirtualInverse3();
  explicit VirtualInverse3(const Settings& settings);
  ~VirtualInverse3();
  VirtualInverse3(const VirtualInverse3&) = delete;
  VirtualInverse3& operator=(const VirtualInverse3&) = delete;

  /// For DeviceRegistry: ports.
  std::string Argument() const;
  void SetFault(Inverse3Fault fault) { this->Broken = fault; }
  /// Of the cursor, m, in the service's frame.
  void MoveTo(const Vector3& cursor);
  /// All forces (N, service's frame) that were sent, in order.
  std::vector<Vector3> Forces() const;
  /// The first message, as it came.
  std::string Handshake() const;

private:
  class Server;

  std::atomic<Inverse3Fault> Broken{Inverse3Fault::None};
  mutable std::mutex Guard;
  Vector3 Cursor = Vector3::Zero();
  std::vector<Vector3> Taken;
  std::string First;
  std::unique_ptr<Server> Running;
};
} // namespace palpate::test
