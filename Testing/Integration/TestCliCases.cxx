#include "CommandRun.h"
#include "ImageWriter.h"
#include "JsonLines.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"
#include "vtkImageData.h"
#include "vtkNew.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <gtest/gtest.h>
#include <set>
#include <sstream>

namespace palpate::cli_cases_test
{
namespace
{
// Interaction of several cases of one run: names, labels, failures, exit codes.

using namespace palpate::test;
using Json = nlohmann::json;

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

// A small box of each of these labels, one after the other along x.
void WriteBoxes(const std::filesystem::path& path, const std::vector<int>& labels, int side = 6)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(static_cast<int>(labels.size()) * (side + 3) + 3, side + 6, side + 6);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), image->GetNumberOfPoints(),
              static_cast<unsigned char>(0));
  for (std::size_t box = 0; box < labels.size(); ++box)
  {
    for (int i = 0; i < side * side * side; ++i)
    {
      const int x = static_cast<int>(box) * (side + 3) + 3 + i % side;
      *static_cast<unsigned char*>(image->GetScalarPointer(
          x, 3 + i / side % side, 3 + i / (side * side))) = static_cast<unsigned char>(labels[box]);
    }
  }
  palpate::WriteImage(path, image);
}

// A 3D Slicer segmentation of boxes with sides of 4 voxels, labelled from 1, with these names.
void WriteNamed(const std::filesystem::path& path, const std::vector<std::string>& names)
{
  const int length = static_cast<int>(names.size()) * 7 + 3;
  std::string voxels(static_cast<std::size_t>(length) * 10 * 10, '\0');
  std::ostringstream header;
  header << "NRRD0004\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: " << length
         << " 10 10\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nkinds: domain domain domain\n"
            "encoding: raw\nspace origin: (0,0,0)\n";
  for (std::size_t n = 0; n < names.size(); ++n)
  {
    const std::string key = "Segment" + std::to_string(n) + "_";
    header << key << "ID:=s" << n << '\n'
           << key << "Name:=" << names[n] << '\n'
           << key << "LabelValue:=" << n + 1 << '\n'
           << key << "Layer:=0\n";
    for (int i = 0; i < 64; ++i)
    {
      const int x = static_cast<int>(n) * 7 + 3 + i % 4;
      voxels[static_cast<std::size_t>(x + length * (3 + i / 4 % 4 + 10 * (3 + i / 16)))] =
          static_cast<char>(n + 1);
    }
  }
  WriteAll(path, header.str() + "\n" + voxels);
}

// A NIfTI file of a thousand million voxels, as a sparse file.
void WriteHuge(const std::filesystem::path& path)
{
  std::string header(352, '\0');
  const auto put = [&header](std::size_t offset, auto value)
  { std::memcpy(header.data() + offset, &value, sizeof value); };
  put(0, std::int32_t{348});
  put(40, std::int16_t{3});
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    put(42 + 2 * axis, std::int16_t{1000});
    put(80 + 4 * axis, 1.0f);
  }
  put(70, std::int16_t{2});
  put(72, std::int16_t{8});
  put(108, 352.0f);
  header.replace(344, 3, "n+1");
  WriteAll(path, header);
  std::filesystem::resize_file(path, 352 + std::uintmax_t{1000000000});
}

// A run under shell limits, such as "-f 20".
CommandRun RunLimited(const std::string& limit, const std::vector<std::string>& words,
                      const std::filesystem::path& folder)
{
  std::string command = "ulimit " + limit + "; exec '" + PALPATE_PROGRAM + "'";
  for (const std::string& word : words)
  {
    command += " " + word;
  }
  return RunCommand("sh", {"-c", command}, folder);
}

std::vector<std::string> FitWords(std::vector<std::string> more)
{
  const std::vector<std::string> fast{"--degree",   "2", "--frequency", "6",
                                      "--min-dice", "0", "--json"};
  more.insert(more.begin(), "fit");
  more.insert(more.end(), fast.begin(), fast.end());
  return more;
}

TEST(CliCases, FilesOfSameNameHaveSeparateResults)
{
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "A");
  std::filesystem::create_directories(folder / "B");
  WriteBoxes(folder / "A/same.nii.gz", {1}, 4);
  WriteBoxes(folder / "B/same.nii.gz", {1}, 8);
  const std::vector<std::string> masks{"A/same.nii.gz", "B/same.nii.gz", "A/same.nii.gz"};
  std::vector<std::string> words = masks;
  words.insert(words.end(), {"--output", "o"});
  const CommandRun fit = RunPalpate(FitWords(words), folder.Path());
  ASSERT_EQ(fit.Code, 0) << fit.Errors;
  const std::vector<Json> fits = Lines(fit.Output);
  ASSERT_EQ(fits.size(), 3U);
  EXPECT_EQ(fits[0].at("folder"), "o/A_same_1");
  EXPECT_EQ(fits[1].at("folder"), "o/B_same_1");
  EXPECT_EQ(fits[2].at("folder"), "o/A_same-2_1");

  words.insert(words.begin(), "mesh");
  words.emplace_back("--json");
  const CommandRun mesh = RunPalpate(words, folder.Path());
  ASSERT_EQ(mesh.Code, 0) << mesh.Errors;
  std::set<std::string> files;
  for (const Json& result : Lines(mesh.Output))
  {
    files.insert(result.at("output").get<std::string>());
  }
  EXPECT_EQ(files, (std::set<std::string>{"o/A_same_1.vtp", "o/B_same_1.vtp", "o/A_same-2_1.vtp"}));
}

TEST(CliCases, PatternNamesCasesByTheirIds)
{
  const TemporaryFolder folder;
  for (const std::string id : {"01", "02"})
  {
    std::filesystem::create_directories(folder / ("seg/sub-" + id + "/anat"));
    WriteBoxes(folder / ("seg/sub-" + id + "/anat/sub-" + id + "_T2w_dseg.nii.gz"), {1});
  }
  const CommandRun run = RunPalpate(
      {"fit", "seg/sub-{id}/anat/sub-{id}_*_dseg.nii.gz", "--output", "out"}, folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_TRUE(std::filesystem::exists(folder / "out/01/1/model.json"));
  EXPECT_TRUE(std::filesystem::exists(folder / "out/02/1/model.json"));
}

TEST(CliCases, PatternWithoutOneFileForEachIdIsRefused)
{
  const TemporaryFolder folder;
  WriteBoxes(folder / "sub-01_T1w.nii.gz", {1});
  WriteBoxes(folder / "sub-01_T2w.nii.gz", {1});
  for (const std::string pattern : {"sub-{id}_*.nii.gz", "sub-{id}_PDw.nii.gz", "{id", "{id}*"})
  {
    const CommandRun run = RunPalpate({"fit", pattern, "--output", "out"}, folder.Path());
    EXPECT_EQ(run.Code, 2) << pattern << ": " << run.Errors;
    EXPECT_EQ(run.Errors.find('\n'), run.Errors.size() - 1) << run.Errors;
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  }
}

TEST(CliCases, NumbersNamesThatCollideWhenCombined)
{
  const TemporaryFolder folder;
  WriteNamed(folder / "a.seg.nrrd", {"2"}); // a, label 1, named 2
  WriteBoxes(folder / "a_1.nii.gz", {2});   // a_1, label 2
  const CommandRun run =
      RunPalpate(FitWords({"a.seg.nrrd", "a_1.nii.gz", "--output", "o"}), folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  EXPECT_EQ(Lines(run.Output).at(0).at("folder"), "o/a_1_2");
  EXPECT_EQ(Lines(run.Output).at(1).at("folder"), "o/a_1_2-2");
}

TEST(CliCases, EveryCommandReadsLeftHandedFilesUnlessRefused)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "plain.nrrd");
  const std::string axis = "space directions: (1,0,0)";
  std::string bytes = ReadAll(folder / "plain.nrrd");
  ASSERT_NE(bytes.find(axis), std::string::npos) << bytes.substr(0, 500);
  WriteAll(folder / "m.nrrd",
           bytes.replace(bytes.find(axis), axis.size(), "space directions: (-1,0,0)"));
  const std::vector<std::vector<std::string>> commands{
      {"info", "m.nrrd"},
      {"fit", "m.nrrd", "--label", "1", "--degree", "2", "--frequency", "6", "--output", "fit"},
      {"fit", "plain.nrrd", "--label", "1", "--degree", "2", "--frequency", "6", "--volume",
       "m.nrrd", "--output", "report"},
      {"mesh", "m.nrrd", "--label", "1", "--output", "m.vtp"},
      {"convert", "m.nrrd", "m.nii.gz"},
      {"convert", "m.nrrd", "one.nii.gz", "--label", "1"},
  };
  for (std::vector<std::string> command : commands)
  {
    command.emplace_back("--refuse-left-handed");
    const CommandRun refused = RunPalpate(command, folder.Path());
    EXPECT_EQ(refused.Code, 2) << command[0];
    EXPECT_TRUE(Has(refused.Errors, "m.nrrd has left-handed directions")) << refused.Errors;
    EXPECT_TRUE(Has(refused.Errors, "without --refuse-left-handed")) << refused.Errors;
    EXPECT_EQ(folder.EntryCount(), 2u) << command[0];
  }
  for (const std::vector<std::string>& command : commands)
  {
    const CommandRun read = RunPalpate(command, folder.Path());
    EXPECT_EQ(read.Code, 0) << command[0] << ": " << read.Errors;
    EXPECT_TRUE(Has(read.Output + read.Errors, "The axes were left-handed") ||
                Has(ReadAll(folder / "report/report.html"), "The axes were left-handed"))
        << command[0] << ": " << read.Output << read.Errors;
  }
}

TEST(CliCases, RejectsInvalidNumbersNamingOption)
{
  const TemporaryFolder folder;
  WriteBoxes(folder / "a.nii.gz", {1});
  const std::vector<std::vector<std::string>> commands{
      {"fit", "a.nii.gz", "--smoothing", "nan"},
      {"fit", "a.nii.gz", "--max-hidden", "nan"},
      {"fit", "a.nii.gz", "--model", "surface", "--penalty", "auto"},
      {"fit", "a.nii.gz", "--model", "surface", "--center", "visible"},
      {"fit", "a.nii.gz", "--model", "spherical"},
      {"fit", "a.nii.gz", "--min-dice", "nan"},
      {"fit", "a.nii.gz", "--degree", "auto", "--tolerance", "inf"},
      {"fit", "a.nii.gz", "--degree", "auto", "--tolerance", "0"},
      {"fit", "a.nii.gz", "--penalty", "nan"},
      {"mesh", "a.nii.gz", "--output", "s.vtp", "--smoothing", "nan"},
      {"render", "a.nii.gz", "--output", "p.png", "--opacity", "nan"},
      {"phantom", "--output", "p", "--spacing", "nan,1,1"},
      {"phantom", "--output", "p", "--noise", "nan"},
      {"phantom", "--output", "p", "--bias", "-inf"},
      {"phantom", "--output", "p", "--oblique", "nan"}};
  for (const std::vector<std::string>& words : commands)
  {
    const CommandRun run = RunPalpate(words, folder.Path());
    const std::string& option = words[words.size() - 2];
    EXPECT_EQ(run.Code, 2) << option;
    EXPECT_TRUE(Has(run.Errors, option)) << run.Errors;
    EXPECT_LT(run.Errors.size(), 160U) << run.Errors;
    EXPECT_EQ(folder.EntryCount(), 1U);
  }
}

TEST(CliCases, LongNamesAreShortened)
{
  const TemporaryFolder folder;
  WriteNamed(folder / "a.seg.nrrd", {std::string(400, 'n'), std::string(400, 'n')});
  const CommandRun fit = RunPalpate(FitWords({"a.seg.nrrd", "--output", "o"}), folder.Path());
  EXPECT_EQ(fit.Code, 0) << fit.Errors;
  std::set<std::string> folders;
  for (const Json& result : Lines(fit.Output))
  {
    folders.insert(result.at("folder").get<std::string>());
  }
  EXPECT_EQ(folders.size(), 2U);
  EXPECT_EQ(RunPalpate({"mesh", "a.seg.nrrd", "--output", "m"}, folder.Path()).Code, 0);
}

TEST(CliCases, UnwritableCaseDoesNotStopOthers)
{
  const TemporaryFolder folder;
  WriteBoxes(folder / "a.nii.gz", {1, 2, 3});
  std::filesystem::create_directories(folder / "o");
  std::filesystem::create_directories(folder / "m/a_1.vtp");
  WriteAll(folder / "o/a_1", "a file in the way");
  const CommandRun fit = RunPalpate(FitWords({"a.nii.gz", "--output", "o"}), folder.Path());
  EXPECT_EQ(fit.Code, 1);
  const std::vector<Json> fits = Lines(fit.Output);
  ASSERT_EQ(fits.size(), 3U);
  EXPECT_EQ(fits[0].at("status"), "failed");
  EXPECT_TRUE(Has(fits[0].at("message").get<std::string>(), "o/a_1"));
  EXPECT_TRUE(fits[0].at("folder").is_null());
  EXPECT_EQ(fits[2].at("status"), "fitted");
  EXPECT_TRUE(std::filesystem::exists(folder / "o/a_3/report.html"));
  EXPECT_TRUE(Has(ReadAll(folder / "o/report.html"), "3 cases, 2 fitted"));

  const CommandRun mesh =
      RunPalpate({"mesh", "a.nii.gz", "--output", "m", "--json"}, folder.Path());
  EXPECT_EQ(mesh.Code, 1);
  EXPECT_EQ(Lines(mesh.Output).at(0).at("status"), "failed");
  EXPECT_TRUE(std::filesystem::exists(folder / "m/a_3.vtp"));
}

TEST(CliCases, RejectsImpossibleOutputFolderBeforeWork)
{
  const TemporaryFolder folder;
  WriteBoxes(folder / "a.nii.gz", {1, 2, 3});
  WriteAll(folder / "file", "in the way");
  for (const char* command : {"fit", "mesh"})
  {
    const CommandRun run =
        RunPalpate({command, "a.nii.gz", "--output", "file/o", "--json"}, folder.Path());
    EXPECT_EQ(run.Code, 2) << command;
    EXPECT_TRUE(Has(run.Errors, "file/o")) << run.Errors;
    EXPECT_EQ(run.Output, "") << "cases were computed before the folder was looked at";
  }
}

TEST(CliCases, BadInputLeavesNoOutputFolder)
{
  const TemporaryFolder folder;
  for (const char* command : {"fit", "mesh"})
  {
    EXPECT_EQ(RunPalpate({command, "missing.nii.gz", "--output", "o"}, folder.Path()).Code, 2);
    EXPECT_EQ(folder.EntryCount(), 0U) << command;
  }
}

TEST(CliCases, RejectsTooFewVoxels)
{
  const TemporaryFolder folder;
  WriteBoxes(folder / "one.nii.gz", {1}, 1);
  for (const auto& [command, output] : {std::pair("fit", "s"), std::pair("mesh", "s.vtp")})
  {
    const CommandRun run =
        RunPalpate({command, "one.nii.gz", "--output", output, "--json"}, folder.Path());
    EXPECT_EQ(run.Code, 2) << command;
    EXPECT_EQ(Json::parse(run.Output).at("status"), "bad-input");
    EXPECT_TRUE(Has(run.Errors, "one.nii.gz, label 1 has only 1 voxel, too few")) << run.Errors;
    EXPECT_EQ(folder.EntryCount(), 1U);
  }
}

TEST(CliCases, LabelMissingInOneFileDoesNotStopOthers)
{
  const TemporaryFolder folder;
  WriteBoxes(folder / "multi.nii.gz", {1, 2});
  WriteBoxes(folder / "box.nii.gz", {3});
  for (const char* command : {"fit", "mesh"})
  {
    const CommandRun run =
        RunPalpate({command, "multi.nii.gz", "box.nii.gz", "--label", "2,3", "--label", "gland",
                    "--output", std::string("o-") + command, "--json"},
                   folder.Path());
    EXPECT_EQ(run.Code, 1);
    int lost = 0;
    int unnamed = 0;
    for (const Json& result : Lines(run.Output))
    {
      const bool isLost = result.at("status") == "bad-input";
      lost += isLost ? 1 : 0;
      unnamed += isLost && result.at("label").is_null() && result.at("name") == "gland" ? 1 : 0;
    }
    EXPECT_EQ(Lines(run.Output).size(), 6U);
    EXPECT_EQ(lost, 4);
    EXPECT_EQ(unnamed, 2);
    EXPECT_TRUE(Has(run.Errors, "multi.nii.gz has no label 3; choose")) << run.Errors;
    EXPECT_TRUE(Has(run.Errors, "4 of 6 cases")) << run.Errors;
  }
}

TEST(CliCases, RemovesFilesOfEarlierFit)
{
  const TemporaryFolder folder;
  WriteBoxes(folder / "a.nii.gz", {1, 2});
  const std::vector<std::string> one{"a.nii.gz", "--label", "1", "--output", "o"};
  ASSERT_EQ(RunPalpate(FitWords(one), folder.Path()).Code, 0);
  WriteAll(folder / "o/mine.txt", "kept");
  std::vector<std::string> refused = one;
  refused.insert(refused.end(), {"--center", "80,80,80", "--model", "radial"});
  EXPECT_EQ(RunPalpate(FitWords(refused), folder.Path()).Code, 1);
  for (const char* file : {"model.json", "model.csv", "model.vtp"})
  {
    EXPECT_FALSE(std::filesystem::exists(folder / "o" / file)) << file;
  }
  EXPECT_TRUE(std::filesystem::exists(folder / "o/report.html"));
  EXPECT_TRUE(std::filesystem::exists(folder / "o/mine.txt"));

  ASSERT_EQ(RunPalpate(FitWords(one), folder.Path()).Code, 0);
  ASSERT_EQ(RunPalpate(FitWords({"a.nii.gz", "--output", "o"}), folder.Path()).Code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "o/model.json"));
  EXPECT_FALSE(std::filesystem::exists(folder / "o/surface.vtp"));
  EXPECT_TRUE(std::filesystem::exists(folder / "o/a_1/model.json"));
}

TEST(CliCases, OverviewListsBadInputs)
{
  const TemporaryFolder folder;
  WriteBoxes(folder / "a.nii.gz", {1});
  WriteAll(folder / "bad.nii.gz", "");
  ASSERT_EQ(RunPalpate(FitWords({"a.nii.gz", "bad.nii.gz", "--output", "o"}), folder.Path()).Code,
            1);
  const std::string page = ReadAll(folder / "o/report.html");
  EXPECT_TRUE(Has(page, "2 cases, 1 fitted"));
  EXPECT_TRUE(Has(page, "bad.nii.gz is empty"));
}

TEST(CliCases, UnsatisfiableOptionsAreBadInput)
{
  const TemporaryFolder folder;
  WriteBoxes(folder / "a.nii.gz", {1});
  const CommandRun fit = RunPalpate({"fit", "a.nii.gz", "--component", "9"}, folder.Path());
  EXPECT_EQ(fit.Code, 2);
  EXPECT_EQ(fit.Errors.find("palpate: a.nii.gz, label 1"), 0U) << fit.Errors;
  EXPECT_EQ(
      RunPalpate({"mesh", "a.nii.gz", "--component", "9", "--output", "s.vtp"}, folder.Path()).Code,
      2);
  const CommandRun info = RunPalpate({"info", "gone.nii", "lost.nii"}, folder.Path());
  EXPECT_EQ(info.Code, 2);
  EXPECT_EQ(RunPalpate({"info", "gone.nii", "a.nii.gz"}, folder.Path()).Code, 1);
}

TEST(CliCases, WarnsIfVolumeMissesStructure)
{
  const TemporaryFolder folder;
  WriteBoxes(folder / "a.nii.gz", {1, 2});
  WriteBoxes(folder / "volume.nii.gz", {1});
  const CommandRun run =
      RunPalpate(FitWords({"a.nii.gz", "--volume", "volume.nii.gz"}), folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  EXPECT_FALSE(Has(Lines(run.Output).at(0).at("notes").dump(), "the volume does not cover"));
  EXPECT_TRUE(Has(Lines(run.Output).at(1).at("notes").dump(), "the volume does not cover"))
      << run.Output;
  EXPECT_TRUE(Has(run.Errors, "a.nii.gz, label 2: the volume does not cover")) << run.Errors;
}

TEST(CliCases, RejectsAmbiguousName)
{
  const TemporaryFolder folder;
  WriteNamed(folder / "a.seg.nrrd", {"One", "One", "Left, lobe"});
  const CommandRun run = RunPalpate(FitWords({"a.seg.nrrd", "--label", "One"}), folder.Path());
  EXPECT_EQ(run.Code, 2);
  EXPECT_TRUE(Has(run.Errors, "has several labels named One; choose one of them by its number: "
                              "1, 2"))
      << run.Errors;
  const CommandRun comma = RunPalpate(
      FitWords({"a.seg.nrrd", "--label", "Left, lobe", "--label", "1,1"}), folder.Path());
  EXPECT_EQ(comma.Code, 0) << comma.Errors;
  ASSERT_EQ(Lines(comma.Output).size(), 2U);
  EXPECT_EQ(Lines(comma.Output)[0].at("name"), "Left, lobe");
}

TEST(CliCases, NamesWithLineBreaksGiveOneLineMessagesAndExactJson)
{
  const TemporaryFolder folder;
  const std::string name = "two\nlines\u202e.nii.gz";
  WriteAll(folder / name, "no image");
  const CommandRun info = RunPalpate({"info", name, "--json"}, folder.Path());
  EXPECT_EQ(std::count(info.Errors.begin(), info.Errors.end(), '\n'), 1) << info.Errors;
  EXPECT_TRUE(Has(info.Errors, "two\\x0alines\\xe2\\x80\\xae.nii.gz")) << info.Errors;
  EXPECT_EQ(Lines(info.Output).at(0).at("input"), name);
  WriteBoxes(folder / "a\nb.nii.gz", {1});
  const CommandRun mesh =
      RunPalpate({"mesh", "a\nb.nii.gz", "--output", "c\nd.vtp"}, folder.Path());
  EXPECT_EQ(mesh.Code, 0) << mesh.Errors;
  EXPECT_EQ(std::count(mesh.Output.begin(), mesh.Output.end(), '\n'), 1) << mesh.Output;
}

TEST(CliCases, FailedWriteLeavesNothing)
{
  const TemporaryFolder folder;
  WriteBoxes(folder / "a.nii.gz", {1});
  std::string command = std::string("ulimit -f 4; trap '' XFSZ; exec '") + PALPATE_PROGRAM + "'";
  for (const std::string& word : FitWords({"a.nii.gz", "--output", "new/o"}))
  {
    command += " " + word;
  }
  const CommandRun run = RunCommand("sh", {"-c", command}, folder.Path());
  EXPECT_NE(run.Code, 0);
  EXPECT_TRUE(Has(run.Errors, "new/o/") && Has(run.Errors, "cannot be written")) << run.Errors;
  EXPECT_FALSE(Has(run.Errors, ".palpate-")) << run.Errors;
  EXPECT_EQ(folder.EntryCount(), 1U) << "the mask alone";
}

TEST(CliCases, NamesCannotControlTerminal)
{
  const TemporaryFolder folder;
  WriteNamed(folder / "a.seg.nrrd", {"red\x1b[31m", std::string(60, 'n') + "END"});
  const CommandRun info = RunPalpate({"info", "a.seg.nrrd"}, folder.Path());
  EXPECT_EQ(info.Code, 0);
  EXPECT_FALSE(Has(info.Output, "\x1b"));
  EXPECT_TRUE(Has(info.Output, "red\\x1b[31m")) << info.Output;
  EXPECT_TRUE(Has(info.Output, "nn\xE2\x80\xA6"));
  EXPECT_FALSE(Has(info.Output, "END"));
  const CommandRun fit = RunPalpate({"fit", "a.seg.nrrd", "--label", "gone"}, folder.Path());
  EXPECT_FALSE(Has(fit.Errors, "\x1b")) << fit.Errors;
}

// Sanitizers need more address space than any limit allows.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST(CliCases, FileNeedingTooMuchMemoryDoesNotStopOthers)
{
  const TemporaryFolder folder;
  WriteHuge(folder / "huge.nii");
  WriteBoxes(folder / "a.nii.gz", {1});
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"info", "huge.nii", "a.nii.gz", "--json"},
           {"mesh", "huge.nii", "a.nii.gz", "--output", "out", "--json"}})
  {
    const CommandRun run = RunLimited("-v 1000000", words, folder.Path());
    EXPECT_EQ(run.Code, 1) << run.Errors;
    const std::vector<Json> results = Lines(run.Output);
    ASSERT_EQ(results.size(), 2U) << words.front() << run.Errors;
    EXPECT_EQ(results[0].at("status"), "failed");
    EXPECT_TRUE(Has(results[0].at("message"), "huge.nii needs more memory than there is"))
        << results[0];
    EXPECT_EQ(results[1].at("input"), "a.nii.gz");
  }
}
#endif

TEST(CliCases, SelfReferencingLinkDoesNotStopOthers)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "s");
  std::filesystem::create_symlink("loop", folder / "s/loop");
  WriteBoxes(folder / "a.nii.gz", {1});
  const CommandRun mesh =
      RunPalpate({"mesh", "s", "a.nii.gz", "--output", "out", "--json"}, folder.Path());
  EXPECT_EQ(mesh.Code, 1);
  const std::vector<Json> results = Lines(mesh.Output);
  ASSERT_EQ(results.size(), 2U) << mesh.Errors;
  EXPECT_EQ(results[1].at("status"), "written");
  const CommandRun info = RunPalpate({"info", "s"}, folder.Path());
  EXPECT_TRUE(Has(info.Errors, "s holds no DICOM file")) << info.Errors;
}

TEST(CliCases, FileSizeLimitIsReported)
{
  const TemporaryFolder folder;
  WriteBoxes(folder / "a.nii.gz", {1});
  const CommandRun run =
      RunLimited("-f 4", FitWords({"a.nii.gz", "--output", "new"}), folder.Path());
  EXPECT_EQ(run.Code, 2) << run.Errors;
  EXPECT_TRUE(Has(run.Errors, "cannot be written")) << run.Errors;
  EXPECT_EQ(folder.EntryCount(), 1U) << "the mask alone";
}

TEST(CliCases, UnwritableFitIsReportedAsJson)
{
  const TemporaryFolder folder;
  WriteBoxes(folder / "a.nii.gz", {1});
  const CommandRun run =
      RunLimited("-f 4; trap '' XFSZ", FitWords({"a.nii.gz", "--output", "new"}), folder.Path());
  EXPECT_EQ(run.Code, 2) << run.Errors;
  const std::vector<Json> results = Lines(run.Output);
  ASSERT_EQ(results.size(), 1U) << run.Output;
  EXPECT_EQ(results[0].at("status"), "bad-input");
  EXPECT_TRUE(Has(results[0].at("message"), "cannot be written")) << results[0];
}

TEST(CliCases, UnwritableTouchStillPrintsSummary)
{
  const TemporaryFolder folder;
  WriteBoxes(folder / "a.nii.gz", {1});
  const CommandRun run = RunLimited(
      "-f 4; trap '' XFSZ", {"touch", "a.nii.gz", "--seconds", "0.2", "--output", "felt", "--json"},
      folder.Path());
  EXPECT_NE(run.Code, 0);
  EXPECT_TRUE(Has(run.Errors, "cannot be written")) << run.Errors;
  EXPECT_GT(Json::parse(run.Output).at("ticks"), 0);
}

TEST(CliCases, TouchNamesItsPageOnlyIfItWasWritten)
{
  const TemporaryFolder folder;
  WriteBoxes(folder / "a.nii.gz", {1});
  const std::vector<std::string> touch{"touch", "a.nii.gz", "--seconds", "0.2", "--output", "felt"};
  const CommandRun full = RunLimited("-f 4; trap '' XFSZ", touch, folder.Path());
  EXPECT_FALSE(std::filesystem::exists(folder / "felt/report.html"));
  EXPECT_TRUE(Has(full.Output, " ticks; ")) << full.Output;
  EXPECT_FALSE(Has(full.Output, "report.html")) << full.Output;
  EXPECT_TRUE(Has(RunPalpate(touch, folder.Path()).Output, "felt/report.html\n"));
}
} // namespace
} // namespace palpate::cli_cases_test
