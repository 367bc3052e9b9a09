#include "BadImageFiles.h"
#include "MessageOf.h"
#include "SegmentationFile.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"
#include "WindowTest.h"

#include <QComboBox>

#include <functional>

namespace palpate::bad_files_test
{
namespace
{
using test::BadFile;

// The amount of free memory differs each time.
std::string WithoutFreeMemory(std::string message)
{
  const std::size_t end = message.find(" GB are free");
  if (end != std::string::npos)
  {
    const std::size_t begin = message.rfind(' ', end - 1);
    message.erase(begin, end - begin);
  }
  return message;
}

// Files that the command line rejects, opened by the window's dialogs.
class BadFilesTest : public test::WindowTest
{
protected:
  // The window's message on a file chosen in its dialog.
  std::string SaidOf(const char* action, const std::filesystem::path& file)
  {
    this->Window->Messages()->Clear();
    this->Opened = QStringList{QString::fromStdString(file.string())};
    this->Action(action)->trigger();
    WaitUntil([this] { return !this->Messages().empty(); });
    return this->Messages();
  }
  void ExpectTheReadersMessages(const std::vector<BadFile>& files)
  {
    for (const BadFile& bad : files)
    {
      const auto file = this->Phantom.Folder / bad.Name;
      test::WriteAll(file, bad.Bytes);
      EXPECT_EQ(WithoutFreeMemory(this->SaidOf("Open volume", file)),
                WithoutFreeMemory(test::MessageOf([&] { ReadVolume(file); })));
      EXPECT_EQ(WithoutFreeMemory(this->SaidOf("Open segmentation", file)),
                WithoutFreeMemory(test::MessageOf([&] { ReadSegmentation(file); })));
      this->Action("New study")->trigger();
    }
    this->ExpectTheWindowGoesOn();
  }
  void ExpectTheWindowGoesOn()
  {
    this->OpenPhantom();
    EXPECT_EQ(this->Window->Contents().Surfaces().count(1), 1U);
  }
  // A DICOM folder of two series, of three and of two slices.
  std::filesystem::path TwoSeries()
  {
    const auto folder = this->Phantom.Folder / "dicom";
    std::filesystem::create_directory(folder);
    for (int i = 0; i < 5; ++i)
    {
      test::DicomSliceSpec slice;
      const bool isSecond = i >= 3;
      slice.SeriesUid = isSecond ? "1.2.4" : "1.2.3";
      slice.SeriesNumber = isSecond ? 2 : 1;
      slice.Description = isSecond ? "second" : "first";
      slice.Value = isSecond ? 20 : 10;
      slice.PositionWorld = {0.0, 0.0, 3.0 * i};
      test::WriteDicomSlice(folder / (std::to_string(i) + ".dcm"), slice);
    }
    return folder;
  }
  void OpenFolder(const std::filesystem::path& folder)
  {
    this->Chosen = QString::fromStdString(folder.string());
    this->Action("Open folder")->trigger();
    WaitUntil([this] { return !this->Study->IsBusy(); });
  }
};

TEST_F(BadFilesTest, NiftiMessageEqualsCommandLine)
{
  this->ExpectTheReadersMessages(test::BadNiftiFiles());
}

TEST_F(BadFilesTest, NrrdMessageEqualsCommandLine)
{
  this->ExpectTheReadersMessages(test::BadNrrdFiles());
}

TEST_F(BadFilesTest, OtherFilesMessageEqualsCommandLine)
{
  this->ExpectTheReadersMessages(test::BadOtherFiles());
}

TEST_F(BadFilesTest, DamagedCompressedFileMessageEqualsCommandLine)
{
  this->ExpectTheReadersMessages(test::BadCompressedFiles());
}

TEST_F(BadFilesTest, MaskWithoutLabelsMessageEqualsCommandLine)
{
  const auto odd = this->Phantom.Folder / "odd.nrrd";
  test::WriteAll(odd, test::NrrdOfFloats(1.5F));
  EXPECT_EQ(this->SaidOf("Open segmentation", odd),
            test::MessageOf([&] { ReadSegmentation(odd); }));
  const auto empty = this->Phantom.Folder / "empty.nrrd";
  test::WriteAll(empty,
                 test::NrrdBytes(test::PlainNrrdLines("unsigned char"), std::string(120, '\0')));
  EXPECT_EQ(this->SaidOf("Open segmentation", empty),
            test::MessageOf([&] { ReadSegmentation(empty); }));
  this->ExpectTheWindowGoesOn();
}

TEST_F(BadFilesTest, MissingFileMessageEqualsCommandLine)
{
  const auto gone = this->Phantom.Folder / "gone.nii.gz";
  EXPECT_EQ(this->SaidOf("Open volume", gone), test::MessageOf([&] { ReadVolume(gone); }));
  this->ExpectTheWindowGoesOn();
}

TEST_F(BadFilesTest, LeftHandedFileIsReadUnlessRefused)
{
  const auto file = this->Phantom.Folder / "mirrored.nrrd";
  auto lines = test::PlainNrrdLines("unsigned char");
  lines[4] = "space directions: (2,0,0) (0,-2,0) (0,0,2)";
  test::WriteAll(file, test::NrrdBytes(lines, std::string(120, '\1')));
  auto* choice = this->Window->findChild<QComboBox*>("Left-handed files");
  choice->setCurrentIndex(0);
  Q_EMIT choice->activated(0);
  EXPECT_EQ(this->Study->State().LeftHanded, LeftHandedAxes::Refuse);
  EXPECT_NE(this->SaidOf("Open volume", file).find("left-handed"), std::string::npos);
  EXPECT_EQ(this->Window->Contents().Images()->GetImage(), nullptr);
  EXPECT_TRUE(this->Study->State().VolumeFile.empty());
  choice->setCurrentIndex(1);
  Q_EMIT choice->activated(1);
  this->Action("Open volume")->trigger();
  WaitUntil([this] { return this->Window->Contents().Images()->GetImage() != nullptr; });
  EXPECT_EQ(this->Study->State().LeftHanded, LeftHandedAxes::Reverse);
  EXPECT_NE(this->Messages().find("mirrored.nrrd: The axes were left-handed: index axis 2 was "
                                  "reversed"),
            std::string::npos)
      << this->Messages();
}

TEST_F(BadFilesTest, UserChoosesAmongSeveralSeries)
{
  this->Series = 1;
  this->OpenFolder(this->TwoSeries());
  ASSERT_EQ(this->SeriesOffered.size(), 2);
  EXPECT_TRUE(this->SeriesOffered[1].startsWith("'second' 2 slices"));
  WaitUntil([this] { return this->Window->Contents().Images()->GetImage() != nullptr; });
  EXPECT_EQ(this->Study->State().DicomSeries, "2");
  EXPECT_EQ(this->Window->Contents().Images()->GetImage()->GetDimensions()[2], 2);
  EXPECT_EQ(this->Messages(), "");
}

TEST_F(BadFilesTest, SeriesOfSubfoldersAreOffered)
{
  const auto patient = this->Phantom.Folder / "patient";
  std::filesystem::create_directories(patient / "study");
  std::filesystem::rename(this->TwoSeries(), patient / "study" / "CT");
  this->Series = 0;
  this->OpenFolder(patient);
  ASSERT_EQ(this->SeriesOffered.size(), 2) << this->Messages();
  EXPECT_TRUE(this->SeriesOffered[0].contains("in study/CT"))
      << this->SeriesOffered[0].toStdString();
  WaitUntil([this] { return this->Window->Contents().Images()->GetImage() != nullptr; });
  EXPECT_EQ(this->Study->State().VolumeFile, patient / "study" / "CT");
  EXPECT_EQ(this->Study->State().DicomSeries, "1");
}

TEST_F(BadFilesTest, CancelledSeriesChoiceOpensNothing)
{
  this->Series = -1;
  this->OpenFolder(this->TwoSeries());
  EXPECT_EQ(this->SeriesOffered.size(), 2);
  EXPECT_EQ(this->Study->State(), StudyState());
}

TEST_F(BadFilesTest, SingleSeriesIsOpenedWithoutQuestion)
{
  const auto folder = this->TwoSeries();
  std::filesystem::remove(folder / "3.dcm");
  std::filesystem::remove(folder / "4.dcm");
  this->OpenFolder(folder);
  EXPECT_EQ(this->SeriesOffered.size(), 0);
  WaitUntil([this] { return this->Window->Contents().Images()->GetImage() != nullptr; });
  EXPECT_EQ(this->Study->State().DicomSeries, "");
}

TEST_F(BadFilesTest, FolderWithoutImagesMessageEqualsCommandLine)
{
  const auto folder = this->Phantom.Folder / "bare";
  std::filesystem::create_directory(folder);
  this->OpenFolder(folder);
  EXPECT_EQ(this->Messages(), test::MessageOf([&] { ReadVolume(folder); }));
  EXPECT_EQ(this->Study->State(), StudyState());
}

// Files of every kind that are not what their names say.
TEST_F(BadFilesTest, BadFileBesideGoodWorkChangesNothing)
{
  this->OpenPhantom();
  const StudyState before = this->Study->State();
  const std::string undo = this->Study->Current().History().UndoText();
  const QStringList recent = QSettings().value("recent").toStringList();
  const std::string image = test::ReadAll(this->VolumeFile());
  const std::vector<std::pair<std::string, std::string>> files{
      {"text.nii.gz", "no image"}, {"empty.nrrd", ""},        {"cut.nii.gz", image.substr(0, 300)},
      {"bad.stl", "no surface"},   {"empty.ply", ""},         {"bad.json", "{"},
      {"bad.scene.json", "{}"},    {"bad.palpate.json", "[]"}};
  for (const char* action : {"Open...", "Open volume", "Open segmentation"})
  {
    for (const auto& [name, bytes] : files)
    {
      const auto file = this->Phantom.Folder / name;
      test::WriteAll(file, bytes);
      const std::string said = this->SaidOf(action, file);
      WaitUntil([this] { return !this->Study->IsBusy(); });
      EXPECT_NE(said.find(name), std::string::npos) << said;
      EXPECT_EQ(said.find('\n'), std::string::npos) << said;
      EXPECT_EQ(this->Messages(), said) << "one message";
      EXPECT_EQ(this->Study->State(), before) << action << ": " << name;
      EXPECT_EQ(this->Study->Current().History().UndoText(), undo) << name;
      EXPECT_EQ(QSettings().value("recent").toStringList(), recent) << name;
    }
  }
  EXPECT_EQ(this->Window->Contents().Surfaces().count(1), 1U);
}

TEST_F(BadFilesTest, ReportsUnwritableStudyAndKeepsItOpen)
{
  this->OpenPhantom();
  StudyState before = this->Study->State();
  before.Landmarks.push_back({"apex", Vector3::Zero()});
  this->Study->Change("Mark the apex", before);
  this->SavedTo = "/no/such/folder/case.palpate.json";
  this->Action("Save as")->trigger();
  EXPECT_NE(this->Messages().find("/no/such/folder"), std::string::npos) << this->Messages();
  EXPECT_EQ(this->Study->State(), before);
  EXPECT_TRUE(this->Window->isWindowModified());
}
} // namespace
} // namespace palpate::bad_files_test
