#include "BootStream.h"
#include "FalconTestBed.h"
#include "StartedCommand.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"
#include "TouchRecording.h"
#include "Unprivileged.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <gtest/gtest.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <sys/wait.h>
#include <thread>

namespace palpate::test::cli_falcon_test
{
namespace
{
// A hand that pulls the handle out and pushes it in, twice a second.
VirtualMechanismSettings PullingHand()
{
  VirtualMechanismSettings settings;
  settings.IsRigid = true;
  settings.Path = [](double t)
  { return Vector3(0.0, 0.0, 130.0 - 45.0 * std::cos(4.0 * M_PI * t)); };
  return settings;
}

// The number of the first recorded tick with a fault, or of all ticks.
std::size_t FirstFault(const TouchRecording& recorded)
{
  const auto failed =
      std::find_if(recorded.Ticks.begin(), recorded.Ticks.end(),
                   [](const TouchState& tick) { return tick.Safety.Fault != SafetyFault::None; });
  return static_cast<std::size_t>(failed - recorded.Ticks.begin());
}

// Success if forces were on while the device was ready, and 0 N from the fault on. A force that the
// device does not take is the fault of its own tick.
testing::AssertionResult IsFeltUntil(const TouchRecording& recorded, std::size_t failed)
{
  for (std::size_t n = 0; n < recorded.Ticks.size(); ++n)
  {
    const TouchState& tick = recorded.Ticks[n];
    const bool isOn = n < failed && tick.State == DeviceState::Ready;
    const bool isRefused = n == failed && !tick.WasTaken;
    const double force = isRefused ? 0.0 : Vector3(tick.ForceDevice).norm();
    if (tick.Safety.IsArmed != isOn || (!isOn && force > 0.0))
    {
      return testing::AssertionFailure()
             << "tick " << n << " of " << recorded.Ticks.size() << ", fault at " << failed
             << ": state " << static_cast<int>(tick.State) << ", armed " << tick.Safety.IsArmed
             << ", fault " << Describe(tick.Safety.Fault) << ", " << force << " N";
    }
  }
  return testing::AssertionSuccess();
}

// N, before this tick.
double LargestForce(const TouchRecording& recorded, std::size_t failed)
{
  double largest = 0.0;
  for (std::size_t n = 0; n < failed; ++n)
  {
    largest = std::max(largest, Vector3(recorded.Ticks[n].ForceDevice).norm());
  }
  return largest;
}

// Whether the recording shows the delay reported by the fault of this tick: on a busy machine
// replies and ticks are really late, and then forces must go off.
bool IsTrueDelay(const TouchRecording& recorded, std::size_t failed)
{
  constexpr std::int64_t Limit = 10'000'000; // ns, of samples and ticks
  const std::vector<TouchState>& ticks = recorded.Ticks;
  const TouchState& tick = ticks[failed];
  if (tick.Safety.Fault == SafetyFault::StalledTick)
  {
    return failed > 0 && tick.Tick.Started - ticks[failed - 1].Tick.Started > Limit;
  }
  if (tick.Safety.Fault == SafetyFault::UntakenForce)
  {
    return !tick.WasTaken;
  }
  if (tick.Safety.Fault == SafetyFault::DeviceFailed)
  {
    constexpr std::int64_t Silence = 200'000'000; // ns, after which the driver gives up
    return failed == 0 || tick.Tick.Started - ticks[failed - 1].Sample.Time > Silence;
  }
  std::size_t first = failed; // that saw this sample
  while (first > 0 && ticks[first - 1].Sample.Sequence == tick.Sample.Sequence)
  {
    --first;
  }
  const double silent = static_cast<double>(failed - first) / recorded.Session.Settings.Rate;
  return tick.Safety.Fault == SafetyFault::StaleSample &&
         (tick.Tick.Started - tick.Sample.Time > Limit ||
          silent > 1.0 / recorded.Session.Device.LeastRate());
}

// The program, unchanged, with virtual Falcons on a virtual bus. Replies take some milliseconds
// there, so rates are not tested.
class CliFalcon : public testing::Test
{
protected:
  void SetUp() override
  {
    // Not skipped: a missing wrapper must not look like success.
    ASSERT_TRUE(FalconTestBed::IsPossible()) << "umockdev is not preloaded: use umockdev-wrapper";
    unsetenv("PALPATE_FALCON_FIRMWARE");
    const std::vector<std::uint8_t> image = BootStream();
    WriteAll(this->Folder / "firmware.bin", {image.begin(), image.end()});
  }

  CommandRun Run(const std::vector<std::string>& arguments)
  {
    return RunPalpate(arguments, this->Folder.Path());
  }

  // Entries of `palpate devices --json` whose names begin with this.
  std::vector<nlohmann::json> Listed(const std::string& name)
  {
    const CommandRun run = this->Run({"devices", "--json"});
    EXPECT_EQ(run.Code, 0) << run.Errors;
    std::istringstream lines(run.Output);
    std::vector<nlohmann::json> found;
    for (std::string line; std::getline(lines, line);)
    {
      const nlohmann::json device = nlohmann::json::parse(line);
      if (device["name"].get<std::string>().rfind(name, 0) == 0)
      {
        found.push_back(device);
      }
    }
    return found;
  }

  bool IsLoaded()
  {
    return this->Bus.WithFalcon([](VirtualFalcon& falcon)
                                { return falcon.Board().Image() == BootStream(); });
  }

  // A touch of two seconds, without a fault or with one explained by this machine's delays; it is
  // felt if the sphere pushed before that.
  void TouchOnce(bool& isFelt)
  {
    std::filesystem::remove_all(this->Folder / "felt");
    const CommandRun run =
        this->Run({"touch", "a.nii.gz", "--label", "1", "--device", "falcon:device=VF000001",
                   "--firmware", "firmware.bin", "--seconds", "2", "--output", "felt", "--json"});
    EXPECT_TRUE(this->IsLoaded());
    TouchRecording recorded;
    const Status status =
        ReadTouchRecording((this->Folder / "felt/session.touch").string(), recorded);
    ASSERT_TRUE(status.IsOk()) << status.Message() << run.Errors;
    const nlohmann::json summary = nlohmann::json::parse(run.Output);
    EXPECT_EQ(summary["ticks"].get<std::size_t>(), recorded.Ticks.size());
    const std::size_t failed = FirstFault(recorded);
    // In contact, ready and in time: until the end, or until the machine or the bus was too slow.
    EXPECT_TRUE(IsFeltUntil(recorded, failed));
    isFelt = LargestForce(recorded, failed) > 0.5;
    if (failed == recorded.Ticks.size())
    {
      EXPECT_EQ(run.Code, 0) << run.Errors;
      EXPECT_EQ(summary["fault"], "");
      EXPECT_TRUE(isFelt);
      return;
    }
    const SafetyFault fault = recorded.Ticks[failed].Safety.Fault;
    EXPECT_EQ(run.Code, 1) << run.Errors;
    EXPECT_EQ(summary["fault"], Describe(fault));
    EXPECT_TRUE(IsTrueDelay(recorded, failed)) << Describe(fault);
    this->Delays += std::string("\ntick ") + std::to_string(failed) + ": " + Describe(fault);
  }

  TemporaryFolder Folder;
  VirtualFalcon Model{PullingHand()};
  UsbfsFalcon Bus{Model};
  FalconTestBed Bed;
  std::string Delays; // of touches that ended early
};

TEST_F(CliFalcon, ListReportsMissingDevice)
{
  const std::vector<nlohmann::json> falcons = this->Listed("falcon");
  ASSERT_EQ(falcons.size(), 1U);
  EXPECT_EQ(falcons[0]["name"], "falcon");
  EXPECT_FALSE(falcons[0]["there"].get<bool>());
  EXPECT_EQ(falcons[0]["details"],
            "There is no Falcon on USB: plug in its cable and its power supply.");
  const CommandRun home = this->Run({"devices", "--home"});
  EXPECT_EQ(home.Code, 2);
  EXPECT_NE(home.Errors.find("There is no Falcon on USB"), std::string::npos) << home.Errors;
}

TEST_F(CliFalcon, ListFollowsHotPlugAndState)
{
  this->Bed.Plug(this->Bus, 2);
  std::vector<nlohmann::json> falcons = this->Listed("falcon");
  ASSERT_EQ(falcons.size(), 1U);
  EXPECT_EQ(falcons[0]["name"], "falcon:device=1-2");
  EXPECT_FALSE(falcons[0]["there"].get<bool>());
  const std::string isReported = falcons[0]["details"];
  EXPECT_NE(isReported.find("no firmware"), std::string::npos) << isReported;
  EXPECT_NE(isReported.find("VF000001"), std::string::npos) << isReported;

  setenv("PALPATE_FALCON_FIRMWARE", (this->Folder / "firmware.bin").c_str(), 1);
  falcons = this->Listed("falcon");
  ASSERT_EQ(falcons.size(), 1U);
  EXPECT_TRUE(falcons[0]["there"].get<bool>()) << falcons[0];
  EXPECT_EQ(falcons[0]["device"], "Novint Falcon");
  EXPECT_FALSE(this->IsLoaded()) << "listing loads nothing";

  this->Bed.Unplug(2);
  EXPECT_EQ(this->Listed("falcon").at(0)["name"], "falcon");
}

TEST_F(CliFalcon, IsVisibleOnlyOnVirtualBus)
{
  this->Bed.Plug(this->Bus, 2);
  const CommandRun run =
      RunCommand("env", {"-u", "LD_PRELOAD", PALPATE_PROGRAM, "devices"}, this->Folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_EQ(run.Output.find("falcon:device=1-2"), std::string::npos) << run.Output;
}

TEST_F(CliFalcon, MissingPermissionGivesFix)
{
  if (geteuid() == 0)
  {
    RunAgainUnprivileged();
    return;
  }
  this->Bed.Plug(this->Bus, 2);
  this->Bed.Forbid(2, true);
  const std::string isReported = this->Listed("falcon").at(0)["details"];
  EXPECT_NE(isReported.find("Utilities/install-udev-rule.sh"), std::string::npos) << isReported;
  const CommandRun run = this->Run({"devices", "--home"});
  EXPECT_EQ(run.Code, 1);
  EXPECT_NE(run.Errors.find("Utilities/install-udev-rule.sh"), std::string::npos) << run.Errors;
}

TEST_F(CliFalcon, LoadsAndHomesWithGuidance)
{
  this->Bed.Plug(this->Bus, 2);
  const CommandRun run = this->Run({"devices", "--home", "--firmware", "firmware.bin", "--json"});
  ASSERT_EQ(run.Code, 0) << run.Errors;
  EXPECT_TRUE(this->IsLoaded());
  EXPECT_NE(run.Errors.find("Pull the handle all the way out"), std::string::npos) << run.Errors;
  const nlohmann::json report = nlohmann::json::parse(run.Output);
  EXPECT_EQ(report["state"], "ready");
  EXPECT_GT(report["samples"].get<int>(), 20);
  EXPECT_NE(report["connection"].get<std::string>().find("replies"), std::string::npos);
  EXPECT_EQ(this->Bus.WithFalcon([](VirtualFalcon& falcon) { return falcon.Board().Motors(); }),
            (std::array<std::int16_t, 3>{}));
  const std::string isReported = this->Listed("falcon").at(0)["details"];
  EXPECT_NE(isReported.find("and it is homed"), std::string::npos)
      << "firmware and zero stay: " << isReported;
}

TEST_F(CliFalcon, MissingOrInvalidFirmwareGivesFix)
{
  this->Bed.Plug(this->Bus, 2);
  const CommandRun none = this->Run({"devices", "--home", "--device", "falcon"});
  EXPECT_EQ(none.Code, 1);
  EXPECT_NE(none.Errors.find("PALPATE_FALCON_FIRMWARE"), std::string::npos) << none.Errors;
  WriteAll(this->Folder / "other.bin", "no firmware");
  const CommandRun other =
      this->Run({"devices", "--home", "--device", "falcon", "--firmware", "other.bin"});
  EXPECT_EQ(other.Code, 1);
  EXPECT_NE(other.Errors.find("other.bin is not a Falcon's firmware"), std::string::npos)
      << other.Errors;
}

// On a busy machine replies are sometimes too late for a touch; it is then repeated, and must have
// ended with the corresponding fault.
TEST_F(CliFalcon, TouchesMask)
{
  this->Bed.Plug(this->Bus, 2);
  WriteTwoSpheres(this->Folder / "a.nii.gz");
  bool isFelt = false;
  for (int tries = 0; tries < 40 && !isFelt; ++tries)
  {
    ASSERT_NO_FATAL_FAILURE(this->TouchOnce(isFelt));
  }
  EXPECT_TRUE(isFelt) << "ended by delays of this machine:" << this->Delays;
}
// Ends the program while the motors push: they carry half a kilogram, so that there is a torque
// even without contact, and the virtual board holds it forever.
class CliFalconEnds : public CliFalcon
{
protected:
  // A touch whose torque has reached the board. If replies are too late before that, as on a busy
  // machine, it is repeated.
  std::unique_ptr<StartedCommand> Pushing()
  {
    this->Bed.Plug(this->Bus, 2);
    WriteTwoSpheres(this->Folder / "a.nii.gz");
    WriteAll(this->Folder / "calibration.txt", "palpate-falcon-calibration 1\ncarried-mass 0.5\n");
    std::unique_ptr<StartedCommand> command;
    for (int tries = 0; tries < 15 && !this->HasTorque(); ++tries)
    {
      if (command != nullptr)
      {
        command->Send(SIGTERM);
        EXPECT_EQ(command->Finish().Code, 128 + SIGTERM);
      }
      command = std::make_unique<StartedCommand>(
          PALPATE_PROGRAM,
          std::vector<std::string>{"touch", "a.nii.gz", "--label", "1", "--device",
                                   "falcon:calibration=calibration.txt", "--firmware",
                                   "firmware.bin", "--seconds", "600", "--output", "felt"},
          this->Folder.Path());
      static_cast<void>(IsSoon([&] { return this->HasTorque() || command->HasEnded(); },
                               std::chrono::seconds(4)));
    }
    EXPECT_TRUE(this->HasTorque());
    return command;
  }

  std::vector<VirtualFalconBoard::Order> Received()
  {
    return this->Bus.WithFalcon([](VirtualFalcon& falcon) { return falcon.Board().Received(); });
  }
  bool HasTorque()
  {
    const std::vector<VirtualFalconBoard::Order> orders = this->Received();
    return !orders.empty() && orders.back().HasTorque();
  }

  // For Documentation/Safety.md: the time until 0 N, after which no torque followed.
  void Record(const std::string& fault, std::chrono::steady_clock::time_point start)
  {
    const std::vector<VirtualFalconBoard::Order> orders = this->Received();
    const auto last = std::find_if(orders.rbegin(), orders.rend(),
                                   [](const auto& order) { return order.HasTorque(); });
    ASSERT_NE(last, orders.rbegin());
    const double passed =
        1e-6 * static_cast<double>((last - 1)->Time - start.time_since_epoch().count());
    RecordProperty("front", "virtual bus");
    RecordProperty("fault", fault);
    RecordProperty("milliseconds", std::to_string(passed));
  }
};

TEST_F(CliFalconEnds, KillLeavesNoTorque)
{
  const std::unique_ptr<StartedCommand> command = this->Pushing();
  const auto start = std::chrono::steady_clock::now();
  command->Send(SIGKILL);
  command->Finish();
  this->Bus.ReleaseClaims(); // umockdev does not report that a client has ended
  EXPECT_TRUE(IsSoon([this] { return !this->HasTorque(); }));
  int status = 1;
  EXPECT_GT(waitpid(-1, &status, 0), 0) << "the guard ends once it has done its work";
  EXPECT_EQ(status, 0);
  this->Record("SIGKILL", start);
}

struct EndingSignals
{
  const char* Name;
  std::vector<int> All;
};

class CliFalconEndsBy : public CliFalconEnds, public testing::WithParamInterface<EndingSignals>
{
};

TEST_P(CliFalconEndsBy, LastPacketHasNoTorqueAndFilesAreComplete)
{
  const std::unique_ptr<StartedCommand> command = this->Pushing();
  const auto start = std::chrono::steady_clock::now();
  for (const int signal : this->GetParam().All)
  {
    command->Send(signal);
    ASSERT_TRUE(IsSoon([&] { return command->HasTakenSignals() || command->HasEnded(); }));
  }
  const CommandRun run = command->Finish();
  EXPECT_EQ(run.Code, 128 + this->GetParam().All.front()) << run.Errors;
  // The chip sends a packet on for a tenth of a millisecond after it has taken it.
  EXPECT_TRUE(IsSoon([this] { return !this->HasTorque(); }));
  EXPECT_TRUE(std::filesystem::exists(this->Folder / "felt/session.touch"));
  EXPECT_TRUE(std::filesystem::exists(this->Folder / "felt/report.html"));
  this->Record(this->GetParam().Name, start);
}

INSTANTIATE_TEST_SUITE_P(Signals, CliFalconEndsBy,
                         testing::Values(EndingSignals{"SIGTERM", {SIGTERM}},
                                         EndingSignals{"SIGHUP", {SIGHUP}},
                                         EndingSignals{"SIGINT", {SIGINT}},
                                         EndingSignals{"SIGINT twice", {SIGINT, SIGINT}}));

struct WireFault
{
  const char* Name; // as in the tests over libusb
  void (*Break)(VirtualFalcon&);
};

class CliFalconEndsWithout : public CliFalconEnds, public testing::WithParamInterface<WireFault>
{
};

TEST_P(CliFalconEndsWithout, BoardReceivesZeroTorque)
{
  const std::unique_ptr<StartedCommand> command = this->Pushing();
  const auto start = std::chrono::steady_clock::now();
  this->Bus.WithFalcon(this->GetParam().Break);
  EXPECT_TRUE(IsSoon([this] { return !this->HasTorque(); }));
  this->Record(this->GetParam().Name, start);
  command->Send(SIGTERM);
  command->Finish();
  EXPECT_FALSE(this->HasTorque());
}

INSTANTIATE_TEST_SUITE_P(
    Replies, CliFalconEndsWithout,
    testing::Values(
        WireFault{"RepliesStop", [](VirtualFalcon& falcon)
                  { falcon.Faults.Spoil = [](VirtualFalconAnswer& a) { a.Bytes.clear(); }; }},
        WireFault{"RepliesStall",
                  [](VirtualFalcon& falcon) {
                    falcon.Faults.Spoil = [](VirtualFalconAnswer& a) { a.Delay += 1'000'000'000; };
                  }},
        WireFault{"RepliesComeLate", [](VirtualFalcon& falcon) {
                    falcon.Faults.Spoil = [](VirtualFalconAnswer& a) { a.Delay += 15'000'000; };
                  }}));

TEST_F(CliFalconEnds, HubResetLeavesNoTorqueAfterReconnect)
{
  const std::unique_ptr<StartedCommand> command = this->Pushing();
  this->Bed.Unplug(2, VirtualFalcon::Supply::Kept);
  EXPECT_TRUE(this->HasTorque());
  const auto start = std::chrono::steady_clock::now();
  this->Bed.Plug(this->Bus, 2);
  EXPECT_TRUE(IsSoon([this] { return !this->HasTorque(); }));
  this->Record("Hub reset, from the device's return", start);
  command->Send(SIGTERM);
  command->Finish();
}

TEST_F(CliFalconEnds, CtrlZIsIgnoredWhileForceIsPossible)
{
  const std::unique_ptr<StartedCommand> command = this->Pushing();
  command->Send(SIGTSTP);
  ASSERT_TRUE(IsSoon([&] { return command->HasTakenSignals(); })) << "it is stopped";
  command->Send(SIGTERM);
  EXPECT_EQ(command->Finish().Code, 128 + SIGTERM);
  EXPECT_FALSE(this->HasTorque());
}

TEST_F(CliFalcon, ReportsUnplugDuringHoming)
{
  this->Model.Mechanism().Settings.Path = nullptr; // nobody moves the grip, so it is never homed
  this->Bed.Plug(this->Bus, 2);
  std::atomic<bool> isOver{false};
  std::thread cable(
      [&]
      {
        while (!isOver && !this->IsLoaded())
        {
          std::this_thread::yield();
        }
        this->Bed.Unplug(2);
      });
  const CommandRun run =
      this->Run({"devices", "--home", "--device", "falcon", "--firmware", "firmware.bin"});
  isOver = true;
  cable.join();
  EXPECT_EQ(run.Code, 1);
  EXPECT_NE(run.Errors.find("unplugged"), std::string::npos) << run.Errors;
}

TEST(FalconUdevRule, IsInstalledOnRequest)
{
  const TemporaryFolder folder;
  const std::string script = std::string(PALPATE_SOURCE_DIR) + "/Utilities/install-udev-rule.sh";
  const CommandRun run = RunCommand("sh", {script, "rules"}, folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  const std::string rule = ReadAll(folder / "rules/70-palpate-falcon.rules");
  for (const char* part : {"ATTR{idVendor}==\"0403\"", "ATTR{idProduct}==\"cb48\"",
                           "TAG+=\"uaccess\"", "SUBSYSTEM==\"usb\""})
  {
    EXPECT_NE(rule.find(part), std::string::npos) << part;
  }
  WriteAll(folder / "file", "");
  EXPECT_EQ(RunCommand("sh", {script, "file/rules"}, folder.Path()).Code, 1);
}
} // namespace
} // namespace palpate::test::cli_falcon_test
