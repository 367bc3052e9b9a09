#include "BootStream.h"
#include "FalconTestBed.h"
#include "StartedCommand.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <gtest/gtest.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <sys/wait.h>

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

  TemporaryFolder Folder;
  VirtualFalcon Model{PullingHand()};
  UsbfsFalcon Bus{Model};
  FalconTestBed Bed;
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
