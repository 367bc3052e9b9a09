#include "CommandRun.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace palpate::cli_anonymous_test
{
namespace
{
// --anonymous: names of inputs, which may be patients', reach no output.

using namespace palpate::test;

const std::string Patient = "Mustermann_Erika_1970";

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

bool NamesPatient(const std::string& text)
{
  return Has(text, "Mustermann") || Has(text, "Erika");
}

class CliAnonymous : public testing::Test
{
protected:
  CliAnonymous()
  {
    WriteTwoSpheres(this->Folder / (Patient + ".nii.gz"));
    WriteTwoSpheres(this->Folder / (Patient + "_t2.nrrd"));
    ModelDocument model{NearlyASphere(), {}};
    model.Provenance.Input = Patient + ".nii.gz";
    model.Provenance.Settings = {{"inclusions", Patient + "_lesion.nii.gz 60 kPa"},
                                 {"degree", "1"}};
    WriteModel(this->Folder / (Patient + ".json"), model);
  }
  // Runs it with and without the option: only without does an output name the patient.
  CommandRun Run(std::vector<std::string> words, const std::string& name = "out") const
  {
    const std::filesystem::path output = this->Folder / name;
    std::filesystem::remove_all(output);
    words.insert(words.end(), {"--output", name});
    const CommandRun named = RunPalpate(words, this->Folder.Path());
    EXPECT_EQ(named.Code, 0) << named.Errors;
    EXPECT_TRUE(IsNamed(named, output)) << words.front();
    std::filesystem::remove_all(output);
    words.emplace_back("--anonymous");
    CommandRun run = RunPalpate(words, this->Folder.Path());
    EXPECT_EQ(run.Code, 0) << run.Errors;
    EXPECT_FALSE(IsNamed(run, output)) << words.front() << run.Output << run.Errors;
    EXPECT_TRUE(std::filesystem::exists(output));
    return run;
  }
  static bool IsNamed(const CommandRun& run, const std::filesystem::path& output)
  {
    bool isNamed = NamesPatient(run.Output) || NamesPatient(run.Errors);
    if (!std::filesystem::is_directory(output))
    {
      return isNamed || NamesPatient(ReadAll(output));
    }
    for (const auto& entry : std::filesystem::recursive_directory_iterator(output))
    {
      isNamed = isNamed || NamesPatient(entry.path().filename().string()) ||
                (entry.is_regular_file() && NamesPatient(ReadAll(entry.path())));
    }
    return isNamed;
  }
  // Two readers' masks of two patients.
  void WriteFolders() const
  {
    for (const char* reader : {"one", "two"})
    {
      std::filesystem::create_directory(this->Folder / reader);
      WriteEllipsoid(this->Folder / reader / (Patient + ".nii.gz"), 14.0, 12.0, 12.0);
      WriteEllipsoid(this->Folder / reader / "Mustermann_Max.nii.gz", 12.0, 12.0, 12.0);
    }
  }

  TemporaryFolder Folder;
};

TEST_F(CliAnonymous, FitOfAMask)
{
  const CommandRun run = this->Run({"fit", Patient + ".nii.gz", "--volume", Patient + "_t2.nrrd",
                                    "--label", "1", "--degree", "4", "--json"});
  EXPECT_TRUE(Has(run.Output, "input-1.nii.gz")) << run.Output;
  const auto model = nlohmann::json::parse(ReadAll(this->Folder / "out/model.json"));
  EXPECT_EQ(model["provenance"]["input"], "input-1.nii.gz");
  EXPECT_TRUE(Has(ReadAll(this->Folder / "out/report.html"), "input-1"));
}

TEST_F(CliAnonymous, FitOfAFolderNumbersCasesAndResumes)
{
  this->WriteFolders();
  std::vector<std::string> fit{"fit", "one", "--label", "1", "--degree", "4"};
  this->Run(fit);
  EXPECT_TRUE(std::filesystem::exists(this->Folder / "out/case-001"));
  EXPECT_TRUE(Has(ReadAll(this->Folder / "out/cohort.csv"), "\ncase-002,"));
  fit.insert(fit.end(), {"--output", "out", "--anonymous"});
  const CommandRun again = RunPalpate(fit, this->Folder.Path());
  EXPECT_TRUE(Has(again.Errors, "2 of 2 cases were done before")) << again.Errors;
}

TEST_F(CliAnonymous, TouchOfMasksModelsAndScenes)
{
  WriteAll(this->Folder / "a.scene.json",
           R"({ "format": "palpate-scene", "structures": [ { "file": ")" + Patient +
               R"(.json" } ] })");
  this->Run({"touch", Patient + ".nii.gz", Patient + ".json", "--seconds", "0.1"});
  this->Run({"touch", Patient + ".json", "--seconds", "0.1", "--json"});
  this->Run({"touch", "a.scene.json", "--seconds", "0.1"});
}

TEST_F(CliAnonymous, TradeoffOfAMask)
{
  this->Run({"tradeoff", Patient + ".nii.gz", "--label", "1", "--seconds", "0.5", "--runs", "1"});
}

TEST_F(CliAnonymous, CompareOfFilesAndFolders)
{
  this->WriteFolders();
  this->Run({"compare", "one/" + Patient + ".nii.gz", "two/Mustermann_Max.nii.gz"});
  const CommandRun run = this->Run({"compare", "one", "two"});
  EXPECT_TRUE(Has(run.Output, "2 pairs")) << run.Output;
  EXPECT_TRUE(Has(ReadAll(this->Folder / "out/comparison.csv"), "\ncase-001,"));
}

TEST_F(CliAnonymous, SoftenForgetsTheModelsOrigin)
{
  this->Run({"soften", Patient + ".json", "--elements", "4", "--degree", "4", "--map-degree", "4",
             "--json"},
            "soft.json");
}

TEST_F(CliAnonymous, EvaluateMeshAndConvert)
{
  const CommandRun values =
      RunPalpate({"evaluate", Patient + ".json", "--json", "--anonymous"}, this->Folder.Path());
  EXPECT_EQ(values.Code, 0) << values.Errors;
  EXPECT_FALSE(NamesPatient(values.Output)) << values.Output;
  this->Run({"mesh", Patient + ".nii.gz", "--json"});
  const CommandRun converted =
      RunPalpate({"convert", Patient + ".json", "copy.json", "--anonymous"}, this->Folder.Path());
  EXPECT_EQ(converted.Code, 0) << converted.Errors;
  EXPECT_FALSE(NamesPatient(ReadAll(this->Folder / "copy.json")));
}

TEST_F(CliAnonymous, MessagesOnBadInputsNameNoFile)
{
  WriteAll(this->Folder / "Mustermann.nii", "no image");
  for (const std::string file : {"Mustermann.nii", "Mustermann_missing.nii"})
  {
    const CommandRun run = RunPalpate({"fit", file, "--json", "--anonymous"}, this->Folder.Path());
    EXPECT_EQ(run.Code, 2);
    EXPECT_TRUE(Has(run.Errors, "input-1.nii")) << run.Errors;
    EXPECT_FALSE(NamesPatient(run.Output + run.Errors)) << run.Output << run.Errors;
  }
}

TEST_F(CliAnonymous, DataBesideAHeaderIsFound)
{
  const std::string header = "NRRD0004\ntype: uint8\ndimension: 3\nspace: "
                             "left-posterior-superior\nsizes: 12 12 12\nspace directions: (1,0,0) "
                             "(0,1,0) (0,0,1)\nencoding: raw\nspace origin: (0,0,0)\ndata file: ";
  std::string voxels(12 * 12 * 12, '\0');
  for (int i = 0; i < 6 * 6 * 6; ++i)
  {
    voxels[static_cast<std::size_t>(3 + i % 6 + 12 * (3 + i / 6 % 6) + 144 * (3 + i / 36))] = 1;
  }
  WriteAll(this->Folder / (Patient + ".raw"), voxels);
  WriteAll(this->Folder / (Patient + ".nhdr"), header + Patient + ".raw\n");
  this->Run({"fit", Patient + ".nhdr", "--degree", "2"});
}

TEST_F(CliAnonymous, RefusesWhatNamesCasesItself)
{
  WriteAll(this->Folder / "table.csv", "case,mask\nErika,a.nii.gz\n");
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"fit", "--manifest", "table.csv", "--output", "out"},
        std::vector<std::string>{"fit", "{id}.nii.gz", "--output", "out"},
        std::vector<std::string>{"compare", "--pairs", "table.csv"},
        std::vector<std::string>{"cohort", "out"}})
  {
    std::vector<std::string> anonymous = words;
    anonymous.emplace_back("--anonymous");
    const CommandRun run = RunPalpate(anonymous, this->Folder.Path());
    EXPECT_EQ(run.Code, 2) << words.front();
    EXPECT_TRUE(Has(run.Errors, "--anonymous")) << run.Errors;
  }
}
} // namespace
} // namespace palpate::cli_anonymous_test
