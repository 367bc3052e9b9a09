#include "CommandRun.h"
#include "JsonLines.h"
#include "SurfaceFile.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"
#include "TwoVolumes.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

namespace palpate::cli_mesh_test
{
namespace
{
using namespace palpate::test;
using Json = nlohmann::json;

TEST(CliMesh, OneStructureBecomesOneFile)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const CommandRun run = RunPalpate(
      {"mesh", "a.nii.gz", "--label", "1", "--output", "s.stl", "--json"}, folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  const Json result = Json::parse(run.Output);
  const auto surface = palpate::ReadSurface(folder / "s.stl");
  EXPECT_EQ(result.at("triangles").get<vtkIdType>(), surface->GetNumberOfCells());
  EXPECT_EQ(result.at("touches_border"), false);
  EXPECT_EQ(result.at("status"), "written");
  // The default keeps the mask's volume within 2 %.
  const double mask = result.at("volume_ml").at("mask").get<double>();
  EXPECT_NEAR(result.at("volume_ml").at("surface").get<double>(), mask, 0.02 * mask);
}

TEST(CliMesh, EveryStructureBecomesOneFile)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const CommandRun run =
      RunPalpate({"mesh", "a.nii.gz", "--output", "out/deep", "--json"}, folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  const std::vector<Json> results = Lines(run.Output);
  ASSERT_EQ(results.size(), 2u);
  for (const Json& result : results)
  {
    EXPECT_TRUE(std::filesystem::exists(folder / result.at("output").get<std::string>()));
  }
}

TEST(CliMesh, MapOfSeveralVolumesIsChosenByNumber)
{
  const TemporaryFolder folder;
  WriteTwoVolumes(folder / "a.nii");
  const CommandRun refused = RunPalpate({"mesh", "a.nii", "--output", "s.stl"}, folder.Path());
  EXPECT_NE(refused.Code, 0);
  EXPECT_NE(refused.Errors.find("--series"), std::string::npos) << refused.Errors;
  const CommandRun run =
      RunPalpate({"mesh", "a.nii", "--series", "2", "--output", "s.stl", "--json"}, folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  // A ball of 9 mm; its voxels miss it by a hundredth.
  EXPECT_NEAR(Json::parse(run.Output).at("volume_ml").at("mask").get<double>(), 3.054, 0.1);
}

TEST(CliMesh, FailingFileIsReportedAndDoesNotStopOthers)
{
  const TemporaryFolder folder;
  WriteAll(folder / "bad.nii.gz", "no image");
  WriteTwoSpheres(folder / "good.nii.gz");
  const CommandRun run =
      RunPalpate({"mesh", "bad.nii.gz", "good.nii.gz", "--output", "out", "--json"}, folder.Path());
  EXPECT_EQ(run.Code, 1);
  const std::vector<Json> results = Lines(run.Output);
  ASSERT_EQ(results.size(), 3u);
  EXPECT_EQ(results[0].at("status"), "bad-input");
  EXPECT_EQ(results[1].at("status"), "written");
  EXPECT_NE(run.Errors.find("bad.nii.gz"), std::string::npos);
  EXPECT_NE(run.Errors.find("1 of 3"), std::string::npos) << run.Errors;
}

TEST(CliMesh, BadInputIsRefusedAndLeavesNothing)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{
           {"none.nii.gz", "--output", "s.vtp"},
           {"a.nii.gz", "--label", "7", "--output", "s.vtp"},
           {"a.nii.gz", "--output", "s.vtp"},
           {"a.nii.gz", "a.nii.gz", "--output", "s.vtp"},
           {"a.nii.gz", "--label", "1", "--output", "no/s.vtp"},
           {"a.nii.gz", "--component", "x", "--output", "s.vtp"},
           {"a.nii.gz", "--label", "1", "--output", "a.nii.gz/x"}})
  {
    std::vector<std::string> words{"mesh"};
    words.insert(words.end(), more.begin(), more.end());
    const CommandRun run = RunPalpate(words, folder.Path());
    EXPECT_EQ(run.Code, 2) << run.Errors;
    EXPECT_EQ(run.Errors.find('\n'), run.Errors.size() - 1) << run.Errors;
    EXPECT_EQ(folder.EntryCount(), 1u);
  }
}

TEST(CliMesh, OutputOfUnknownEndingIsNoFolder)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  for (const char* name :
       {"liver.msh", "liver.vtu", "liver.usda", "liver.amf", "liver.inp", "liver.feb", "liver.nii"})
  {
    const CommandRun run =
        RunPalpate({"mesh", "a.nii.gz", "--label", "1", "--output", name}, folder.Path());
    EXPECT_EQ(run.Code, 2) << name;
    EXPECT_NE(run.Errors.find("use .vtp, .stl, .ply"), std::string::npos) << run.Errors;
    EXPECT_FALSE(std::filesystem::exists(folder / name)) << name;
  }
  for (const char* command : {"fit", "touch"})
  {
    EXPECT_EQ(RunPalpate({command, "a.nii.gz", "--output", "out.json"}, folder.Path()).Code, 2);
  }
}

TEST(CliMesh, FolderOfMasksIsMeshedUpToBadOnes)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "masks");
  WriteEllipsoid(folder / "masks/a.nii.gz", 12.0, 9.0, 8.0);
  WriteEllipsoid(folder / "masks/b.nii.gz", 0.0, 0.0, 0.0); // empty
  WriteEllipsoid(folder / "masks/c.nii.gz", 9.0, 9.0, 8.0);
  const CommandRun run = RunPalpate({"mesh", "masks", "--output", "out"}, folder.Path());
  EXPECT_EQ(run.Code, 1) << run.Errors;
  EXPECT_NE(run.Errors.find("b.nii.gz"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder / "out/a_1.vtp"));
  EXPECT_TRUE(std::filesystem::exists(folder / "out/c_1.vtp"));
}

TEST(CliMesh, ThresholdMakesStructureOfProbabilities)
{
  const TemporaryFolder folder;
  WriteGradedSphere(folder / "p.nii.gz");
  EXPECT_EQ(RunPalpate({"mesh", "p.nii.gz", "--output", "p.stl"}, folder.Path()).Code, 2);
  const CommandRun run = RunPalpate(
      {"mesh", "p.nii.gz", "--threshold", "0.5", "--output", "p.stl", "--json"}, folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  // A ball of 10 mm in voxels of 1 mm.
  EXPECT_NEAR(Json::parse(run.Output).at("volume_ml").at("mask").get<double>(), 4.189, 0.05);
}
} // namespace
} // namespace palpate::cli_mesh_test
