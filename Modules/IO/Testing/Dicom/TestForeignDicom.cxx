#include "ForeignDicom.h"

#include "MessageOf.h"
#include "SegmentationFile.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"

// DCMTK's configuration header must come before its others.
#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dctk.h"
#include <gtest/gtest.h>
#include <vector>

namespace palpate::foreign_dicom_test
{
namespace
{
using namespace palpate::test;

struct Foreign
{
  const char* Class;
  const char* Is;
};

const std::vector<Foreign> Objects{
    {"1.2.840.10008.5.1.4.1.1.66.5",
     "is a DICOM object without pixels (SurfaceSegmentationStorage)"},
    {"1.2.840.10008.5.1.4.1.1.88.33", "(ComprehensiveSRStorage)"},
    {"1.2.840.10008.5.1.4.1.1.104.1", "(EncapsulatedPDFStorage)"},
    {"1.2.3.4", "(an unknown class)"}};

// An object of a class: without pixels, or with this many frames stated, or an index of one record.
void WriteObject(const std::filesystem::path& file, const char* objectClass, int frames = 0,
                 bool isIndex = false)
{
  DcmFileFormat format;
  DcmItem& item = *format.getDataset();
  item.putAndInsertString(DCM_SOPClassUID, objectClass);
  item.putAndInsertString(DCM_SOPInstanceUID, "1.2.3.4.5");
  item.putAndInsertString(DCM_PatientName, "Secret^Patient");
  if (frames > 0)
  {
    item.putAndInsertUint16(DCM_Columns, 4);
    item.putAndInsertString(DCM_NumberOfFrames, std::to_string(frames).c_str());
  }
  DcmItem* record = nullptr;
  if (isIndex && item.findOrCreateSequenceItem(DCM_DirectoryRecordSequence, record, -2).good())
  {
    record->putAndInsertString(DCM_DirectoryRecordType, "PATIENT");
  }
  ASSERT_TRUE(format.saveFile(file.c_str(), EXS_LittleEndianExplicit).good());
}

// One sentence that begins with the file, states its format and the fix, and contains no patient
// data.
void ExpectTold(const std::string& message, const std::filesystem::path& file, const char* is)
{
  EXPECT_EQ(message.rfind(file.string() + " ", 0), 0U) << message;
  EXPECT_TRUE(Contains(message, is));
  EXPECT_TRUE(Contains(message, "; "));
  EXPECT_EQ(message.find("Secret"), std::string::npos);
}

TEST(ForeignDicom, RejectsNamingFormat)
{
  for (const Foreign& object : Objects)
  {
    const TemporaryFolder folder;
    const auto file = folder / "object.dcm";
    WriteObject(file, object.Class);
    ExpectTold(MessageOf([&] { ReadVolume(file); }), file, object.Is);
    ExpectTold(MessageOf([&] { ReadSegmentation(file); }), file, object.Is);
  }
}

TEST(ForeignDicom, IsNamedIfFolderHoldsNothingElse)
{
  const TemporaryFolder folder;
  const auto file = folder / "a.dcm";
  WriteObject(file, Objects.front().Class);
  ExpectTold(MessageOf([&] { ReadVolume(folder.Path()); }), file, Objects.front().Is);
  ExpectTold(MessageOf([&] { ReadSegmentation(folder.Path()); }), file, Objects.front().Is);
}

TEST(ForeignDicom, RejectsSurfacesWithoutReading)
{
  const TemporaryFolder folder;
  WriteObject(folder / "a.dcm", Objects.front().Class);
  EXPECT_TRUE(Contains(MessageOf([&] { ReadSegmentation(folder / "a.dcm"); }),
                       "3D Slicer converts surfaces"));
}

TEST(ForeignDicom, IndexSuggestsSeriesFolder)
{
  const TemporaryFolder folder;
  WriteObject(folder / "DICOMDIR", UID_MediaStorageDirectoryStorage, 0, true);
  ExpectTold(MessageOf([&] { ReadVolume(folder / "DICOMDIR"); }), folder / "DICOMDIR",
             "is the index of a DICOM medium (DICOMDIR)");
}

TEST(ForeignDicom, NamesMultiFrameImages)
{
  const TemporaryFolder folder;
  for (const auto& [objectClass, name] :
       {std::pair("1.2.840.10008.5.1.4.1.1.4.1", "EnhancedMRImageStorage"),
        std::pair("1.2.840.10008.5.1.4.1.1.481.2", "RTDoseStorage")})
  {
    WriteObject(folder / "a.dcm", objectClass, 20);
    const std::string is = "is a multi-frame DICOM image (" + std::string(name) + ")";
    ExpectTold(MessageOf([&] { ReadVolume(folder / "a.dcm"); }), folder / "a.dcm", is.c_str());
  }
}

TEST(ForeignDicom, SlicesAndSegmentationsAreNotForeign)
{
  const TemporaryFolder folder;
  WriteDicomSlice(folder / "slice.dcm", {});
  DicomSegmentationSpec spec;
  spec.Segments = {{1, "gland"}};
  spec.Frames.resize(2);
  WriteDicomSegmentation(folder / "seg.dcm", spec);
  EXPECT_FALSE(RecognizeForeignDicom(folder / "slice.dcm").has_value());
  EXPECT_FALSE(RecognizeForeignDicom(folder / "seg.dcm").has_value());
}
} // namespace
} // namespace palpate::foreign_dicom_test
