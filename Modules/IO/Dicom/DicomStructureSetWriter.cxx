#include "DicomStructureSetWriter.h"

#include "DicomDataset.h"
#include "DicomWriting.h"
#include "FramePlanes.h"
#include "MaskOutlines.h"
#include "Refusal.h"

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dctk.h"
#include <cmath>
#include <map>
#include <set>

namespace palpate
{
namespace
{
std::string RoiNumber(std::size_t segment)
{
  return std::to_string(segment + 1);
}

void PutReferencedSeries(DcmItem& root, const DicomSource& source)
{
  constexpr const char* DetachedStudy = "1.2.840.10008.3.1.2.3.1"; // retired, but required here
  DcmItem& frame = NewDicomItem(root, DCM_ReferencedFrameOfReferenceSequence);
  PutDicomText(frame, DCM_FrameOfReferenceUID, source.FrameOfReferenceUid());
  DcmItem& study =
      PutDicomReference(frame, DCM_RTReferencedStudySequence, DetachedStudy, source.StudyUid());
  DcmItem& series = NewDicomItem(study, DCM_RTReferencedSeriesSequence);
  PutDicomText(series, DCM_SeriesInstanceUID, source.SeriesUid());
  for (const DicomSource::Slice& slice : source.Slices())
  {
    PutDicomReference(series, DCM_ContourImageSequence, slice.SopClass, slice.Instance);
  }
}

void PutStructure(DcmItem& root, const Segment& segment, std::size_t number,
                  const DicomSource& source)
{
  DcmItem& roi = NewDicomItem(root, DCM_StructureSetROISequence);
  PutDicomText(roi, DCM_ROINumber, RoiNumber(number));
  PutDicomText(roi, DCM_ReferencedFrameOfReferenceUID, source.FrameOfReferenceUid());
  PutDicomText(roi, DCM_ROIName,
               DicomLongString(segment.Name.empty() ? "label " + std::to_string(segment.Label)
                                                    : segment.Name));
  PutDicomText(roi, DCM_ROIGenerationAlgorithm, "");
  DcmItem& observation = NewDicomItem(root, DCM_RTROIObservationsSequence);
  PutDicomText(observation, DCM_ObservationNumber, RoiNumber(number));
  PutDicomText(observation, DCM_ReferencedROINumber, RoiNumber(number));
  PutDicomText(observation, DCM_RTROIInterpretedType, "");
  PutDicomText(observation, DCM_ROIInterpreter, "");
}

// A new item of contours for a structure.
DcmItem& PutContours(DcmItem& root, const Segment& segment, std::size_t number)
{
  DcmItem& contours = NewDicomItem(root, DCM_ROIContourSequence);
  std::string color;
  for (const double channel : segment.Color)
  {
    color += (color.empty() ? "" : "\\") + std::to_string(std::lround(255.0 * channel));
  }
  PutDicomText(contours, DCM_ROIDisplayColor, color);
  PutDicomText(contours, DCM_ReferencedROINumber, RoiNumber(number));
  return contours;
}

void PutContour(DcmItem& contours, const PixelOutline& outline, int plane,
                const FramePlanes& planes, const DicomSource& source)
{
  constexpr int Decimals = 4; // 0.1 µm
  const ImageGrid& grid = planes.Grid();
  std::vector<double> numbers;
  for (const Eigen::Vector2d& point : outline)
  {
    const Vector3 world = planes.OriginWorld(plane) +
                          grid.Direction.col(0) * grid.Spacing[0] * point[0] +
                          grid.Direction.col(1) * grid.Spacing[1] * point[1];
    numbers.insert(numbers.end(), world.begin(), world.end());
  }
  DcmItem& contour = NewDicomItem(contours, DCM_ContourSequence);
  const DicomSource::Slice& slice = source.Slices()[static_cast<std::size_t>(plane)];
  PutDicomReference(contour, DCM_ContourImageSequence, slice.SopClass, slice.Instance);
  PutDicomText(contour, DCM_ContourGeometricType, "CLOSED_PLANAR");
  PutDicomText(contour, DCM_NumberOfContourPoints, std::to_string(outline.size()));
  PutDicomText(contour, DCM_ContourData, DicomDecimals(numbers, Decimals));
}

void PutPlane(const std::filesystem::path& path, const std::vector<int>& values, int plane,
              const FramePlanes& planes, const DicomSource& source,
              const std::map<int, DcmItem*>& itemOfValue)
{
  constexpr std::size_t MostOutlines = 4096; // in a plane; holes take time with their square
  std::set<int> present;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (i == 0 || values[i] != values[i - 1])
    {
      present.insert(values[i]);
    }
  }
  for (const int value : present)
  {
    const auto item = itemOfValue.find(value);
    if (item == itemOfValue.end())
    {
      continue;
    }
    const auto outlines = MaskOutlines(values, planes.Grid().Size[0], value, MostOutlines);
    if (!outlines)
    {
      Refuse(path, "cannot be written: a structure has more than 4,096 contours in a slice",
             "write a segmentation, without --contours");
    }
    for (const PixelOutline& outline : *outlines)
    {
      PutContour(*item->second, outline, plane, planes, source);
    }
  }
}
// Such as one between two slices.
void RequireContours(const std::filesystem::path& path, const Segmentation& segmentation,
                     const std::vector<std::map<int, DcmItem*>>& items)
{
  for (const Segment& segment : segmentation.Segments)
  {
    DcmItem* const item = items[static_cast<std::size_t>(segment.Layer)].at(segment.Value);
    if (DicomItems(*item, DCM_ContourSequence).empty())
    {
      Refuse(path,
             "cannot be written: no slice of the series meets the structure " +
                 std::to_string(segment.Label) + " " + segment.Name,
             "write a segmentation, without --contours");
    }
  }
}
} // namespace

bool WriteDicomStructureSet(const std::filesystem::path& path, const Segmentation& segmentation,
                            const DicomSource& source)
{
  const FramePlanes planes(GridOf(segmentation.Layers.front()), source,
                           FramePlanes::OtherVoxels::TakeNearest);
  DcmFileFormat format;
  DcmItem& root = *format.getDataset();
  source.Describe(root, UID_RTStructureSetStorage, "RTSTRUCT");
  PutDicomText(root, DCM_StructureSetLabel, "PALPATE");
  PutDicomText(root, DCM_StructureSetDate, DicomText(root, DCM_ContentDate));
  PutDicomText(root, DCM_StructureSetTime, DicomText(root, DCM_ContentTime));
  root.findAndDeleteElement(DCM_ContentDate);
  root.findAndDeleteElement(DCM_ContentTime);
  PutDicomText(root, DCM_OperatorsName, "");
  PutDicomText(root, DCM_ApprovalStatus, "UNAPPROVED");
  PutReferencedSeries(root, source);
  std::vector<std::map<int, DcmItem*>> items(segmentation.Layers.size());
  for (std::size_t i = 0; i < segmentation.Segments.size(); ++i)
  {
    const Segment& segment = segmentation.Segments[i];
    PutStructure(root, segment, i, source);
    items[static_cast<std::size_t>(segment.Layer)][segment.Value] = &PutContours(root, segment, i);
  }
  std::vector<int> values;
  for (std::size_t layer = 0; layer < items.size(); ++layer)
  {
    for (int plane = 0; plane < planes.Grid().Size[2]; ++plane)
    {
      planes.Read(segmentation.Layers[layer], plane, values);
      PutPlane(path, values, plane, planes, source, items[layer]);
    }
  }
  RequireContours(path, segmentation, items);
  SaveDicom(path, format, false); // contours may be long
  return planes.IsExact();
}
} // namespace palpate
