#include "ForeignDicom.h"

#include "DicomDataset.h"
#include "FileKind.h"
#include "InputError.h"
#include "Refusal.h"

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dcdeftag.h"
#include "dcmtk/dcmdata/dcitem.h"
#include <algorithm>
#include <array>
#include <vector>

namespace palpate
{
namespace
{
struct Kind
{
  const char* Class; // of the object (PS3.4, B.5), or the beginning of several classes
  const char* Is;
  const char* Remedy;
};

constexpr const char* ToVoxels =
    "convert it to a segmentation on its image's grid (with 3D Slicer: import it, then export "
    "a .seg.nrrd) and use that";
constexpr const char* ToMask = "use a DICOM segmentation, a label map or an image series";

constexpr std::array<Kind, 16> Kinds{{
    {"1.2.840.10008.5.1.4.1.1.481.3",
     "is a DICOM structure set (RTSTRUCT), which has contours but no voxels", ToVoxels},
    {"1.2.840.10008.5.1.4.1.1.481.2",
     "is a DICOM dose (RTDOSE), neither a segmentation nor an image", ToMask},
    {"1.2.840.10008.5.1.4.1.1.481.5", "is a DICOM treatment plan (RTPLAN)", ToMask},
    {"1.2.840.10008.5.1.4.1.1.481.", "is a DICOM radiotherapy object", ToMask},
    {"1.2.840.10008.5.1.4.1.1.66.5",
     "is a DICOM surface segmentation, which has triangles but no voxels", ToVoxels},
    {"1.2.840.10008.5.1.4.1.1.66.1", "is a DICOM registration", ToMask},
    {"1.2.840.10008.5.1.4.1.1.66.2", "has DICOM fiducials", ToMask},
    {"1.2.840.10008.5.1.4.1.1.66.3", "is a DICOM registration", ToMask},
    {"1.2.840.10008.5.1.4.1.1.88.", "is a DICOM report (SR)", ToMask},
    {"1.2.840.10008.5.1.4.1.1.11.", "is a DICOM presentation state", ToMask},
    {"1.2.840.10008.5.1.4.1.1.104.", "is a document within DICOM", ToMask},
    {"1.2.840.10008.5.1.4.1.1.9.", "is a DICOM waveform", ToMask},
    {"1.2.840.10008.5.1.4.1.1.7", "is a DICOM secondary capture, a screen image", ToMask},
    {"1.2.840.10008.5.1.4.1.1.6.", "is a DICOM ultrasound image", ToMask},
    {"1.2.840.10008.5.1.4.1.1.1", "is a DICOM projection image (X-ray)", ToMask},
    {"1.2.840.10008.5.1.4.1.1.12.", "is a DICOM projection image (X-ray)", ToMask},
}};

// The class itself, or a class below it: `key` ends in a dot, or is followed by one.
bool IsOfKind(const std::string& objectClass, const std::string& key)
{
  const bool begins = objectClass.compare(0, key.size(), key) == 0;
  return begins &&
         (key.back() == '.' || objectClass.size() == key.size() || objectClass[key.size()] == '.');
}
} // namespace

std::optional<ForeignDicom> RecognizeForeignDicom(const std::filesystem::path& file)
{
  const DicomDataset dataset(file, DicomDataset::Extent::UpToPixels);
  DcmItem& root = dataset.Root();
  if (root.tagExists(DCM_DirectoryRecordSequence))
  {
    return ForeignDicom{"is the index of a DICOM medium (DICOMDIR)",
                        "specify the folder with the slices of a series"};
  }
  const std::string objectClass = DicomText(root, DCM_SOPClassUID);
  const auto* found =
      std::find_if(Kinds.begin(), Kinds.end(),
                   [&](const Kind& kind) { return IsOfKind(objectClass, kind.Class); });
  if (found != Kinds.end())
  {
    return ForeignDicom{found->Is, found->Remedy};
  }
  const bool isSegmentation = IsOfKind(objectClass, "1.2.840.10008.5.1.4.1.1.66");
  const double frames = DicomNumber(root, DCM_NumberOfFrames, 1.0);
  if (frames > 1.0 && !isSegmentation)
  {
    return ForeignDicom{"is a multi-frame DICOM image, which is not supported",
                        "convert it to one slice per file or to NIfTI-1 (.nii.gz)"};
  }
  return std::nullopt;
}

void RefuseForeignDicom(const std::filesystem::path& file)
{
  if (const std::optional<ForeignDicom> foreign = RecognizeForeignDicom(file))
  {
    Refuse(file, foreign->Is, foreign->Remedy);
  }
}

void RefuseForeignDicomIn(const std::filesystem::path& folder)
{
  for (const std::filesystem::path& file : DicomFilesIn(folder))
  {
    std::optional<ForeignDicom> foreign;
    try
    {
      foreign = RecognizeForeignDicom(file);
    }
    catch (const InputError&)
    {
      continue; // a damaged file is not a foreign one
    }
    if (foreign)
    {
      Refuse(file, foreign->Is, foreign->Remedy);
    }
  }
}
} // namespace palpate
