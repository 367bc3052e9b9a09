#include "CommandRun.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

using namespace palpate::test;

namespace
{
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

TEST_F(CliSoften, SaysThatALesionLiesOutside)
{
  WriteLesion(this->Folder / "lesion.nii.gz", 40.0);
  const CommandRun run = this->Soften({"--lesion", "lesion.nii.gz", "--lesion-modulus", "60kPa"});
  ASSERT_EQ(run.Code, 0) << run.Errors;
  EXPECT_NE(run.Errors.find("lesion.nii.gz lies outside"), std::string::npos) << run.Errors;
}

TEST_F(CliSoften, ElastographyReplacesTheTissue)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(21, 21, 21);
  image->SetSpacing(2.0, 2.0, 2.0);
  image->SetOrigin(-20.0, -20.0, -20.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  std::fill_n(static_cast<float*>(image->GetScalarPointer()), image->GetNumberOfPoints(), 30.0F);
  palpate::WriteImage(this->Folder / "mre.nii.gz", image);
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

TEST_F(CliSoften, BadInputIsRefusedAndLeavesNothing)
{
  WriteLesion(this->Folder / "lesion.nii.gz", 4.0);
  for (const std::vector<std::string>& more : std::vector<std::vector<std::string>>{
           {"--tissue", "0"},
           {"--tissue", "-20kPa"},
           {"--tissue", "nan"},
           {"--tissue", "1e300"},
           {"--tissue", "soft"},
           {"--poisson", "0.5"},
           {"--poisson", "-0.1"},
           {"--elements", "5"},
           {"--free", "backwards"},
           {"--support", "0"},
           {"--lesion", "lesion.nii.gz"},
           {"--lesion-modulus", "60kPa"},
           {"--lesion", "missing.nii.gz", "--lesion-modulus", "60"},
           {"--lesion", "lesion.nii.gz", "--lesion-modulus", "0"},
           {"--lesion", "lesion.nii.gz", "--lesion-modulus", "60", "--lesion-label", "9"},
           {"--elastography", "missing.nii.gz"},
           {"--output", "soft.coef"}})
  {
    const CommandRun run = this->Soften(more);
    EXPECT_EQ(run.Code, 2) << more.front() << " " << more.back() << ": " << run.Errors;
    EXPECT_EQ(this->Folder.EntryCount(), 2U) << more.back();
  }
}
} // namespace
