#include "StudyFile.h"

#include "CommaLocale.h"
#include "InputError.h"
#include "StudyCases.h"
#include "StudyJson.h"
#include "TemporaryFolder.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::study_file_test
{
namespace
{
// The error message for a text that is read as a session.
std::string RefusalOf(const std::string& text)
{
  try
  {
    StudyFromText(text, "/folder", "case.palpate.json");
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return "";
}

class StudyFile : public testing::Test
{
protected:
  test::TemporaryFolder Folder;
  std::filesystem::path Path = Folder / "case.palpate.json";
};

TEST_F(StudyFile, RoundTripsEveryState)
{
  test::Random random(11);
  for (int trial = 0; trial < 200; ++trial)
  {
    const StudyState state = test::RandomStudy(random);
    WriteStudy(this->Path, state);
    ASSERT_EQ(ReadStudy(this->Path), state) << test::ReadAll(this->Path);
  }
  EXPECT_EQ(this->Folder.EntryCount(), 1U) << "no temporary file is left";
}

TEST_F(StudyFile, IsTheSameUnderADecimalComma)
{
  test::Random random(12);
  for (int trial = 0; trial < 50; ++trial)
  {
    const StudyState state = test::RandomStudy(random);
    WriteStudy(this->Path, state);
    const std::string expected = test::ReadAll(this->Path);
    const test::CommaLocale comma(test::CommaLocale::Scope::Streams);
    ASSERT_EQ(ReadStudy(this->Path), state) << expected;
    WriteStudy(this->Path, state);
    ASSERT_EQ(test::ReadAll(this->Path), expected);
  }
}

TEST_F(StudyFile, FolderMayMoveWithItsFiles)
{
  std::filesystem::create_directories(this->Folder / "a/data");
  StudyState state;
  state.VolumeFile = this->Folder / "a/data/t2.nii.gz";
  state.SegmentationFile = this->Folder / "a/mask.nii.gz";
  WriteStudy(this->Folder / "a/case.palpate.json", state);
  const std::string text = test::ReadAll(this->Folder / "a/case.palpate.json");
  EXPECT_EQ(text.find(this->Folder.Path().string()), std::string::npos) << text;
  std::filesystem::rename(this->Folder / "a", this->Folder / "b");
  const StudyState moved = ReadStudy(this->Folder / "b/case.palpate.json");
  EXPECT_EQ(moved.VolumeFile, this->Folder / "b/data/t2.nii.gz");
  EXPECT_EQ(moved.SegmentationFile, this->Folder / "b/mask.nii.gz");
}

TEST_F(StudyFile, MissingFilesAreNamedByTheirRole)
{
  StudyState state;
  state.VolumeFile = this->Folder / "t2.nii.gz";
  state.SegmentationFile = this->Folder / "mask.nii.gz";
  test::WriteAll(state.VolumeFile, "there");
  const auto missing = MissingFiles(state);
  ASSERT_EQ(missing.size(), 1U);
  EXPECT_EQ(missing[0].Role, "segmentation");
  EXPECT_EQ(missing[0].Path, state.SegmentationFile);
  EXPECT_TRUE(MissingFiles({}).empty());
}

TEST_F(StudyFile, MissingFurtherVolumeIsNamedAndRelocated)
{
  StudyState state;
  state.Volumes.resize(1);
  state.Volumes[0].Id = 1;
  state.Volumes[0].File = this->Folder / "adc.nii.gz";
  const auto missing = MissingFiles(state);
  ASSERT_EQ(missing.size(), 1U);
  EXPECT_EQ(missing[0].Role, "volume");
  const auto moved = this->Folder / "elsewhere" / "adc.nii.gz";
  EXPECT_EQ(Relocate(state, missing[0].Path, moved).Volumes[0].File, moved);
}

TEST_F(StudyFile, RelocatesNeighboursOfAMovedFile)
{
  StudyState state;
  state.VolumeFile = this->Folder / "old/t2.nii.gz";
  state.SegmentationFile = this->Folder / "old/masks/1.nii.gz";
  std::filesystem::create_directories(this->Folder / "new/masks");
  test::WriteAll(this->Folder / "new/t2.nii.gz", "there");
  test::WriteAll(this->Folder / "new/masks/1.nii.gz", "there");
  const StudyState moved = Relocate(state, state.VolumeFile, this->Folder / "new/t2.nii.gz");
  EXPECT_EQ(moved.VolumeFile, this->Folder / "new/t2.nii.gz");
  EXPECT_EQ(moved.SegmentationFile, this->Folder / "new/masks/1.nii.gz");
  EXPECT_TRUE(MissingFiles(moved).empty());
}

TEST_F(StudyFile, KeepsExistingFilesWhenRelocating)
{
  StudyState state;
  state.VolumeFile = this->Folder / "t2.nii.gz";
  state.SegmentationFile = this->Folder / "mask.nii.gz";
  test::WriteAll(state.SegmentationFile, "there");
  std::filesystem::create_directories(this->Folder / "new");
  test::WriteAll(this->Folder / "new/mask.nii.gz", "another one");
  const StudyState moved = Relocate(state, state.VolumeFile, this->Folder / "new/t2.nii.gz");
  EXPECT_EQ(moved.SegmentationFile, state.SegmentationFile);
  EXPECT_EQ(moved.VolumeFile, this->Folder / "new/t2.nii.gz");
}

TEST(StudyText, AppearanceIsAutomaticUnlessGiven)
{
  const StudyState state =
      StudyFromText("{\"format\": \"palpate-study\", \"segmentation\": \"mask.nrrd\", "
                    "\"structures\": [{\"label\": 1}, {\"label\": 2, "
                    "\"shown_as\": \"error-map\"}]}",
                    "/", "old");
  ASSERT_EQ(state.Structures.size(), 2U);
  EXPECT_EQ(state.Structures[0].Appearance, SceneAppearance::Automatic);
  EXPECT_EQ(state.Structures[1].Appearance, SceneAppearance::ErrorMap);
}

TEST(StudyText, DistancesOfOlderSessionsAreLines)
{
  for (const char* version : {"1", "2"})
  {
    const StudyState state = StudyFromText(
        std::string(R"({"format": "palpate-study", "version": )") + version +
            R"(, "distances": [{"name": "width", "from_mm": [1, 2, 3], "to_mm": [1, 5, 7]}]})",
        "/", "old");
    ASSERT_EQ(state.Measurements.size(), 1U);
    EXPECT_EQ(state.Measurements[0].Kind, MeasurementKind::Line);
    EXPECT_EQ(state.Measurements[0].Name, "width");
    EXPECT_EQ(ValueOf(state.Measurements[0]), 5.0);
  }
}

TEST(StudyText, RefusesMeasurementsWithoutTheirPoints)
{
  const std::string point = R"({"position_mm": [1, 2, 3]})";
  const auto refusal = [&](const std::string& measurements)
  { return RefusalOf(R"({"format": "palpate-study", )" + measurements + "}"); };
  const std::string angle = R"({"kind": "angle", "points": [)" + point + "]";
  EXPECT_NE(refusal(R"("measurements": [)" + angle + "}]").find("measurements[0]"),
            std::string::npos);
  EXPECT_EQ(refusal(R"("measurements": [)" + angle + R"(, "open": true}])"), "");
  EXPECT_NE(refusal(R"("measurements": [)" + angle + R"(, "open": true}, )" + angle +
                    R"(, "open": true}])")
                .find("two open"),
            std::string::npos);
  EXPECT_NE(refusal(R"("measurements": [{"kind": "area", "points": []}])").find("kind"),
            std::string::npos);
  EXPECT_NE(refusal(R"("distances": [3])").find("distances"), std::string::npos);
  EXPECT_NE(refusal(R"("distances": 3)").find("distances"), std::string::npos);
}

TEST_F(StudyFile, RefusesToWriteWhatWouldNotReopen)
{
  test::WriteAll(this->Path, "old");
  StudyState nan;
  nan.Rate = std::nan("");
  EXPECT_THROW(WriteStudy(this->Path, nan), InputError);
  StudyState far;
  far.Landmarks.push_back({"far", Vector3(1e9, 0.0, 0.0)});
  EXPECT_THROW(WriteStudy(this->Path, far), InputError);
  StudyState relative;
  relative.VolumeFile = "t2.nii.gz";
  EXPECT_THROW(WriteStudy(this->Path, relative), InputError);
  StudyState bytes;
  bytes.Structures.resize(1);
  bytes.Structures[0].Name = "\xFF";
  EXPECT_THROW(WriteStudy(this->Path, bytes), InputError);
  EXPECT_EQ(test::ReadAll(this->Path), "old");
}

TEST(StudyText, RejectsMalformedTextWithThePosition)
{
  const std::string start = "{\"format\": \"palpate-study\"";
  const std::string mask = start + ", \"segmentation\": \"mask.nrrd\"";
  const std::vector<std::pair<std::string, std::string>> cases{
      {"{\n  \"format\": oops\n}", "line 2, column 13"},
      {"", "line 1, column 1"},
      {start, "line 1"},
      {"[]", "study is not an object"},
      {"{}", "\"format\""},
      {start + ", \"rate_hz\": 1e999}", "too large"},
      {start + ", \"version\": 3}", "version 3"},
      {start + ", \"volum\": \"a\"}", "\"volum\""},
      {start + ", \"structures\": {}}", "\"structures\" is not a list"},
      {mask + ", \"structures\": [{\"label\": 1}, {\"degree\": 1.5}]}", "structures[1]"},
      {mask + ", \"structures\": [{\"visible\": 1}]}", "true or false"},
      {start + ", \"scene\": {\"structures\": [{\"label\": \"1\"}]}}", "no file"},
      {start + ", \"tool\": {\"radius_mm\": -1}}", "tool"},
      {start + ", \"fit\": {\"method\": \"other\"}}", "\"method\" of its fit"},
      {start + ", \"landmarks\": [{\"position_mm\": [1, 2]}]}", "landmarks[0]"},
      {start + ", \"placement\": {\"scale\": 0}}", "placement"},
      {start + ", \"volumes\": [{\"id\": 1}]}", "volume without a file"},
      {start + ", \"volumes\": [{\"id\": 0, \"file\": \"a.nrrd\"}]}", "volumes[0]"},
      {start + ", \"volumes\": [{\"id\": 1, \"file\": \"a.nrrd\", \"colors\": \"pink\"}]}",
       "volumes[0]"},
      {start +
           ", \"volumes\": [{\"id\": 1, \"file\": \"a.nrrd\"}, {\"id\": 1, \"file\": \"b.nrrd\"}]}",
       "two volumes of one id"},
      {start + ", \"view\": {\"window\": null}}", "view"}};
  for (const auto& [text, place] : cases)
  {
    const std::string message = RefusalOf(text);
    EXPECT_EQ(message.rfind("case.palpate.json ", 0), 0U) << text << ": " << message;
    EXPECT_NE(message.find(place), std::string::npos) << text << ": " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

// A session truncated or changed at any byte is either refused or read.
TEST(StudyText, DamagedTextIsRejectedOrRead)
{
  test::Random random(5);
  const std::string text = StudyText(test::RandomStudy(random), "/folder", "case.palpate.json");
  for (int trial = 0; trial < 2000; ++trial)
  {
    std::string damaged = text;
    damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
    RefusalOf(damaged);
    RefusalOf(text.substr(0, random() % text.size()));
  }
}

TEST(StudyText, EmptyObjectGivesTheDefaultState)
{
  StudyState expected;
  expected.Fit.Rules = 1; // of files from before there were others
  EXPECT_EQ(StudyFromText("{\"format\": \"palpate-study\"}", "/folder", "case.palpate.json"),
            expected);
}
} // namespace
} // namespace palpate::study_file_test
