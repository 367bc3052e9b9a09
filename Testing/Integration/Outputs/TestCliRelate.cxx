#include "CommandRun.h"
#include "CsvRecords.h"
#include "ImageWriter.h"
#include "LabelImages.h"
#include "SurfaceFile.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
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
  // A tube along z of 10 mm, which the image cuts at both ends, and a ball that it does not cut.
  void WriteTubes() const
  {
    std::filesystem::create_directory(this->Folder / "tubes");
    LabelGrid grid;
    grid.Size = {{36, 20, 80}};
    WriteImage(this->Folder / "tubes/aorta.nii.gz",
               MakeLabelImage(grid, [](double x, double y, double)
                              { return std::hypot(x - 9.3, y - 9.6) < 5.0; }));
    WriteImage(this->Folder / "tubes/node.nii.gz",
               MakeLabelImage(grid, [](double x, double y, double z)
                              { return std::hypot(x - 25.0, y - 9.5, z - 40.0) < 6.0; }));
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

// A near pair's map is on both surfaces; of the organ that is 16 mm away there is none.
TEST_F(CliRelate, MapsOfNearPairsAreInTheSurfaces)
{
  this->WriteOrgans();
  this->Relate({"masks", "--output", "out"});
  const auto liver = ReadSurface(this->Folder / "out/surfaces/liver.vtp");
  const auto spleen = ReadSurface(this->Folder / "out/surfaces/spleen.vtp");
  EXPECT_TRUE(liver->GetPointData()->HasArray("DistanceTo_spleen"));
  EXPECT_FALSE(liver->GetPointData()->HasArray("DistanceTo_kidney_left"));
  vtkDataArray* map = spleen->GetPointData()->GetArray("DistanceTo_liver");
  ASSERT_NE(map, nullptr);
  int near = 0;
  for (vtkIdType i = 0; i < spleen->GetNumberOfPoints(); ++i)
  {
    const double* p = spleen->GetPoint(i);
    const double distance = std::hypot(p[0] - 12.0, p[1] - 9.5, p[2] - 9.5) - 7.0;
    if (const double value = map->GetTuple1(i); std::isfinite(value))
    {
      EXPECT_NEAR(value, distance, 0.5); // of the masks' surfaces
      EXPECT_LE(value, 10.0);
      ++near;
    }
    else
    {
      EXPECT_GT(distance, 9.5);
    }
  }
  EXPECT_GT(near, 100);
}

TEST_F(CliRelate, ThicknessByRaysIsLongerThanBySpheres)
{
  this->WriteOrgans();
  const Json found = this->Relate({"masks", "--thickness", "rays"});
  EXPECT_EQ(found.at("thickness_rule"), "rays");
  const Json& rays = found.at("organs").at(1).at("thickness");
  const Json spheres = this->Relate({"masks"}).at("organs").at(1).at("thickness");
  EXPECT_NEAR(rays.at("median_mm").get<double>(), 14.0, 0.5);
  EXPECT_GT(rays.at("median_mm"), spheres.at("median_mm"));
}

TEST_F(CliRelate, CalibreOfTubesIsWritten)
{
  this->WriteTubes();
  const Json found = this->Relate({"tubes", "--calibre", "--output", "out"});
  const Json& aorta = found.at("organs").at(0).at("calibre");
  EXPECT_EQ(aorta.at("status"), "measured");
  EXPECT_NEAR(aorta.at("length_mm").get<double>(), 80.0, 1.0); // a voxel
  EXPECT_NEAR(aorta.at("median_diameter_mm").get<double>(), 10.0, 0.2);
  EXPECT_EQ(found.at("organs").at(1).at("calibre").at("status"), "refused");
  const std::vector<CsvRecord> table =
      CsvRecordsIn(ReadAll(this->Folder / "out/calibre/aorta.csv"));
  EXPECT_EQ(table.size(), aorta.at("sections").size());
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "out/calibre/node.csv"));
  const std::string axis = ReadAll(this->Folder / "out/calibre/aorta.vtp");
  for (const char* text : {"NumberOfLines=\"1\"", "Name=\"Diameter\"", "Name=\"LeastDiameter\""})
  {
    EXPECT_NE(axis.find(text), std::string::npos) << text;
  }
  EXPECT_NE(ReadAll(this->Folder / "out/report.html").find("Calibre"), std::string::npos);
  EXPECT_FALSE(this->Relate({"tubes"}).at("organs").at(0).contains("calibre"));
}

// Near the ends of a tube of 10 mm, balls reach beyond where the image cuts it at -0.5 mm.
TEST_F(CliRelate, CutsHaveNoThicknessUnlessKept)
{
  this->WriteTubes();
  const auto nearCut = [&](std::vector<std::string> words)
  {
    words.insert(words.begin(), {"tubes", "--output", "out"});
    const Json aorta = this->Relate(words).at("organs").at(0);
    // The surface rounds the edge, of which 0.2 to 0.5 mm belong to the side.
    EXPECT_NEAR(aorta.at("cut_mm2").get<double>(), 2.0 * M_PI * 4.65 * 4.65, 10.0);
    const auto surface = ReadSurface(this->Folder / "out/surfaces/aorta.vtp");
    std::vector<double> found;
    for (vtkIdType i = 0; i < surface->GetNumberOfPoints(); ++i)
    {
      if (const double z = surface->GetPoint(i)[2]; z > 2.0 && z < 3.0)
      {
        found.push_back(surface->GetPointData()->GetArray("Thickness")->GetTuple1(i));
      }
    }
    std::sort(found.begin(), found.end());
    return found.at(found.size() / 2);
  };
  EXPECT_NEAR(nearCut({}), 10.0, 1.0);
  EXPECT_NEAR(nearCut({"--keep-cuts"}), 6.0, 1.0); // a ball that touches both
}

// Two blocks side by side, which the image cuts above: the cut within 1 mm of the other block is
// contact only if it is kept.
TEST_F(CliRelate, CutsHaveNoContactUnlessKept)
{
  std::filesystem::create_directory(this->Folder / "blocks");
  for (const auto& [name, first] : std::map<std::string, double>{{"a", 4.0}, {"b", 20.0}})
  {
    LabelGrid grid;
    grid.Size = {{40, 30, 20}};
    WriteImage(this->Folder / ("blocks/" + name + ".nii.gz"),
               MakeLabelImage(
                   grid, [first = first](double x, double y, double z)
                   { return x >= first && x < first + 16.0 && y > 4.5 && y < 24.5 && z > 8.5; }));
  }
  const auto side = [&](const std::vector<std::string>& words)
  { return this->Relate(words).at("pairs").at(0).at("of_first"); };
  const Json without = side({"blocks"});
  const Json with = side({"blocks", "--keep-cuts"});
  const double strip =
      with.at("contact_mm2").get<double>() - without.at("contact_mm2").get<double>();
  EXPECT_GT(strip, 4.0); // 20 mm long, 1 mm wide, of which the rounded edge is another half
  EXPECT_LT(strip, 20.0);
  EXPECT_GT(without.at("within").at(0).at("area_percent"),
            with.at("within").at(0).at("area_percent"));
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
