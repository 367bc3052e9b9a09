#include "CommandRun.h"
#include "CsvRecords.h"
#include "ImageWriter.h"
#include "LabelImages.h"
#include "SurfaceFile.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"

#include "vtkPointData.h"

#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>

namespace palpate::cli_relate_test
{
namespace
{
using namespace palpate::test;
using Json = nlohmann::json;

class CliRelate : public testing::Test
{
protected:
  // Balls of 7 mm on one grid, at places of the first axis; the last one ends at the border.
  void WriteOrgans() const
  {
    std::filesystem::create_directory(this->Folder / "masks");
    for (const auto& [name, middle] :
         std::map<std::string, double>{{"liver", 12.0}, {"spleen", 30.0}, {"kidney_left", 60.0}})
    {
      LabelGrid grid;
      grid.Size = {{64, 20, 20}};
      WriteImage(this->Folder / ("masks/" + name + ".nii.gz"),
                 MakeLabelImage(grid, [middle = middle](double x, double y, double z)
                                { return std::hypot(x - middle, y - 9.5, z - 9.5) < 7.0; }));
    }
  }
  Json Relate(std::vector<std::string> words, int code = 0) const
  {
    words.insert(words.begin(), "relate");
    words.emplace_back("--json");
    const CommandRun run = RunPalpate(words, this->Folder.Path());
    EXPECT_EQ(run.Code, code) << run.Errors;
    return run.Output.empty() ? Json() : Json::parse(run.Output);
  }
  static const Json& PairOf(const Json& found, const std::string& one, const std::string& other)
  {
    for (const Json& pair : found.at("pairs"))
    {
      if (pair.at("first") == one && pair.at("second") == other)
      {
        return pair;
      }
    }
    throw std::runtime_error("no pair " + one + ", " + other);
  }

  TemporaryFolder Folder;
};

TEST_F(CliRelate, MasksOfAFolderAreNamedAndMeasured)
{
  this->WriteOrgans();
  const Json found = this->Relate({"masks"});
  ASSERT_EQ(found.at("organs").size(), 3U);
  EXPECT_EQ(found.at("pairs").size(), 3U);
  const Json& pair = PairOf(found, "liver", "spleen");
  EXPECT_EQ(pair.at("relation"), "apart");
  EXPECT_NEAR(pair.at("distance_mm").get<double>(), 4.0, 1.0); // a voxel
  EXPECT_NEAR(pair.at("offset_mm").at(0).get<double>(), 18.0, 0.1);
  EXPECT_EQ(pair.at("side"), "left");
  for (const Json& organ : found.at("organs"))
  {
    EXPECT_EQ(organ.at("cut_by_border"), organ.at("name") == "kidney_left") << organ;
  }
}

TEST_F(CliRelate, CutOfTheBorderIsMeasured)
{
  this->WriteOrgans();
  const Json found = this->Relate({"masks"});
  // A disc 3.5 mm from the middle of the ball.
  const Json& kidney = found.at("organs").at(0);
  EXPECT_EQ(kidney.at("name"), "kidney_left");
  EXPECT_NEAR(kidney.at("cut_mm2").get<double>(), M_PI * (49.0 - 3.5 * 3.5), 15.0);
  EXPECT_EQ(found.at("organs").at(1).at("cut_mm2"), 0.0);
}

TEST_F(CliRelate, ModelsAreRelatedExactly)
{
  this->WriteOrgans();
  ASSERT_EQ(
      RunPalpate({"fit", "masks", "--degree", "6", "--output", "fitted"}, this->Folder.Path()).Code,
      0);
  const Json found = this->Relate({"fitted"});
  ASSERT_EQ(found.at("organs").size(), 3U);
  const Json& pair = PairOf(found, "masks_2_liver", "masks_3_spleen");
  EXPECT_EQ(found.at("organs").at(0).at("kind"), "model");
  EXPECT_NEAR(pair.at("distance_mm").get<double>(), 4.0, 1.0);
}

TEST_F(CliRelate, OneOrganAgainstAllOthers)
{
  this->WriteOrgans();
  const Json found = this->Relate({"masks", "--of", "spleen"});
  ASSERT_EQ(found.at("pairs").size(), 2U);
  for (const Json& pair : found.at("pairs"))
  {
    EXPECT_EQ(pair.at("first"), "spleen");
  }
  EXPECT_EQ(RunPalpate({"relate", "masks", "--of", "heart"}, this->Folder.Path()).Code, 2);
}

TEST_F(CliRelate, FilesHaveEveryOrganAndPair)
{
  this->WriteOrgans();
  this->Relate({"masks", "--output", "out"});
  EXPECT_EQ(CsvRecordsIn(ReadAll(this->Folder / "out/organs.csv")).size(), 3U);
  EXPECT_EQ(CsvRecordsIn(ReadAll(this->Folder / "out/pairs.csv")).size(), 3U);
  EXPECT_EQ(Json::parse(ReadAll(this->Folder / "out/relations.json")).at("pairs").size(), 3U);
  EXPECT_NE(ReadAll(this->Folder / "out/report.html").find("kidney_left"), std::string::npos);
  const auto surface = ReadSurface(this->Folder / "out/surfaces/liver.vtp");
  for (const char* name : {"Thickness", "Distance", "Neighbour"})
  {
    EXPECT_TRUE(surface->GetPointData()->HasArray(name)) << name;
  }
}

TEST_F(CliRelate, OneThatCannotBeReadDoesNotStopTheOthers)
{
  this->WriteOrgans();
  WriteAll(this->Folder / "broken.nii.gz", "no image");
  const Json found =
      this->Relate({"masks/liver.nii.gz", "broken.nii.gz", "masks/spleen.nii.gz"}, 1);
  ASSERT_EQ(found.at("organs").size(), 3U);
  EXPECT_EQ(found.at("pairs").size(), 1U);
  int refused = 0;
  for (const Json& organ : found.at("organs"))
  {
    refused += organ.at("status") == "refused" ? 1 : 0;
  }
  EXPECT_EQ(refused, 1);
}

TEST_F(CliRelate, NamesOfTwoFilesAreToldApart)
{
  this->WriteOrgans();
  std::filesystem::create_directory(this->Folder / "other");
  std::filesystem::copy(this->Folder / "masks/spleen.nii.gz", this->Folder / "other/liver.nii.gz");
  const Json found = this->Relate({"masks/liver.nii.gz", "other/liver.nii.gz"});
  EXPECT_NE(found.at("organs").at(0).at("name"), found.at("organs").at(1).at("name"));
}

TEST_F(CliRelate, IbsiAreaCountsTheStepsOfVoxels)
{
  this->WriteOrgans();
  const auto area = [&](const char* definition)
  {
    const Json found = this->Relate({"masks/liver.nii.gz", "--definition", definition});
    return found.at("organs").at(0).at("shape").at("surface_area_mm2").get<double>();
  };
  const double ball = 4.0 * M_PI * 49.0;
  EXPECT_NEAR(area("subvoxel") / ball, 1.0, 0.02);
  EXPECT_GT(area("ibsi") / ball, 1.05);
}
} // namespace
} // namespace palpate::cli_relate_test
