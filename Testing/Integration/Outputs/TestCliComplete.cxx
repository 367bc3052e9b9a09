#include "CommandRun.h"
#include "ModelFile.h"
#include "ModelMeasures.h"
#include "SegmentationFile.h"
#include "ShapePriorFile.h"
#include "SurfaceFile.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace palpate::cli_complete_test
{
namespace
{
using namespace palpate::test;
using Json = nlohmann::json;

class CliComplete : public testing::Test
{
protected:
  // Points of a ball of 9 mm about the origin, as WriteTwoSpheres has it.
  void WriteBall() const
  {
    std::string text = "x,y,z,nx,ny,nz\n";
    for (int n = 0; n < 24; ++n)
    {
      const double z = 9.0 * (2.0 * n - 23.0) / 24.0;
      const double r = std::sqrt(81.0 - z * z);
      const Vector3 point(r * std::cos(2.4 * n), r * std::sin(2.4 * n), z);
      for (int k = 0; k < 6; ++k)
      {
        text += std::to_string(point[k % 3]) + (k < 5 ? "," : "\n");
      }
    }
    WriteAll(this->Folder / "ball.csv", text);
  }
  // Ellipsoids of 8 to 12 mm as a prior.
  CommandRun MakePrior() const
  {
    std::filesystem::create_directory(this->Folder / "masks");
    for (int n = 0; n < 4; ++n)
    {
      WriteEllipsoid(this->Folder / ("masks/patient-" + std::to_string(n) + ".nii.gz"), 8.0 + n,
                     11.0 - n, 9.0 + 0.5 * n);
    }
    return this->Run({"cohort", "out", "--masks", "masks", "--model", "radial", "--min-dice", "0",
                      "--prior", "prior.json"});
  }
  CommandRun Run(const std::vector<std::string>& words) const
  {
    return RunPalpate(words, this->Folder.Path());
  }
  std::string RefusalOf(const std::vector<std::string>& words, int code = 2) const
  {
    const CommandRun run = this->Run(words);
    EXPECT_EQ(run.Code, code) << run.Errors;
    EXPECT_EQ(run.Output, "");
    return run.Errors;
  }

  TemporaryFolder Folder;
};

testing::AssertionResult Says(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos ? testing::AssertionSuccess()
                                              : testing::AssertionFailure() << text;
}

TEST_F(CliComplete, TouchesOfABallBecomeItsModelSurfaceAndMask)
{
  this->WriteBall();
  WriteTwoSpheres(this->Folder / "grid.nii.gz");
  const CommandRun run = this->Run({"complete", "ball.csv", "--sigma", "0.2", "--grid",
                                    "grid.nii.gz", "--output", "out", "--json"});
  ASSERT_EQ(run.Code, 0) << run.Errors;
  const double volume = 4.0 / 3.0 * M_PI * std::pow(9.0, 3);
  const Json found = Json::parse(run.Output);
  EXPECT_EQ(found.at("touches"), 24);
  EXPECT_NEAR(found.at("volume_ml").get<double>(), volume / 1000.0, 0.02);
  EXPECT_LT(found.at("distance_rms_mm").get<double>(), 0.1);
  EXPECT_EQ(found.at("next_mm").size(), 6U);
  const ModelDocument model = ReadModel(this->Folder / "out/model.json");
  EXPECT_EQ(model.Provenance.Input, "ball.csv");
  EXPECT_NEAR(VolumeOf(std::get<RadialModel>(model.Surface)), volume, 20.0);
  const auto surface = ReadSurface(this->Folder / "out/model.vtp");
  vtkDataArray* deviations = surface->GetPointData()->GetArray("StandardDeviation");
  ASSERT_NE(deviations, nullptr);
  EXPECT_GT(deviations->GetRange()[0], 0.3);
  EXPECT_NEAR(deviations->GetRange()[1], found.at("deviation_max_mm").get<double>(), 1e-5);
  // The same voxels as those of the ball from whose image the grid is, but for some at the border.
  const Segmentation mask = ReadSegmentation(this->Folder / "out/mask.nii.gz");
  const Segmentation ball = ReadSegmentation(this->Folder / "grid.nii.gz");
  vtkDataArray* made = mask.Layers[0]->GetPointData()->GetScalars();
  vtkDataArray* wanted = ball.Layers[0]->GetPointData()->GetScalars();
  ASSERT_EQ(made->GetNumberOfTuples(), wanted->GetNumberOfTuples());
  int different = 0;
  for (vtkIdType i = 0; i < made->GetNumberOfTuples(); ++i)
  {
    different += (made->GetTuple1(i) == 1.0) != (wanted->GetTuple1(i) == 1.0) ? 1 : 0;
  }
  EXPECT_LT(different, 40); // of 1,220
  const Json written = Json::parse(ReadAll(this->Folder / "out/completion.json"));
  EXPECT_EQ(written.at("next_mm"), found.at("next_mm"));
}

TEST_F(CliComplete, CohortsMakePriorsThatNameNoPatient)
{
  const CommandRun made = this->MakePrior();
  ASSERT_EQ(made.Code, 0) << made.Errors;
  const OrganPrior prior = ReadOrganPrior(this->Folder / "prior.json");
  EXPECT_EQ(std::get<std::shared_ptr<const ShapePrior>>(prior)->Cases(), 4U);
  EXPECT_EQ(ReadAll(this->Folder / "prior.json").find("patient-"), std::string::npos);
  // Where to touch first, without a touch.
  const CommandRun first =
      this->Run({"complete", "--prior", "prior.json", "--center", "1,2,3", "--json"});
  ASSERT_EQ(first.Code, 0) << first.Errors;
  const Json found = Json::parse(first.Output);
  EXPECT_EQ(found.at("touches"), 0);
  EXPECT_EQ(found.at("prior_cases"), 4);
  for (const Json& place : found.at("next_mm"))
  {
    const std::vector<double> at = place;
    EXPECT_NEAR(std::hypot(at[0] - 1.0, at[1] - 2.0, at[2] - 3.0), 9.5, 2.5);
  }
  // One touch tells the size of a ball, as the group's sizes allow.
  this->WriteBall();
  const CommandRun known = this->Run({"complete", "ball.csv", "--prior", "prior.json"});
  EXPECT_TRUE(Says(known.Output, "4 cases"));
}

TEST_F(CliComplete, PriorsAreOfPatientsAxes)
{
  ASSERT_EQ(this->MakePrior().Code, 0);
  EXPECT_TRUE(Says(this->RefusalOf({"cohort", "out", "--align", "ellipsoid", "--prior", "p.json"}),
                   "leave out --align"));
  EXPECT_TRUE(Says(this->RefusalOf({"cohort", "out", "--prior", "p.json", "--known", "out"}),
                   "--model surface"));
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "p.json"));
}

TEST_F(CliComplete, SurfaceModelsAreCompletedGivenTheOtherOrgan)
{
  ASSERT_EQ(this->MakePrior().Code, 0); // of the other organ, here the same bodies
  ASSERT_EQ(this->Run({"fit", "masks", "--as", "cases", "--model", "surface", "--degree", "4",
                       "--min-dice", "0", "--output", "surfaces"})
                .Code,
            0);
  const CommandRun made =
      this->Run({"cohort", "surfaces", "--prior", "zone.json", "--known", "out"});
  ASSERT_EQ(made.Code, 0) << made.Errors;
  EXPECT_EQ(ReadAll(this->Folder / "zone.json").find("patient-"), std::string::npos);
  const OrganPrior prior = ReadOrganPrior(this->Folder / "zone.json");
  EXPECT_EQ(std::get<std::shared_ptr<const SurfacePrior>>(prior)->Relation->Name, "1")
      << "the known organ's label, whose file has no names";
  this->WriteBall();
  const CommandRun run = this->Run({"complete", "ball.csv", "--prior", "zone.json", "--known",
                                    "masks/patient-1.nii.gz", "--grid", "masks/patient-1.nii.gz",
                                    "--sigma", "0.5", "--output", "done", "--json"});
  ASSERT_EQ(run.Code, 0) << run.Errors;
  const Json found = Json::parse(run.Output);
  EXPECT_EQ(found.at("model"), "surface");
  EXPECT_EQ(found.at("prior_cases"), 4);
  EXPECT_EQ(found.at("known"), "masks/patient-1.nii.gz");
  // The known body's: four cases of equal bodies leave touches of a smaller ball no say.
  EXPECT_NEAR(found.at("volume_ml").get<double>(), 4.0 / 3.0 * M_PI * 9.0 * 10.0 * 9.5 / 1000.0,
              0.15);
  EXPECT_EQ(ReadSurface(this->Folder / "done/model.vtp")
                ->GetPointData()
                ->GetArray("StandardDeviation")
                ->GetNumberOfTuples(),
            4002);
  EXPECT_TRUE(std::filesystem::exists(this->Folder / "done/mask.nii.gz"));
  EXPECT_TRUE(
      Says(this->Run({"complete", "--prior", "zone.json", "--known", "out/patient-2/1/model.json"})
               .Output,
           "touch next"));
  EXPECT_TRUE(Says(this->RefusalOf({"complete", "ball.csv", "--prior", "prior.json", "--known",
                                    "masks/patient-1.nii.gz"}),
                   "no other organ"));
  EXPECT_TRUE(Says(this->RefusalOf({"complete", "ball.csv", "--prior", "zone.json", "--known",
                                    "masks/patient-1.nii.gz", "--center", "0,0,0"}),
                   "--center"));
}

TEST_F(CliComplete, RefusesAnOrganThatIsNotStarShaped)
{
  std::string text = "x,y,z\n";
  for (int n = 0; n < 40; ++n)
  {
    const double radius = n % 2 == 0 ? 10.0 : 30.0; // two balls in each other
    const double z = radius * (n - 19.5) / 20.0;
    const double r = std::sqrt(radius * radius - z * z);
    text += std::to_string(r * std::cos(2.4 * n)) + "," + std::to_string(r * std::sin(2.4 * n)) +
            "," + std::to_string(z) + "\n";
  }
  WriteAll(this->Folder / "two.csv", text);
  EXPECT_TRUE(
      Says(this->RefusalOf({"complete", "two.csv", "--output", "out"}, 1), "not star-shaped"));
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "out"));
}

TEST_F(CliComplete, RefusesWithTheWayOut)
{
  this->WriteBall();
  WriteTwoSpheres(this->Folder / "grid.nii.gz");
  WriteAll(this->Folder / "bad.csv", "x,y\n1,2\n");
  WriteAll(this->Folder / "far.csv", "x,y,z\n1,2,3\n1e7,2,3\n");
  WriteAll(this->Folder / "away.csv", "x,y,z\n90,0,0\n110,0,0\n100,10,0\n100,-10,0\n100,0,10\n");
  WriteAll(this->Folder / "prior.json", "{\"format\": \"palpate shape prior\"}");
  EXPECT_TRUE(Says(this->RefusalOf({"complete"}), "--center"));
  EXPECT_TRUE(Says(this->RefusalOf({"complete", "bad.csv"}), "write a header x,y,z"));
  EXPECT_TRUE(Says(this->RefusalOf({"complete", "far.csv"}), "far.csv: touch 1 is not within"));
  EXPECT_TRUE(Says(this->RefusalOf({"complete", "ball.csv", "--prior", "prior.json"}),
                   "palpate cohort --prior"));
  EXPECT_TRUE(Says(this->RefusalOf({"complete", "ball.csv", "--center", "1,2"}), "--center"));
  EXPECT_TRUE(
      Says(this->RefusalOf({"complete", "ball.csv", "--grid", "grid.nii.gz"}), "give a folder"));
  EXPECT_TRUE(
      Says(this->RefusalOf({"complete", "away.csv", "--grid", "grid.nii.gz", "--output", "out"}),
           "no voxel"));
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "out"));
}
} // namespace
} // namespace palpate::cli_complete_test
