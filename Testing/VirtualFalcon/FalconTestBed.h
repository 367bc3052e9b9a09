#pragma once

#include "UmockdevNode.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace palpate::test
{
/// Virtual Falcons on a virtual bus, for unchanged programs that this process starts and for
/// libusb in this process: udev, sysfs and usbfs as they see them. Needs umockdev's library
/// preloaded (umockdev-wrapper) in all of them, and changes the environment while it exists.
///
/// A reply takes about a millisecond longer than on a real bus, and more on a busy machine.
class FalconTestBed
{
public:
  /// Whether this process has the library preloaded.
  static bool IsPossible();

  /// Orphaned processes become this process's children from now on.
  FalconTestBed();
  ~FalconTestBed();
  FalconTestBed(const FalconTestBed&) = delete;
  FalconTestBed& operator=(const FalconTestBed&) = delete;

  /// Plugs a Falcon in at a port (1..9) of bus 1, so its bus path is "1-<port>". Keeps the address,
  /// which must outlive the bed.
  void Plug(UsbfsFalcon& falcon, int port);
  void Unplug(int port, VirtualFalcon::Supply supply = VirtualFalcon::Supply::Lost);
  /// Removes or restores everyone's permission to open it.
  void Forbid(int port, bool forbid);
  /// Sets the interface's driver in sysfs: a kernel driver, or "usbfs" for a program.
  void ShowDriver(int port, const std::string& driver);

private:
  struct Plugged
  {
    UsbfsFalcon* Falcon;
    std::unique_ptr<UmockdevNode> Node;
  };

  ObjectPointer<UMockdevTestbed> Bed;
  std::map<int, Plugged> Falcons; // by port
  // Nodes that were unplugged while programs had them open.
  std::vector<std::unique_ptr<UmockdevNode>> OldNodes;
};
} // namespace palpate::test
