#include "CommandRun.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>
#include <utility>

namespace palpate::cli_soften_test
{
namespace
{
using namespace palpate::test;

// A ball of 5 mm on a grid around the model of NearlyASphere, or beside it.
void WriteLesion(const std::filesystem::path& path, double x)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(41, 41, 41);
  image->SetSpacing(1.0, 1.0, 1.0);
  image->SetOrigin(x - 20.0, -18.0, -17.0);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* voxel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double point[3];
    image->GetPoint(i, point);
    voxel[i] = std::hypot(point[0] - x, point[1] - 2.0, point[2] - 3.0) < 5.0 ? 3 : 0;
  }
  palpate::WriteImage(path, image);
}

// Sets the cache folder of the commands that are run, and restores it.
class ChosenCache
{
public:
  explicit ChosenCache(const std::filesystem::path& folder)
  {
    setenv("PALPATE_CACHE_DIR", folder.c_str(), 1);
  }
  ChosenCache(const ChosenCache&) = delete;
  ChosenCache& operator=(const ChosenCache&) = delete;
  ~ChosenCache() { unsetenv("PALPATE_CACHE_DIR"); }
};

// One modulus (kPa) in every voxel of 2 mm, from a corner on.
void WriteElastography(const std::filesystem::path& path, float kilopascal, double corner = -20.0)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(21, 21, 21);
  image->SetSpacing(2.0, 2.0, 2.0);
  image->SetOrigin(corner, corner, corner);
  image->AllocateScalars(VTK_FLOAT, 1);
  std::fill_n(static_cast<float*>(image->GetScalarPointer()), image->GetNumberOfPoints(),
              kilopascal);
  palpate::WriteImage(path, image);
}

class CliSoften : public ::testing::Test
{
protected:
  void SetUp() override { WriteNearlyASphere(this->Folder / "gland.json"); }

  CommandRun Soften(std::vector<std::string> more) const
  {
    std::vector<std::string> arguments{"soften",   "gland.json", "--elements",   "4",
                                       "--degree", "4",          "--map-degree", "6",
                                       "--output", "soft.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunPalpate(arguments, this->Folder.Path());
  }
  double ForceOf(const std::string& model, const std::vector<std::string>& more = {}) const
  {
    std::vector<std::string> arguments{"touch",   model, "--tool-radius", "4", "--depth", "1",
                                       "--scale", "1",   "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const CommandRun run = RunPalpate(arguments, this->Folder.Path());
    EXPECT_EQ(run.Code, 0) << run.Errors;
    return run.Code == 0 ? nlohmann::json::parse(run.Output)["force_max_n"].get<double>() : 0.0;
  }

  // What touch reads of soft.json.
  nlohmann::json Elasticity() const
  {
    return nlohmann::json::parse(ReadAll(this->Folder / "soft.json"))["elasticity"];
  }

  TemporaryFolder Folder;
};

TEST_F(CliSoften, StifferTissuePushesHarder)
{
  ASSERT_EQ(this->Soften({"--tissue", "10kPa"}).Code, 0);
  const double soft = this->ForceOf("soft.json");
  ASSERT_EQ(this->Soften({"--tissue", "20"}).Code, 0);
  const double hard = this->ForceOf("soft.json");
  EXPECT_GT(soft, 0.01);
  // Its bed, which yields too, is the same.
  EXPECT_GT(hard, 1.5 * soft);
  EXPECT_LT(hard, 2.0 * soft);
}

TEST_F(CliSoften, LesionPushesHarder)
{
  WriteLesion(this->Folder / "lesion.nii.gz", 4.0);
  const CommandRun run = this->Soften(
      {"--lesion", "lesion.nii.gz", "--lesion-modulus", "100kPa", "--free", "posterior"});
  ASSERT_EQ(run.Code, 0) << run.Errors;
  EXPECT_EQ(run.Errors, "");
  const double lesion = this->ForceOf("soft.json");
  ASSERT_EQ(this->Soften({"--free", "posterior"}).Code, 0);
  EXPECT_GT(lesion, 1.03 * this->ForceOf("soft.json"));
}

TEST_F(CliSoften, SaysThatALesionOrImageLiesOutsideAndIgnoresIt)
{
  const double nowhere = 40.0; // mm
  WriteLesion(this->Folder / "lesion.nii.gz", nowhere);
  WriteElastography(this->Folder / "off.nii.gz", 60.0F, nowhere);
  WriteElastography(this->Folder / "zero.nii.gz", 0.0F);
  WriteElastography(this->Folder / "negative.nii.gz", -60.0F);
  ASSERT_EQ(this->Soften({}).Code, 0);
  const nlohmann::json plain = this->Elasticity();
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"--lesion", "lesion.nii.gz", "--lesion-modulus", "60kPa"}, "lesion.nii.gz lies outside"},
      {{"--neighbour", "lesion.nii.gz"}, "lesion.nii.gz is not next to"},
      {{"--elastography", "off.nii.gz"}, "off.nii.gz has no moduli within the model"},
      {{"--elastography", "zero.nii.gz"}, "zero.nii.gz has no moduli within the model"},
      {{"--elastography", "negative.nii.gz"}, "negative.nii.gz has no moduli within the model"}};
  for (const auto& [more, note] : cases)
  {
    const CommandRun run = this->Soften(more);
    ASSERT_EQ(run.Code, 0) << run.Errors;
    EXPECT_NE(run.Errors.find(note), std::string::npos) << run.Errors;
    EXPECT_EQ(this->Elasticity(), plain) << note;
  }
}

TEST_F(CliSoften, NeighbourHolds)
{
  WriteLesion(this->Folder / "wall.nii.gz", 18.0); // through the surface, at the left
  ASSERT_EQ(this->Soften({}).Code, 0);
  const nlohmann::json alone = this->Elasticity();
  const std::vector<std::string> wall{"--neighbour", "wall.nii.gz"};
  const CommandRun same = this->Soften(wall);
  ASSERT_EQ(same.Code, 0) << same.Errors;
  EXPECT_EQ(same.Errors, "");
  EXPECT_EQ(this->Elasticity(), alone) << "as stiff as the rest of the support";
  ASSERT_EQ(this->Soften({wall[0], wall[1], "--neighbour-support", "50"}).Code, 0);
  EXPECT_NE(this->Elasticity(), alone);
}

TEST_F(CliSoften, SaysThatALesionLiesMostlyOutside)
{
  const double edge = 12.5; // mm
  WriteLesion(this->Folder / "lesion.nii.gz", edge);
  const CommandRun run = this->Soften({"--lesion", "lesion.nii.gz", "--lesion-modulus", "60kPa"});
  ASSERT_EQ(run.Code, 0) << run.Errors;
  EXPECT_NE(run.Errors.find(" % of lesion.nii.gz lies in the model"), std::string::npos)
      << run.Errors;
}

TEST_F(CliSoften, JsonTellsWhatWasBuilt)
{
  WriteLesion(this->Folder / "lesion.nii.gz", 4.0);
  WriteElastography(this->Folder / "zero.nii.gz", 0.0F);
  const CommandRun run =
      this->Soften({"--lesion", "lesion.nii.gz", "--lesion-modulus", "60kPa", "--free", "posterior",
                    "--elastography", "zero.nii.gz", "--json"});
  ASSERT_EQ(run.Code, 0) << run.Errors;
  const nlohmann::json made = nlohmann::json::parse(run.Output);
  EXPECT_EQ(made["output"], "soft.json");
  EXPECT_EQ(made["tissue_kpa"], 20.0);
  EXPECT_EQ(made["free_sides"], nlohmann::json::array({"posterior"}));
  const nlohmann::json& lesion = made["inclusions"][0];
  EXPECT_EQ(lesion["modulus_kpa"], 60.0);
  EXPECT_NEAR(lesion["volume_ml"].get<double>(), 0.52, 0.05);
  EXPECT_EQ(lesion["inside_ml"], lesion["volume_ml"]);
  EXPECT_EQ(made["built"]["elements_across"], 4);
  EXPECT_EQ(made["built"]["map_degree"], 6);
  EXPECT_GT(made["built"]["unknowns"].get<int>(), 100);
  EXPECT_GT(made["built"]["seconds"].get<double>(), 0.0);
  const nlohmann::json& felt = made["felt"];
  EXPECT_EQ(felt["tool_radius_mm"], 8.0);
  EXPECT_GT(felt["force_min_n"].get<double>(), 0.0);
  EXPECT_LT(felt["force_min_n"].get<double>(), felt["force_median_n"].get<double>());
  EXPECT_LT(felt["force_median_n"].get<double>(), felt["force_max_n"].get<double>());
  ASSERT_EQ(made["warnings"].size(), 1U);
  EXPECT_NE(made["warnings"][0].get<std::string>().find("zero.nii.gz"), std::string::npos);
}

TEST_F(CliSoften, CacheMakesTheSameFileUnlessSwitchedOff)
{
  const ChosenCache cache(this->Folder / "cache");
  const auto isRead = [this](const std::vector<std::string>& more)
  {
    std::vector<std::string> all{"--json"};
    all.insert(all.end(), more.begin(), more.end());
    const CommandRun run = this->Soften(all);
    EXPECT_EQ(run.Code, 0) << run.Errors;
    return nlohmann::json::parse(run.Output)["built"]["from_cache"].get<bool>();
  };
  EXPECT_FALSE(isRead({"--no-cache"}));
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "cache"));
  EXPECT_FALSE(isRead({}));
  const nlohmann::json made = this->Elasticity();
  EXPECT_TRUE(isRead({}));
  EXPECT_EQ(this->Elasticity(), made);
  EXPECT_FALSE(isRead({"--no-cache"}));
  EXPECT_FALSE(isRead({"--tissue", "21"}));
  for (const auto& entry : std::filesystem::directory_iterator(this->Folder / "cache"))
  {
    EXPECT_EQ(ReadAll(entry.path()).find("gland"), std::string::npos) << "no name of a file";
  }
}

TEST_F(CliSoften, ElastographyReplacesTheTissue)
{
  WriteElastography(this->Folder / "mre.nii.gz", 30.0F);
  ASSERT_EQ(this->Soften({"--elastography", "mre.nii.gz"}).Code, 0);
  const double image30 = this->ForceOf("soft.json");
  ASSERT_EQ(this->Soften({"--tissue", "30kPa"}).Code, 0);
  EXPECT_NEAR(image30, this->ForceOf("soft.json"), 1e-3 * image30);
}

TEST_F(CliSoften, TouchRecordsAndReplaysBitForBit)
{
  ASSERT_EQ(this->Soften({}).Code, 0);
  EXPECT_GT(this->ForceOf("soft.json", {"--output", "felt", "--friction", "0.3"}), 0.0);
  const CommandRun again = RunPalpate(
      {"touch", "felt/scene.json", "--replay", "felt/session.touch"}, this->Folder.Path());
  EXPECT_EQ(again.Code, 0) << again.Output << again.Errors;
  EXPECT_EQ(again.Output.rfind("0 of ", 0), 0U) << again.Output;
}

TEST_F(CliSoften, ModelThatYieldsCanBeTouchedAsARigidOne)
{
  ASSERT_EQ(this->Soften({}).Code, 0);
  const std::vector<std::string> rigid{"--representation", "harmonics"};
  EXPECT_EQ(this->ForceOf("soft.json", rigid), this->ForceOf("gland.json", rigid));
  EXPECT_NE(this->ForceOf("soft.json"), this->ForceOf("gland.json"));
}

TEST_F(CliSoften, RefusesWhatCannotYield)
{
  ASSERT_EQ(this->Soften({}).Code, 0);
  const auto touch = [this](const std::vector<std::string>& more)
  {
    std::vector<std::string> arguments{"touch"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunPalpate(arguments, this->Folder.Path());
  };
  const CommandRun point = touch({"soft.json", "--tool-radius", "0"});
  EXPECT_EQ(point.Code, 2);
  EXPECT_NE(point.Errors.find("sphere"), std::string::npos) << point.Errors;
  EXPECT_EQ(touch({"soft.json", "--wear", "0.1"}).Code, 2);
}

TEST_F(CliSoften, RefusesWithTheReason)
{
  palpate::WriteModel(this->Folder / "surface.json",
                      {palpate::SurfaceModel::FromModel(NearlyASphere()), {}});
  std::vector<std::string> afloat{"gland.json", "--free-angle", "170"};
  for (const char* side : {"left", "right"})
  {
    afloat.insert(afloat.end(), {"--free", side});
  }
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"surface.json"}, "surface.json is a surface model"},
      {afloat, "Nothing holds the organ"},
      {{"gland.json", "--elements", "4", "--degree", "4", "--support", "100000"}, "too stiff"}};
  for (const auto& [more, reason] : cases)
  {
    std::vector<std::string> arguments{"soften", "--output", "soft.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const CommandRun run = RunPalpate(arguments, this->Folder.Path());
    EXPECT_EQ(run.Code, 2) << reason;
    EXPECT_NE(run.Errors.find(reason), std::string::npos) << run.Errors;
    EXPECT_EQ(this->Folder.EntryCount(), 2U) << reason;
  }
}

TEST_F(CliSoften, ModelThatYieldsCannotBeDrilled)
{
  ASSERT_EQ(this->Soften({}).Code, 0);
  for (const std::string representation : {"automatic", "elastic"})
  {
    WriteAll(this->Folder / "soft.scene.json",
             R"({"format": "palpate-scene", "tool": {"radius_mm": 4}, "structures": [{"file":
                 "soft.json", "drill": {"wear_mm_per_nm": 0.1}, "representation": ")" +
                 representation + "\"}]}");
    const CommandRun run = RunPalpate({"touch", "soft.scene.json"}, this->Folder.Path());
    EXPECT_EQ(run.Code, 2) << representation;
    EXPECT_NE(run.Errors.find("drilled"), std::string::npos) << run.Errors;
  }
}

TEST_F(CliSoften, BadInputIsRefusedAndLeavesNothing)
{
  WriteLesion(this->Folder / "lesion.nii.gz", 4.0);
  WriteElastography(this->Folder / "empty.nii.gz", 0.0F);
  WriteElastography(this->Folder / "nan.nii.gz", std::numeric_limits<float>::quiet_NaN());
  for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{
           {"--tissue", "0"},
           {"--tissue", "-20kPa"},
           {"--tissue", "nan"},
           {"--tissue", "inf"},
           {"--tissue", "1e9kPa"},
           {"--tissue", "1e300"},
           {"--tissue", "soft"},
           {"--tissue", "kPa"},
           {"--poisson", "0.5"},
           {"--poisson", "nan"},
           {"--poisson", "-0.1"},
           {"--elements", "5"},
           {"--free", "backwards"},
           {"--support", "0"},
           {"--lesion", "lesion.nii.gz"},
           {"--lesion-modulus", "60kPa"},
           {"--lesion", "missing.nii.gz", "--lesion-modulus", "60"},
           {"--lesion", "lesion.nii.gz", "--lesion-modulus", "0"},
           {"--lesion", "lesion.nii.gz", "--lesion-modulus", "1e9"},
           {"--lesion", "lesion.nii.gz", "--lesion-modulus", "60", "--lesion-label", "9"},
           {"--lesion", "empty.nii.gz", "--lesion-modulus", "60"},
           {"--neighbour-support", "2"},
           {"--neighbour", "missing.nii.gz"},
           {"--neighbour", "lesion.nii.gz", "--neighbour-support", "0"},
           {"--neighbour", "lesion.nii.gz", "--neighbour-label", "9"},
           {"--elastography", "missing.nii.gz"},
           {"--elastography", "nan.nii.gz"},
           {"--output", "soft.coef"}})
  {
    const CommandRun run = this->Soften(more);
    EXPECT_EQ(run.Code, 2) << more.front() << " " << more.back() << ": " << run.Errors;
    EXPECT_EQ(this->Folder.EntryCount(), 4U) << more.back();
  }
}
} // namespace
} // namespace palpate::cli_soften_test
