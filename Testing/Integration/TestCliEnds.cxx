#include "DrillBlock.h"
#include "StartedCommand.h"
#include "SyntheticFiles.h"

#include <algorithm>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

namespace palpate::cli_ends_test
{
namespace
{
using namespace palpate::test;

// Real-time touches, much longer than a test waits, that are ended by signals.
class CliEnds : public testing::Test
{
protected:
  CliEnds() { WriteTwoSpheres(this->Folder / "a.nii.gz"); }

  std::vector<std::string> Touch() const
  {
    return {"touch", "a.nii.gz", "--label",  "1",    "--real-time", "--seconds",
            "600",   "--json",   "--output", "felt", "--stiffness", "100"};
  }
  // Whether this many bytes of a recording were written: the servo runs.
  bool IsRecorded(std::uintmax_t bytes) const
  {
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(this->Folder / "felt", none))
    {
      const std::uintmax_t size = entry.file_size(none);
      if (!none && size > bytes)
      {
        return true;
      }
    }
    return false;
  }
  std::set<std::string> FilesThatAreLeft() const
  {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(this->Folder / "felt"))
    {
      names.insert(entry.path().filename().string());
    }
    return names;
  }
  // All files of a touch that ends by itself, complete, and no temporary ones.
  void ExpectWholeFiles() const
  {
    EXPECT_EQ(this->FilesThatAreLeft(), (std::set<std::string>{"report.html", "scene.json",
                                                               "session.touch", "summary.json"}));
    EXPECT_GT(nlohmann::json::parse(ReadAll(this->Folder / "felt/summary.json"))["ticks"], 0);
    const CommandRun again = RunPalpate(
        {"touch", "felt/scene.json", "--replay", "felt/session.touch"}, this->Folder.Path());
    EXPECT_EQ(again.Code, 0) << again.Output << again.Errors;
    EXPECT_EQ(again.Output.rfind("0 of ", 0), 0U) << again.Output;
  }
  static constexpr std::uintmax_t SomeTicks = 100'000; // bytes

  TemporaryFolder Folder;
};

TEST_F(CliEnds, EachSignalLeavesCompleteFilesAndItsExitCode)
{
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
  {
    StartedCommand command(PALPATE_PROGRAM, this->Touch(), this->Folder.Path());
    ASSERT_TRUE(IsSoon([this] { return this->IsRecorded(SomeTicks); }));
    command.Send(signal);
    const CommandRun run = command.Finish();
    EXPECT_EQ(run.Code, 128 + signal) << run.Errors;
    this->ExpectWholeFiles();
    std::filesystem::remove_all(this->Folder / "felt");
  }
}

TEST_F(CliEnds, SecondCtrlCRemovesForceAndLeavesCompleteFiles)
{
  StartedCommand command(PALPATE_PROGRAM, this->Touch(), this->Folder.Path());
  ASSERT_TRUE(IsSoon([this] { return this->IsRecorded(SomeTicks); }));
  for (int n = 0; n < 2; ++n)
  {
    command.Send(SIGINT);
    ASSERT_TRUE(IsSoon([&] { return command.HasTakenSignals(); }));
  }
  const CommandRun run = command.Finish();
  EXPECT_EQ(run.Code, 130) << run.Errors;
  this->ExpectWholeFiles();
}

// The advice about a stiffness of 100 N/mm is the first unread output.
TEST_F(CliEnds, ClosedStandardErrorLeavesCompleteFiles)
{
  StartedCommand command(PALPATE_PROGRAM, this->Touch(), this->Folder.Path(),
                         StartedCommand::Errors::ReadByNobody);
  const CommandRun run = command.Finish();
  EXPECT_EQ(run.Code, 128 + SIGPIPE);
  this->ExpectWholeFiles();
}

TEST_F(CliEnds, IgnoredSignalsStayIgnored)
{
  std::vector<std::string> words{PALPATE_PROGRAM};
  for (const std::string& word : this->Touch())
  {
    words.push_back(word);
  }
  StartedCommand command("nohup", words, this->Folder.Path());
  ASSERT_TRUE(IsSoon([this] { return this->IsRecorded(SomeTicks); }));
  command.Send(SIGHUP);
  ASSERT_TRUE(IsSoon([this] { return this->IsRecorded(4 * SomeTicks); }));
  command.Send(SIGTERM);
  EXPECT_EQ(command.Finish().Code, 128 + SIGTERM);
  this->ExpectWholeFiles();
}

TEST_F(CliEnds, SignalWritesDrillingDoneSoFar)
{
  const DrillBlock block;
  std::ofstream(this->Folder / "pedal.json") << R"({"format": "palpate-drill",
    "actions": [{"time_s": 0.0, "do": "start"}]})";
  StartedCommand command(PALPATE_PROGRAM,
                         {"touch", block.Scan.string(), "--iso", "750", "--wear", "0.5",
                          "--tool-radius", "1.6", "--drill", "pedal.json", "--real-time",
                          "--seconds", "600", "--output", "felt", "--drilled", "left.nrrd"},
                         this->Folder.Path());
  ASSERT_TRUE(IsSoon([this] { return this->IsRecorded(SomeTicks); }));
  command.Send(SIGINT);
  const CommandRun run = command.Finish();
  EXPECT_EQ(run.Code, 130) << run.Errors;
  EXPECT_TRUE(std::filesystem::exists(this->Folder / "left.nrrd")) << run.Errors;
  EXPECT_EQ(this->FilesThatAreLeft().count("drill.state"), 1U);
  EXPECT_EQ(run.Errors.find("cancelled"), std::string::npos) << run.Errors;
}

// Compressing takes so long that the signal comes while the file is written.
TEST_F(CliEnds, CtrlCInConversionLeavesNoPartialFile)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(256, 256, 200);
  image->AllocateScalars(VTK_UNSIGNED_SHORT, 1);
  auto* voxels = static_cast<unsigned short*>(image->GetScalarPointer());
  std::minstd_rand random;
  std::generate_n(voxels, image->GetNumberOfPoints(),
                  [&random] { return static_cast<unsigned short>(random() % 1024); });
  palpate::WriteImage(this->Folder / "noise.nrrd", image);
  std::filesystem::create_directory(this->Folder / "felt");
  StartedCommand command(PALPATE_PROGRAM, {"convert", "noise.nrrd", "felt/noise.nii.gz"},
                         this->Folder.Path());
  ASSERT_TRUE(IsSoon([this] { return !this->FilesThatAreLeft().empty(); }));
  command.Send(SIGINT);
  EXPECT_EQ(command.Finish().Code, 130);
  EXPECT_EQ(this->FilesThatAreLeft(), (std::set<std::string>{"noise.nii.gz"}));
}
} // namespace
} // namespace palpate::cli_ends_test
