#include "DicomSegmentation.h"

#include "DicomDataset.h"
#include "DicomSegmentationFrames.h"
#include "Refusal.h"
#include "SegmentColor.h"
#include "SegmentCompletion.h"
#include "SegmentLayers.h"
#include "StructureGaps.h"

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dcdeftag.h"
#include "dcmtk/dcmdata/dcitem.h"
#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace palpate
{
namespace
{
constexpr const char* SegmentationClass = "1.2.840.10008.5.1.4.1.1.66.4";
constexpr const char* LabelMapClass = "1.2.840.10008.5.1.4.1.1.66.7";

// The first term of a sequence; `item` may be null.
CodedTerm ReadTerm(DcmItem* item, const DcmTagKey& sequence)
{
  DcmItem* const term = item ? DicomItem(*item, sequence) : nullptr;
  if (!term)
  {
    return {};
  }
  const std::string value = DicomText(*term, DCM_CodeValue);
  return {DicomText(*term, DCM_CodingSchemeDesignator),
          value.empty() ? DicomText(*term, DCM_LongCodeValue) : value,
          DicomText(*term, DCM_CodeMeaning)};
}

SegmentCodes ReadSegmentCodes(DcmItem& item)
{
  DcmItem* const type = DicomItem(item, DCM_SegmentedPropertyTypeCodeSequence);
  DcmItem* const region = DicomItem(item, DCM_AnatomicRegionSequence);
  return {ReadTerm(&item, DCM_SegmentedPropertyCategoryCodeSequence),
          ReadTerm(&item, DCM_SegmentedPropertyTypeCodeSequence),
          ReadTerm(type, DCM_SegmentedPropertyTypeModifierCodeSequence),
          ReadTerm(&item, DCM_AnatomicRegionSequence),
          ReadTerm(region, DCM_AnatomicRegionModifierSequence)};
}

std::vector<Segment> DescribedSegments(const DicomDataset& dataset)
{
  std::vector<Segment> segments;
  for (DcmItem* item : DicomItems(dataset.Root(), DCM_SegmentSequence))
  {
    Segment segment;
    segment.Label = DicomInteger(*item, DCM_SegmentNumber, 0);
    segment.Value = segment.Label;
    segment.Name = DicomText(*item, DCM_SegmentLabel);
    segment.Color = DefaultSegmentColor(segment.Label);
    std::array<std::uint16_t, 3> lab{};
    bool colored = true;
    for (unsigned long channel = 0; channel < 3; ++channel)
    {
      const double value = DicomNumber(*item, DCM_RecommendedDisplayCIELabValue, -1.0, channel);
      colored = colored && value >= 0.0;
      lab[channel] = static_cast<std::uint16_t>(std::clamp(value, 0.0, 65535.0));
    }
    if (colored)
    {
      segment.Color = CieLabToRgb(lab);
    }
    segment.Codes = ReadSegmentCodes(*item);
    if (segment.Label > 0)
    {
      segments.push_back(segment);
    }
  }
  return segments;
}

// The smallest pixel value that counts as inside.
int Threshold(const std::filesystem::path& file, const DicomDataset& dataset,
              const std::string& kind, std::vector<std::string>& notes)
{
  if (kind == "BINARY")
  {
    return 1;
  }
  if (kind != "FRACTIONAL")
  {
    Refuse(file, "is a DICOM segmentation of the kind '" + kind + "', which is not supported",
           "convert it to the kind BINARY");
  }
  // At most 16 bits.
  const int largest =
      std::clamp(DicomInteger(dataset.Root(), DCM_MaximumFractionalValue, 255), 1, 65535);
  notes.emplace_back("The segmentation is fractional; pixels of at least half its maximum (" +
                     std::to_string(largest) + ") were taken as inside.");
  return std::max(1, (largest + 1) / 2);
}

// Slices without a frame are not in the file but need memory. The limit is a whole body of 2,048
// slices of 512 x 512 voxels, or in proportion to the stored pixels.
double MostBytes(const DicomSegmentationFrames& frames)
{
  constexpr double OfAnyFile = 512.0 * 512.0 * 2048.0;
  constexpr double OfPixel = 256.0;
  return std::max(OfAnyFile, OfPixel * static_cast<double>(frames.PixelCount()));
}

void NoteGaps(int number, const ImageGrid& grid, const std::vector<VoxelRun>& runs,
              Segmentation& segmentation)
{
  const auto found = std::find_if(segmentation.Segments.begin(), segmentation.Segments.end(),
                                  [&](const Segment& one) { return one.Label == number; });
  Segment described;
  described.Label = number;
  if (std::string note =
          GapNote(found == segmentation.Segments.end() ? described : *found, grid, runs);
      !note.empty())
  {
    segmentation.Notes.push_back(std::move(note));
  }
}

// BINARY and FRACTIONAL: every frame belongs to one segment.
void ReadSeparateSegments(const std::filesystem::path& file, const DicomSegmentationFrames& frames,
                          int threshold, Segmentation& segmentation)
{
  std::map<int, std::vector<VoxelRun>> runsOfSegment;
  for (std::size_t frame = 0; frame < frames.Count(); ++frame)
  {
    frames.AppendRuns(frame, threshold, runsOfSegment[frames.SegmentNumber(frame)]);
  }
  if (runsOfSegment.begin()->first < 1)
  {
    Refuse(file, "has a frame without a segment number", "export the segmentation again");
  }
  SegmentLayers layers(file, frames.Grid(), runsOfSegment.rbegin()->first, MostBytes(frames));
  std::map<int, int> layerOfSegment;
  for (const auto& [number, runs] : runsOfSegment)
  {
    layerOfSegment[number] = layers.Add(number, runs);
    NoteGaps(number, frames.Grid(), runs, segmentation);
  }
  for (Segment& segment : segmentation.Segments)
  {
    const auto layer = layerOfSegment.find(segment.Label);
    segment.Layer = layer == layerOfSegment.end() ? segment.Layer : layer->second;
  }
  segmentation.Layers = layers.Images();
}

// LABELMAP: pixel values are segment numbers.
void ReadLabelFrames(const std::filesystem::path& file, const DicomSegmentationFrames& frames,
                     Segmentation& segmentation)
{
  std::map<int, std::vector<VoxelRun>> runsOfValue;
  for (std::size_t frame = 0; frame < frames.Count(); ++frame)
  {
    frames.AppendRunsByValue(frame, runsOfValue);
  }
  SegmentLayers layers(file, frames.Grid(), runsOfValue.empty() ? 1 : runsOfValue.rbegin()->first,
                       MostBytes(frames));
  for (const auto& [value, runs] : runsOfValue)
  {
    if (layers.Add(value, runs) > 0)
    {
      Refuse(file, "has several frames in one slice", "export the segmentation again");
    }
    NoteGaps(value, frames.Grid(), runs, segmentation);
  }
  segmentation.Layers = layers.Images();
}
} // namespace

bool IsDicomSegmentation(const std::filesystem::path& file)
{
  const DicomDataset dataset(file, DicomDataset::Extent::UpToPixels);
  const std::string sopClass = DicomText(dataset.Root(), DCM_SOPClassUID);
  return sopClass == SegmentationClass || sopClass == LabelMapClass;
}

Segmentation ReadDicomSegmentation(const std::filesystem::path& file)
{
  const DicomDataset dataset(file, DicomDataset::Extent::All);
  const std::string kind = DicomText(dataset.Root(), DCM_SegmentationType);
  Segmentation segmentation;
  segmentation.Source = file;
  segmentation.Segments = DescribedSegments(dataset);
  const bool isLabelMap = kind == "LABELMAP";
  const int threshold = isLabelMap ? 0 : Threshold(file, dataset, kind, segmentation.Notes);
  const DicomSegmentationFrames frames(file, dataset);
  segmentation.Notes.insert(segmentation.Notes.end(), frames.Notes().begin(), frames.Notes().end());
  if (isLabelMap)
  {
    ReadLabelFrames(file, frames, segmentation);
  }
  else
  {
    ReadSeparateSegments(file, frames, threshold, segmentation);
  }
  segmentation.Notes.emplace_back(
      "A DICOM segmentation may leave out empty slices: a structure that touches the first or last "
      "slice need not be cut off there.");
  CompleteSegments(segmentation);
  return segmentation;
}
} // namespace palpate
