#include "CommandRun.h"
#include "ModelFile.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace palpate::cli_touch_test
{
namespace
{
using namespace palpate::test;

TEST(CliTouch, SweepsMaskAndWritesForces)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const CommandRun run = RunPalpate(
      {"touch", "a.nii.gz", "--label", "1", "--speed", "200", "--output", "felt", "--json"},
      folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  const nlohmann::json summary = nlohmann::json::parse(run.Output);
  EXPECT_EQ(summary["structures"].size(), 1U);
  EXPECT_GT(summary["touching_percent"].get<double>(), 50.0);
  EXPECT_GT(summary["force_max_n"].get<double>(), 0.1);
  for (const char* name : {"report.html", "summary.json", "scene.json", "session.touch"})
  {
    EXPECT_TRUE(std::filesystem::exists(folder / "felt" / name)) << name;
  }
  const CommandRun again =
      RunPalpate({"touch", "felt/scene.json", "--replay", "felt/session.touch"}, folder.Path());
  EXPECT_EQ(again.Code, 0) << again.Output << again.Errors;
  EXPECT_EQ(again.Output.rfind("0 of ", 0), 0U) << again.Output;
  const CommandRun both =
      RunPalpate({"touch", "felt/scene.json", "--replay", "felt/session.touch", "--seconds", "1"},
                 folder.Path());
  EXPECT_EQ(both.Code, 2);
  EXPECT_NE(both.Errors.find("--seconds excludes --replay"), std::string::npos) << both.Errors;
  const CommandRun device = RunPalpate(
      {"touch", "felt/scene.json", "--device", "replay:felt/session.touch", "--seconds", "0.5"},
      folder.Path());
  EXPECT_EQ(device.Code, 0) << device.Errors;
}

TEST(CliTouch, LinksInPlaceOfItsFilesAreReplacedAndNotFollowed)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const std::vector<std::string> touch{"touch",   "a.nii.gz", "--label",  "1",
                                       "--speed", "200",      "--output", "felt"};
  const CommandRun first = RunPalpate(touch, folder.Path());
  ASSERT_EQ(first.Code, 0) << first.Errors;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "felt"))
  {
    files.push_back(entry.path());
  }
  ASSERT_FALSE(files.empty());
  std::filesystem::create_directory(folder / "victims");
  for (const auto& file : files)
  {
    const std::filesystem::path victim = folder / "victims" / file.filename();
    WriteAll(victim, "untouched");
    std::filesystem::remove(file);
    std::filesystem::create_symlink(victim, file);
  }
  const CommandRun again = RunPalpate(touch, folder.Path());
  ASSERT_EQ(again.Code, 0) << again.Errors;
  for (const auto& file : files)
  {
    EXPECT_FALSE(std::filesystem::is_symlink(file)) << file;
    EXPECT_EQ(ReadAll(folder / "victims" / file.filename()), "untouched") << file;
  }
}

TEST(CliTouch, RecordingHasOneLinePerTick)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  ASSERT_EQ(
      RunPalpate({"touch", "a.nii.gz", "--label", "1", "--seconds", "0.5", "--output", "felt"},
                 folder.Path())
          .Code,
      0);
  const CommandRun run = RunPalpate({"convert", "felt/session.touch", "ticks.csv"}, folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  const std::string text = ReadAll(folder / "ticks.csv");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 501);
  const std::string first = text.substr(0, text.find('\n'));
  const std::string last = text.substr(text.rfind('\n', text.size() - 2) + 1);
  EXPECT_EQ(std::count(first.begin(), first.end(), ','), std::count(last.begin(), last.end(), ','));
  EXPECT_EQ(last.rfind("499,", 0), 0U) << last;
  // Truncated, as by a program that crashed.
  const std::string bytes = ReadAll(folder / "felt/session.touch");
  std::ofstream(folder / "cut.part", std::ios::binary) << bytes.substr(0, bytes.size() - 100);
  const CommandRun cut = RunPalpate({"convert", "cut.part", "cut.csv"}, folder.Path());
  EXPECT_EQ(cut.Code, 0) << cut.Errors;
  EXPECT_NE(cut.Errors.find("left out"), std::string::npos) << cut.Errors;
  EXPECT_EQ(RunPalpate({"convert", "a.nii.gz", "b.csv"}, folder.Path()).Code, 2);
  EXPECT_EQ(RunPalpate({"convert", "cut.part", "b.svg"}, folder.Path()).Code, 2);
}

TEST(CliTouch, WarnsOfHighStiffnessBeforeForcesStart)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const CommandRun run =
      RunPalpate({"touch", "a.nii.gz", "--label", "1", "--stiffness", "40", "--seconds", "0.2"},
                 folder.Path());
  EXPECT_NE(run.Errors.find("40 N/mm"), std::string::npos) << run.Errors;
}

TEST(CliTouch, BadInputIsRefusedAndLeavesNothing)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  for (const std::vector<std::string>& more :
       std::vector<std::vector<std::string>>{{},
                                             {"missing.json"},
                                             {"a.nii.gz", "--label", "77"},
                                             {"a.nii.gz", "--representation", "voxels"},
                                             {"a.nii.gz", "--iso", "1000"},
                                             {"a.nii.gz", "--stiffness", "-1"},
                                             {"a.nii.gz", "--device", "phantom"},
                                             {"a.nii.gz", "--device", "replay"},
                                             {"a.nii.gz", "--path", "missing.csv"},
                                             {"a.nii.gz", "--replay", "a.nii.gz"},
                                             {"a.nii.gz", "--output", "a.nii.gz/felt"},
                                             {"missing.scene.json"}})
  {
    std::vector<std::string> arguments{"touch"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const CommandRun run = RunPalpate(arguments, folder.Path());
    EXPECT_EQ(run.Code, 2) << (more.empty() ? "" : more.back()) << ": " << run.Errors;
    EXPECT_EQ(folder.EntryCount(), 1U);
  }
}

TEST(CliTouch, ModelsHaveNoLabels)
{
  const TemporaryFolder folder;
  ModelDocument document;
  document.Surface = RadialModel(0, {20.0 * std::sqrt(4.0 * M_PI)}, Vector3::Zero());
  WriteModel(folder / "a.json", document);
  const CommandRun run = RunPalpate({"touch", "a.json", "--label", "1"}, folder.Path());
  EXPECT_EQ(run.Code, 2);
  WriteTwoSpheres(folder / "a.nii.gz");
  EXPECT_EQ(RunPalpate({"touch", "a.nii.gz", "a.json", "--label", "1", "--seconds", "0.01"},
                       folder.Path())
                .Code,
            0);
  EXPECT_NE(run.Errors.find("a.json is not taken for a segmentation, so that it has no label 1"),
            std::string::npos)
      << run.Errors;
}

TEST(CliTouch, SceneStatesItsStructuresItself)
{
  const TemporaryFolder folder;
  ModelDocument document;
  document.Surface = RadialModel(0, {20.0 * std::sqrt(4.0 * M_PI)}, Vector3::Zero());
  WriteModel(folder / "a.json", document);
  std::ofstream(folder / "a.scene.json")
      << R"({"format": "palpate-scene", "structures": [{"file": "a.json"}]})";
  const auto touch = [&](const std::string& option, const std::string& value)
  {
    return RunPalpate({"touch", "a.scene.json", "--seconds", "0.01", option, value}, folder.Path());
  };
  for (const auto& [option, value] : std::vector<std::pair<std::string, std::string>>{
           {"--stiffness", "5"}, {"--label", "3"}, {"--mode", "radial"}, {"--tool-radius", "9"}})
  {
    const CommandRun run = touch(option, value);
    EXPECT_EQ(run.Code, 2) << option;
    EXPECT_NE(run.Errors.find(option + " has no effect on a scene; state it in a.scene.json"),
              std::string::npos)
        << run.Errors;
  }
  EXPECT_EQ(touch("--stiffness", "0.50").Code, 0); // the default, as 3D Slicer passes it
  EXPECT_EQ(touch("--rate", "500").Code, 0);
}

TEST(CliDevices, ListsEachDeviceWithItsStatus)
{
  const TemporaryFolder folder;
  const CommandRun run = RunPalpate({"devices"}, folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_NE(run.Output.find("simulated: "), std::string::npos) << run.Output;
  EXPECT_NE(run.Output.find("replay: "), std::string::npos) << run.Output;
  const CommandRun json = RunPalpate({"devices", "--json"}, folder.Path());
  EXPECT_TRUE(
      nlohmann::json::parse(json.Output.substr(0, json.Output.find('\n')))["there"].is_boolean());
}

TEST(CliTouch, FolderOfMasksIsTouchedByFileNamesUpToBadOnes)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "masks");
  WriteEllipsoid(folder / "masks/liver.nii.gz", 12.0, 9.0, 8.0);
  WriteEllipsoid(folder / "masks/none.nii.gz", 0.0, 0.0, 0.0); // empty
  WriteEllipsoid(folder / "masks/spleen.nii.gz", 9.0, 9.0, 8.0);
  WriteAll(folder / "masks/zbroken.nii.gz", "broken");
  const CommandRun run = RunPalpate({"touch", "masks", "--seconds", "0.05"}, folder.Path());
  EXPECT_EQ(run.Code, 1) << run.Errors;
  EXPECT_NE(run.Errors.find("none.nii.gz"), std::string::npos) << run.Errors;
  EXPECT_NE(run.Errors.find("zbroken.nii.gz"), std::string::npos) << run.Errors;
  EXPECT_NE(run.Output.find("liver: "), std::string::npos) << run.Output;
  EXPECT_NE(run.Output.find("spleen: "), std::string::npos) << run.Output;
  EXPECT_EQ(RunPalpate({"touch", "masks/none.nii.gz"}, folder.Path()).Code, 2);
}
} // namespace
} // namespace palpate::cli_touch_test
