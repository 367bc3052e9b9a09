// Messages for typing errors and for structures that cannot be modelled, and progress.
#include "CommandLine.h"
#include "CommandRegistry.h"
#include "CommandRun.h"
#include "Console.h"
#include "ImageWriter.h"
#include "JsonLines.h"
#include "LabelImages.h"
#include "NearestWord.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace palpate::cli_messages_test
{
namespace
{
using namespace palpate::test;

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

// The message for a bad command line.
std::string Refusal(const std::vector<std::string>& words)
{
  const TemporaryFolder folder;
  const CommandRun run = RunPalpate(words, folder.Path());
  EXPECT_EQ(run.Code, 2) << run.Errors;
  EXPECT_EQ(std::count(run.Errors.begin(), run.Errors.end(), '\n'), 1) << run.Errors;
  return run.Errors;
}

// A bowl of label 1, from whose hollow a third of all directions meets nothing, and a sphere of
// label 2.
void WriteBowlAndSphere(const std::filesystem::path& path)
{
  LabelGrid grid;
  grid.Size = {50, 50, 70};
  grid.CenterOnOrigin();
  const auto image = MakeLabelImage(grid,
                                    [](double x, double y, double z)
                                    {
                                      const double radius = std::hypot(x, y, z - 10.0);
                                      return radius > 17.0 && radius < 20.0 && z > 14.0;
                                    });
  auto* voxels = static_cast<unsigned char*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double point[3];
    image->GetPoint(i, point);
    voxels[i] = std::hypot(point[0], point[1], point[2] + 20.0) < 10.0 ? 2 : voxels[i];
  }
  palpate::WriteImage(path, image);
}

void WriteDot(const std::filesystem::path& path)
{
  LabelGrid grid;
  grid.Size = {5, 5, 5};
  palpate::WriteImage(path, MakeLabelImage(grid, [](double x, double y, double z)
                                           { return x == 2.0 && y == 2.0 && z == 2.0; }));
}

// Standard error of a run on a terminal.
std::string OnTerminal(const std::vector<std::string>& words)
{
  std::ostringstream out;
  std::ostringstream err;
  palpate::cli::Console console(out, err, true);
  EXPECT_EQ(palpate::cli::CommandLine(palpate::cli::MakeCommands()).Run(words, console), 0)
      << err.str();
  return err.str();
}

TEST(CliMessages, NamesUnknownCommand)
{
  EXPECT_EQ(Refusal({"nonsense"}), "palpate: unknown command 'nonsense'; see palpate --help\n");
  EXPECT_EQ(Refusal({"fti", "a.nii.gz"}),
            "palpate: unknown command 'fti' (did you mean 'fit'?); see palpate --help\n");
  EXPECT_TRUE(Has(Refusal({"--quiet", "nonsense", "a"}), "'nonsense'"));
}

TEST(CliMessages, UnknownCommandHasNoHelp)
{
  EXPECT_EQ(Refusal({"nonsense", "--help"}),
            "palpate: unknown command 'nonsense'; see palpate --help\n");
}

TEST(CliMessages, UnknownOptionSuggestsNearest)
{
  EXPECT_EQ(
      Refusal({"fit", "a.nii.gz", "--degre", "5"}),
      "palpate: unknown option '--degre' (did you mean '--degree'?); see palpate fit --help\n");
  EXPECT_TRUE(Has(Refusal({"fit", "a.nii.gz", "--degre=5"}), "did you mean '--degree'?"));
  EXPECT_TRUE(Has(Refusal({"fit", "a.nii.gz", "--xyzzy"}), "unknown option '--xyzzy'; see"));
  EXPECT_TRUE(Has(Refusal({"--quite", "info", "a"}), "did you mean '--quiet'?"));
}

// The required option is missing since it is misspelt.
TEST(CliMessages, ReportsMisspeltOptionBeforeMissingOne)
{
  EXPECT_TRUE(Has(Refusal({"mesh", "a.nii.gz", "--ouput", "b.stl"}), "did you mean '--output'?"));
}

TEST(CliMessages, NearestWordDiffersByFewLetters)
{
  const std::vector<std::string> words{"fit", "info", "--degree", "--max-degree"};
  EXPECT_EQ(palpate::cli::NearestWord("ifno", words), "info");
  EXPECT_EQ(palpate::cli::NearestWord("--degrees", words), "--degree");
  EXPECT_EQ(palpate::cli::NearestWord("--maxdegree", words), "--max-degree");
  EXPECT_EQ(palpate::cli::NearestWord("render", words), "");
  EXPECT_EQ(palpate::cli::NearestWord("", words), "");
  EXPECT_EQ(palpate::cli::NearestWord(std::string(10000, 'x'), words), "");
}

TEST(CliMessages, RejectsDivergingModelAndContinues)
{
  const TemporaryFolder folder;
  WriteBowlAndSphere(folder / "a.nii.gz");
  const CommandRun run = RunPalpate({"fit", "a.nii.gz", "--max-hidden", "100", "--min-dice", "0",
                                     "--penalty", "auto", "--degree", "12", "--json"},
                                    folder.Path());
  EXPECT_EQ(run.Code, 1) << run.Errors;
  const auto cases = Lines(run.Output);
  ASSERT_EQ(cases.size(), 2U);
  EXPECT_EQ(cases[0].at("status"), "refused");
  EXPECT_TRUE(Has(cases[0].at("message"), "the model's radius runs from ")) << cases[0];
  EXPECT_EQ(cases[1].at("status"), "fitted") << cases[1];
}

TEST(CliMessages, OneVoxelGivesOneLine)
{
  const TemporaryFolder folder;
  LabelGrid grid;
  grid.Size = {5, 5, 5};
  const auto dots = MakeLabelImage(grid, [](double x, double y, double z)
                                   { return x == 0.0 && (y == 0.0 || y == 4.0) && z == 0.0; });
  palpate::WriteImage(folder / "a.nrrd", dots);
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"fit", "a.nrrd", "--output", "out"}, {"mesh", "a.nrrd", "--output", "a.stl"}})
  {
    const CommandRun run = RunPalpate(words, folder.Path());
    EXPECT_EQ(run.Code, 2);
    EXPECT_EQ(std::count(run.Errors.begin(), run.Errors.end(), '\n'), 1) << run.Errors;
    EXPECT_TRUE(Has(run.Errors, "has only 1 voxel")) << run.Errors;
  }
}

// Each command names its own options.
TEST(CliMessages, OneVoxelGivesOneLineInFieldCommands)
{
  const TemporaryFolder folder;
  WriteDot(folder / "a.nrrd");
  WriteAll(folder / "a.scene.json", "{\"format\": \"palpate-scene\", \"structures\": "
                                    "[{\"file\": \"a.nrrd\", \"label\": 1}]}");
  WriteAll(folder / "a.palpate.json",
           "{\"format\": \"palpate-study\", \"segmentation\": \"a.nrrd\", \"structures\": "
           "[{\"label\": 1, \"degree\": 4}]}");
  for (const std::vector<std::string>& words :
       std::vector<std::vector<std::string>>{{"touch", "a.nrrd"},
                                             {"touch", "a.nrrd", "--representation", "facets"},
                                             {"touch", "a.nrrd", "--representation", "harmonics"},
                                             {"scene", "explain", "a.scene.json"},
                                             {"tradeoff", "a.nrrd"},
                                             {"study", "a.palpate.json"}})
  {
    const CommandRun run = RunPalpate(words, folder.Path());
    EXPECT_NE(run.Code, 0) << words.front();
    EXPECT_EQ(std::count(run.Errors.begin(), run.Errors.end(), '\n'), 1) << run.Errors;
    EXPECT_TRUE(Has(run.Errors, "a.nrrd, label 1 has only 1 voxel")) << run.Errors;
    EXPECT_TRUE(Has(run.Errors, "; choose another structure")) << run.Errors;
    EXPECT_FALSE(Has(run.Errors, " --")) << run.Errors;
  }
}

TEST(CliMessages, SaysThatAThinStructureIsSmoothedLess)
{
  const TemporaryFolder folder;
  LabelGrid grid;
  grid.Size = {20, 20, 20};
  const auto thread =
      MakeLabelImage(grid, [](double, double y, double z) { return y == 10.0 && z == 10.0; });
  palpate::WriteImage(folder / "a.nrrd", thread);
  const CommandRun run = RunPalpate({"touch", "a.nrrd"}, folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_TRUE(Has(run.Output, "voxels only, since it is thin")) << run.Output;
}

TEST(CliMessages, RefusedFitSuggestsCommandOptions)
{
  const TemporaryFolder folder;
  WriteBowlAndSphere(folder / "a.nii.gz");
  const std::string fit =
      RunPalpate({"fit", "a.nii.gz", "--label", "1", "--model", "radial"}, folder.Path()).Errors;
  EXPECT_TRUE(Has(fit, "try --model surface, --center visible, or raise --max-hidden")) << fit;
  WriteAll(folder / "a.palpate.json",
           "{\"format\": \"palpate-study\", \"segmentation\": \"a.nii.gz\", \"structures\": "
           "[{\"label\": 1}], \"fit\": {\"model\": \"radial\"}}");
  WriteAll(folder / "a.scene.json",
           "{\"format\": \"palpate-scene\", \"structures\": [{\"file\": \"a.nii.gz\", \"label\": "
           "1, \"representation\": \"harmonics\"}], \"fit\": {\"model\": \"radial\"}}");
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"touch", "a.scene.json"},
           {"study", "a.palpate.json"},
           {"tradeoff", "a.scene.json", "--seconds", "0.5", "--runs", "1"}})
  {
    const CommandRun run = RunPalpate(words, folder.Path());
    EXPECT_TRUE(Has(run.Errors + run.Output, "is not star-shaped")) << run.Errors << run.Output;
    EXPECT_FALSE(Has(run.Errors + run.Output, "--")) << run.Errors << run.Output;
  }
}

TEST(CliMessages, ProgressNamesCaseAndCount)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const std::string file = (folder / "a.nii.gz").string();
  // Of structures that end together, only the last is drawn.
  const std::string fit = OnTerminal({"fit", file, "--degree", "2", "--jobs", "1"});
  EXPECT_TRUE(Has(fit, "case 1 of 2: label 1: surface")) << fit;
  EXPECT_TRUE(Has(fit, "case 2 of 2: label 2: surface")) << fit;
  const std::string mesh = OnTerminal({"mesh", file, "--output", (folder / "out").string()});
  EXPECT_TRUE(Has(mesh, "case 2 of 2: ")) << mesh;
}

TEST(CliMessages, CohortProgressCountsCases)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "masks");
  for (const char* name : {"10014.nii.gz", "10015.nii.gz", "10016.nii.gz"})
  {
    WriteTwoSpheres(folder / "masks" / name);
  }
  const auto progress = [&folder](const std::string& jobs)
  {
    return OnTerminal({"fit", (folder / "masks").string(), "--label", "1", "--degree", "2",
                       "--jobs", jobs, "--output", (folder / ("out" + jobs)).string()});
  };
  const std::string inOrder = progress("1");
  EXPECT_TRUE(Has(inOrder, "case 2 of 3: 10015")) << inOrder;
  // Of cases that end together, only the last count is drawn, so which is seen depends on time.
  const std::string together = progress("2");
  EXPECT_TRUE(Has(together, " of 3 cases")) << together;
}

TEST(CliMessages, ProgressNamesFile)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  WriteTwoSpheres(folder / "b.nii.gz");
  const std::string fit = OnTerminal(
      {"fit", (folder / "a.nii.gz").string(), (folder / "b.nii.gz").string(), "--degree", "2"});
  EXPECT_TRUE(Has(fit, "file 2 of 2: b.nii.gz, case 1 of 2: label 1: surface")) << fit;
}

TEST(CliMessages, MeshProgressNamesFile)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  WriteTwoSpheres(folder / "b.nii.gz");
  const std::string mesh =
      OnTerminal({"mesh", (folder / "a.nii.gz").string(), (folder / "b.nii.gz").string(), "--label",
                  "1", "--output", (folder / "out").string()});
  EXPECT_TRUE(Has(mesh, "file 2 of 2: b.nii.gz, label 1")) << mesh;
}

TEST(CliMessages, StudyProgressNamesStructureAndCount)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  // Surfaces of this degree take longer than the time between two looks at the progress.
  WriteAll(folder / "a.palpate.json",
           "{\"format\": \"palpate-study\", \"segmentation\": \"a.nii.gz\", "
           "\"fit\": {\"model\": \"surface\", \"degree\": 20}, \"structures\": "
           "[{\"label\": 1, \"name\": \"ball\"}, {\"label\": 2}]}");
  const std::string study = OnTerminal({"study", (folder / "a.palpate.json").string()});
  EXPECT_TRUE(Has(study, "case 1 of 2: ball: ") || Has(study, "case 2 of 2: label 2: ")) << study;
}
} // namespace
} // namespace palpate::cli_messages_test
