#include "ForeignDicom.h"

#include "DicomDataset.h"
#include "DicomSegmentation.h"
#include "DicomStructureSet.h"
#include "FileKind.h"
#include "InputError.h"
#include "Refusal.h"

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dcdeftag.h"
#include "dcmtk/dcmdata/dcitem.h"
#include "dcmtk/dcmdata/dcuid.h"

namespace palpate
{
std::optional<ForeignDicom> RecognizeForeignDicom(const std::filesystem::path& file)
{
  const DicomDataset dataset(file, DicomDataset::Extent::UpToPixels);
  DcmItem& root = dataset.Root();
  if (root.tagExists(DCM_DirectoryRecordSequence))
  {
    return ForeignDicom{"is the index of a DICOM medium (DICOMDIR)",
                        "specify the folder with the slices of a series"};
  }
  if (IsDicomSegmentation(file) || IsDicomStructureSet(file))
  {
    return std::nullopt;
  }
  const std::string kind =
      dcmFindNameOfUID(DicomText(root, DCM_SOPClassUID).c_str(), "an unknown class");
  if (!root.tagExists(DCM_Columns))
  {
    return ForeignDicom{"is a DICOM object without pixels (" + kind + ")",
                        "use an image series or a segmentation; 3D Slicer converts surfaces to one "
                        "(import them, then export a .seg.nrrd)"};
  }
  if (DicomNumber(root, DCM_NumberOfFrames, 1.0) > 1.0)
  {
    return ForeignDicom{"is a multi-frame DICOM image (" + kind + "), which is not supported",
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
