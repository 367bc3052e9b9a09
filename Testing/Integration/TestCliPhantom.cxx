#include "CommandRun.h"
#include "ModelFile.h"
#include "ModelMeasures.h"
#include "ProstateLikeModel.h"
#include "SegmentationFile.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"

#include "vtkImageData.h"
#include "vtkMatrix3x3.h"

#include <cmath>
#include <gtest/gtest.h>
#include <variant>

namespace palpate::cli_phantom_test
{
namespace
{
using namespace palpate::test;

double MaskMilliliters(const std::filesystem::path& file)
{
  const palpate::Segmentation mask = palpate::ReadSegmentation(file);
  vtkImageData* image = mask.Layers.front();
  double voxels = 0.0;
  int size[3];
  image->GetDimensions(size);
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        voxels += image->GetScalarComponentAsDouble(i, j, k, 0);
      }
    }
  }
  const double* spacing = image->GetSpacing();
  return voxels * spacing[0] * spacing[1] * spacing[2] / 1000.0;
}

TEST(CliPhantom, FilesMatchGroundTruth)
{
  for (const char* format : {"nii.gz", "nrrd", "mha"})
  {
    const TemporaryFolder folder;
    const CommandRun run =
        RunPalpate({"phantom", "--output", "p", "--spacing", "2,2,3", "--oblique", "20", "--seed",
                    "5", "--degree", "9", "--format", format},
                   folder.Path());
    EXPECT_EQ(run.Code, 0) << run.Errors;
    const auto truth =
        std::get<palpate::RadialModel>(palpate::ReadModel(folder / "p/truth.json").Surface);
    EXPECT_EQ(truth.Coefficients(),
              palpate::MakeProstateLikeModel(9, 5, palpate::Vector3::Zero()).Coefficients());
    const std::string mask = std::string("p/mask.") + format;
    // Counting voxels of 12 mm^3: a standard deviation of 0.2 %, five of them.
    const double milliliters = VolumeOf(truth) / 1000.0;
    EXPECT_NEAR(MaskMilliliters(folder / mask), milliliters, 0.01 * milliliters);
    const palpate::Volume volume =
        palpate::ReadVolume(folder / (std::string("p/volume.") + format));
    EXPECT_LT(volume.Image->GetDirectionMatrix()->GetElement(2, 2), 0.99);
  }
}

TEST(CliPhantom, UsesBodyOfModelFile)
{
  const TemporaryFolder folder;
  ASSERT_EQ(
      RunPalpate({"phantom", "--output", "a", "--spacing", "3,3,3", "--seed", "9"}, folder.Path())
          .Code,
      0);
  const CommandRun run = RunPalpate(
      {"phantom", "--output", "b", "--spacing", "3,3,3", "--model", "a/truth.json"}, folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_EQ(MaskMilliliters(folder / "a/mask.nii.gz"), MaskMilliliters(folder / "b/mask.nii.gz"));
}

TEST(CliPhantom, WritesNoduleAndLeavesMask)
{
  const TemporaryFolder folder;
  const std::vector<std::string> plain{"phantom", "--output", "p", "--spacing", "1,1,1"};
  std::vector<std::string> withNodule = plain;
  withNodule.insert(withNodule.end(), {"--nodule", "10,2"});
  const CommandRun run = RunPalpate(withNodule, folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_NE(run.Output.find("nodule.nii.gz: 0.5"), std::string::npos) << run.Output;
  // Voxels of 1 mm: five deviations of counting, of 1 mm * sqrt(area / 12) = 5.1 mm^3.
  EXPECT_NEAR(MaskMilliliters(folder / "p/nodule.nii.gz"), M_PI / 6.0, 0.026);
  const double whole = MaskMilliliters(folder / "p/mask.nii.gz");
  ASSERT_EQ(RunPalpate(plain, folder.Path()).Code, 0);
  EXPECT_EQ(MaskMilliliters(folder / "p/mask.nii.gz"), whole);
  EXPECT_FALSE(std::filesystem::exists(folder / "p/nodule.nii.gz")); // it would not be this body's
}

TEST(CliPhantom, SaysWhyNoduleIsRejected)
{
  const TemporaryFolder folder;
  const auto errors = [&folder](const std::vector<std::string>& more)
  {
    std::vector<std::string> arguments{"phantom", "--output", "p", "--spacing", "2,2,2"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const CommandRun run = RunPalpate(arguments, folder.Path());
    EXPECT_EQ(run.Code, 2) << more.back();
    EXPECT_EQ(folder.EntryCount(), 0U) << more.back();
    return run.Errors;
  };
  EXPECT_NE(errors({"--nodule", "60,2"}).find("is not inside the body"), std::string::npos);
  EXPECT_NE(errors({"--nodule", "0.1,2.3"}).find("between the voxels"), std::string::npos);
  EXPECT_NE(errors({"--nodule", "0,2"}).find("has to be positive"), std::string::npos);
  for (const char* bad : {"8", "8,2,1", "-8,2", "8,-2", "nan,2", "8,inf"})
  {
    EXPECT_NE(errors({"--nodule", bad}).find("--nodule"), std::string::npos) << bad;
  }
  EXPECT_NE(errors({"--nodule", "8,2", "--nodule", "4,2"}).find("--nodule"), std::string::npos);
}

TEST(CliPhantom, RejectsInvalidSettingsAndLeavesNothing)
{
  const TemporaryFolder folder;
  WriteAll(folder / "file", "in the way");
  for (const std::vector<std::string>& more :
       std::vector<std::vector<std::string>>{{"--spacing", "0,1,1"},
                                             {"--spacing", "1,1"},
                                             {"--bias", "1.5"},
                                             {"--noise", "-1"},
                                             {"--size", "90000,90000,90000"},
                                             {"--model", "missing.json"},
                                             {"--output", "file"}})
  {
    std::vector<std::string> arguments{"phantom"};
    if (more.front() != "--output")
    {
      arguments.insert(arguments.end(), {"--output", "p"});
    }
    arguments.insert(arguments.end(), more.begin(), more.end());
    const CommandRun run = RunPalpate(arguments, folder.Path());
    EXPECT_EQ(run.Code, 2) << more.front() << " " << run.Errors;
    EXPECT_FALSE(run.Errors.empty());
    EXPECT_EQ(folder.EntryCount(), 1U) << more.front();
  }
}

TEST(CliPhantom, RejectsFolderNamedLikeAFile)
{
  const TemporaryFolder folder;
  const CommandRun run = RunPalpate({"phantom", "--output", "p.msh"}, folder.Path());
  EXPECT_EQ(run.Code, 2);
  EXPECT_NE(run.Errors.find("has the ending of a file"), std::string::npos) << run.Errors;
}
} // namespace
} // namespace palpate::cli_phantom_test
