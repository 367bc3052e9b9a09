#include "FalconTestBed.h"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <sstream>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace palpate::test
{
namespace
{
// A device's number on the bus; 1 is the bus's own.
int NumberAt(int port)
{
  return port + 1;
}

std::string NodeOf(int port)
{
  std::ostringstream text;
  text << "/dev/bus/usb/001/" << std::setfill('0') << std::setw(3) << NumberAt(port);
  return text.str();
}

std::string SysfsPath(int port)
{
  return "/devices/usb1/1-" + std::to_string(port);
}

std::string Hexadecimal(const FalconDescriptors& descriptors)
{
  std::ostringstream text;
  text << std::hex << std::uppercase << std::setfill('0');
  for (const std::uint8_t byte : descriptors.Bytes())
  {
    text << std::setw(2) << static_cast<int>(byte);
  }
  return text.str();
}

// In umockdev's format; without a line for the node, which it would create as a plain file.
std::string DeviceText(const FalconDescriptors& descriptors, int port)
{
  std::ostringstream text;
  text << "P: " << SysfsPath(port) << "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\n"
       << "E: DEVNAME=" << NodeOf(port) << "\nE: BUSNUM=001\n"
       << "E: DEVNUM=" << std::setfill('0') << std::setw(3) << NumberAt(port)
       << "\nE: PRODUCT=403/cb48/600\nA: busnum=1\\n\n"
       << "A: devnum=" << NumberAt(port) << "\\n\nA: bConfigurationValue=1\\n\nA: speed=12\\n\n"
       << "A: idVendor=0403\\n\nA: idProduct=cb48\\n\nA: bNumConfigurations=1\\n\n"
       << "A: serial=" << descriptors.Serial << "\\n\n"
       << "H: descriptors=" << Hexadecimal(descriptors) << "\n\n";
  return text.str();
}

// The guards that FalconGuard started and no process waits for any more: they became children of
// this process, and would hold the bed's folder for as long as a cable may be unplugged.
std::vector<pid_t> OrphanedGuards()
{
  std::vector<pid_t> guards;
  for (const auto& entry : std::filesystem::directory_iterator("/proc"))
  {
    std::ifstream file(entry.path() / "stat");
    pid_t process = 0;
    pid_t parent = 0;
    std::string name;
    std::string state;
    file >> process >> name >> state >> parent;
    if (parent == getpid() && name.rfind("(palpate-falcon-", 0) == 0)
    {
      guards.push_back(process);
    }
  }
  return guards;
}
} // namespace

bool FalconTestBed::IsPossible()
{
  return umockdev_in_mock_environment() != 0;
}

FalconTestBed::FalconTestBed() : Bed(umockdev_testbed_new())
{
  prctl(PR_SET_CHILD_SUBREAPER, 1);
}

FalconTestBed::~FalconTestBed()
{
  while (!this->Falcons.empty())
  {
    this->Unplug(this->Falcons.begin()->first);
  }
  for (const pid_t guard : OrphanedGuards())
  {
    kill(guard, SIGKILL);
    waitpid(guard, nullptr, 0);
  }
}

void FalconTestBed::Plug(UsbfsFalcon& falcon, int port)
{
  falcon.Plug();
  this->Falcons[port] = {&falcon,
                         std::make_unique<UmockdevNode>(this->Bed.get(), falcon, NodeOf(port))};
  GError* error = nullptr;
  umockdev_testbed_add_from_string(this->Bed.get(), DeviceText(falcon.Descriptors(), port).c_str(),
                                   &error);
  if (error != nullptr)
  {
    const std::string message = error->message;
    g_error_free(error);
    throw std::runtime_error(message);
  }
}

void FalconTestBed::Unplug(int port, VirtualFalcon::Supply supply)
{
  const auto found = this->Falcons.find(port);
  found->second.Falcon->Unplug(UsbfsFalcon::Unplugging::AbortsReads, supply);
  umockdev_testbed_uevent(this->Bed.get(), ("/sys" + SysfsPath(port)).c_str(), "remove");
  umockdev_testbed_remove_device(this->Bed.get(), ("/sys" + SysfsPath(port)).c_str());
  found->second.Node->Remove();
  this->OldNodes.push_back(std::move(found->second.Node));
  this->Falcons.erase(found);
}

void FalconTestBed::Forbid(int port, bool forbid)
{
  constexpr mode_t ForAll = 0666;
  chmod(this->Falcons.at(port).Node->File().c_str(), forbid ? 0 : ForAll);
}

void FalconTestBed::ShowDriver(int port, const std::string& driver)
{
  const std::string interface = SysfsPath(port) + "/1-" + std::to_string(port) + ":1.0";
  const std::string text = "P: " + interface +
                           "\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\n"
                           "L: driver=../../../../bus/usb/drivers/" +
                           driver + "\n\n";
  umockdev_testbed_add_from_string(this->Bed.get(), text.c_str(), nullptr);
}
} // namespace palpate::test
