#include "DicomSource.h"

#include "DicomDataset.h"
#include "DicomSeries.h"
#include "DicomWriting.h"
#include "FileKind.h"
#include "Refusal.h"
#include "RepeatedSlices.h"
#include "SliceStack.h"

#include <algorithm>
#include <iterator>

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dctk.h"

namespace palpate
{
namespace
{
// Of patient, general and patient study, and frame of reference (PS3.3, C.7.1.1, C.7.2.1, C.7.2.2,
// C.7.4.1): those that have to be present even if they are empty, and others.
const DcmTagKey RequiredTags[] = {DCM_PatientName,
                                  DCM_PatientID,
                                  DCM_PatientBirthDate,
                                  DCM_PatientSex,
                                  DCM_StudyDate,
                                  DCM_StudyTime,
                                  DCM_StudyID,
                                  DCM_AccessionNumber,
                                  DCM_ReferringPhysicianName,
                                  DCM_PositionReferenceIndicator};
const DcmTagKey OptionalTags[] = {DCM_IssuerOfPatientID,
                                  DCM_PatientIdentityRemoved,
                                  DCM_DeidentificationMethod,
                                  DCM_DeidentificationMethodCodeSequence,
                                  DCM_StudyInstanceUID,
                                  DCM_StudyDescription,
                                  DCM_PatientAge,
                                  DCM_PatientSize,
                                  DCM_PatientWeight,
                                  DCM_FrameOfReferenceUID};

DicomSeries SeriesAt(const std::filesystem::path& path)
{
  std::error_code isNoFolder;
  if (std::filesystem::is_directory(path, isNoFolder))
  {
    return ChooseSeries(path, FindDicomSeries(path), {});
  }
  if (!IsDicomFile(path))
  {
    Refuse(path, "is no DICOM file", "specify the folder of the series, or one of its slices");
  }
  return SeriesOfFile(path, FindDicomSeries(path.has_parent_path() ? path.parent_path() : "."));
}

std::unique_ptr<DcmDataset> KeptOf(const std::filesystem::path& file, DcmItem& root)
{
  auto kept = std::make_unique<DcmDataset>();
  for (const DcmTagKey& tag : RequiredTags)
  {
    PutDicomText(*kept, tag, "");
  }
  const auto keep = [&](const DcmTagKey& tag)
  {
    DcmElement* element = nullptr;
    if (root.findAndGetElement(tag, element, OFFalse, OFTrue).good())
    {
      kept->insert(element, OFTrue);
    }
  };
  std::for_each(std::begin(RequiredTags), std::end(RequiredTags), keep);
  std::for_each(std::begin(OptionalTags), std::end(OptionalTags), keep);
  const std::string set = DicomText(root, DCM_SpecificCharacterSet);
  if (!set.empty() && set != "ISO_IR 6" && set != "ISO_IR 192")
  {
    Refuse(file, "has texts in the character set " + set + ", which cannot be converted",
           "convert the series to UTF-8 (ISO_IR 192) first");
  }
  PutDicomText(*kept, DCM_SpecificCharacterSet, "ISO_IR 192");
  return kept;
}
} // namespace

DicomSource::DicomSource(const std::filesystem::path& path) : Source(path)
{
  std::vector<std::string> notes;
  const DicomSeries series = WithoutRepeatedSlices(SeriesAt(path), notes);
  const SliceStack stack = StackSlices(path, series.Planes, {});
  this->Stack = stack.Grid;
  this->Series = series.Uid;
  this->All.resize(series.Files.size());
  for (std::size_t i = 0; i < series.Files.size(); ++i)
  {
    const DicomDataset dataset(series.Files[i], DicomDataset::Extent::UpToPixels);
    DcmItem& root = dataset.Root();
    this->All[static_cast<std::size_t>(stack.SliceOfPlane[i])] = {
        DicomText(root, DCM_SOPClassUID), DicomText(root, DCM_SOPInstanceUID),
        series.Planes[i].PositionWorld};
    if (i == 0)
    {
      this->Kept = KeptOf(series.Files[i], root);
    }
  }
  this->Study = DicomText(*this->Kept, DCM_StudyInstanceUID);
  this->Frame = DicomText(*this->Kept, DCM_FrameOfReferenceUID);
  if (this->Study.empty() || this->Frame.empty())
  {
    Refuse(path, "states no study or no frame of reference", "export the series again");
  }
}

DicomSource::~DicomSource() = default;

void DicomSource::Describe(DcmItem& object, const std::string& sopClass,
                           const std::string& modality) const
{
  for (DcmObject* next = nullptr; (next = this->Kept->nextInContainer(next)) != nullptr;)
  {
    object.insert(static_cast<DcmElement*>(next->clone()), OFTrue);
  }
  OFString date;
  OFString time;
  DcmDate::getCurrentDate(date);
  DcmTime::getCurrentTime(time);
  const std::pair<DcmTagKey, std::string> texts[] = {
      {DCM_SOPClassUID, sopClass},
      {DCM_SOPInstanceUID, NewDicomUid()},
      {DCM_Modality, modality},
      {DCM_SeriesInstanceUID, NewDicomUid()},
      {DCM_SeriesNumber, "1000"}, // behind those of scanners
      {DCM_SeriesDescription, "Made by Palpate"},
      {DCM_InstanceNumber, "1"},
      {DCM_ContentDate, date.c_str()},
      {DCM_ContentTime, time.c_str()},
      {DCM_Manufacturer, "Palpate"},
      {DCM_ManufacturerModelName, "Palpate"},
      {DCM_DeviceSerialNumber, "0"},
      {DCM_SoftwareVersions, PALPATE_VERSION}};
  for (const auto& [tag, text] : texts)
  {
    PutDicomText(object, tag, text);
  }
}

void DicomSource::ReferenceAll(DcmItem& object) const
{
  DcmItem& series = NewDicomItem(object, DCM_ReferencedSeriesSequence);
  PutDicomText(series, DCM_SeriesInstanceUID, this->Series);
  for (const Slice& slice : this->All)
  {
    PutDicomReference(series, DCM_ReferencedInstanceSequence, slice.SopClass, slice.Instance);
  }
}
} // namespace palpate
