#include "DicomSegmentationFrames.h"

#include "DicomFrameDecoder.h"
#include "DicomTransferSyntax.h"
#include "Refusal.h"

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dcdeftag.h"
#include "dcmtk/dcmdata/dcitem.h"
#include <algorithm>
#include <optional>
#include <string>

namespace palpate
{
namespace
{
// A frame's functional groups: its own item first, then the one that all frames share.
struct FunctionalGroups
{
  DcmItem* Own;
  DcmItem* Shared;

  // Item of a group macro's sequence; null if neither has it.
  DcmItem* Find(const DcmTagKey& sequence) const
  {
    DcmItem* found = this->Own ? DicomItem(*this->Own, sequence) : nullptr;
    return found || !this->Shared ? found : DicomItem(*this->Shared, sequence);
  }
};

bool ReadPlane(const FunctionalGroups& groups, StackedSlice& plane)
{
  DcmItem* position = groups.Find(DCM_PlanePositionSequence);
  DcmItem* orientation = groups.Find(DCM_PlaneOrientationSequence);
  DcmItem* measures = groups.Find(DCM_PixelMeasuresSequence);
  return position && orientation && measures && ReadPlanePosition(*position, plane) &&
         ReadPlaneOrientation(*orientation, plane) && ReadPixelSpacing(*measures, plane);
}

std::optional<double> StatedStep(const FunctionalGroups& groups)
{
  DcmItem* measures = groups.Find(DCM_PixelMeasuresSequence);
  const double thickness = measures ? DicomNumber(*measures, DCM_SliceThickness, 0.0) : 0.0;
  const double step =
      measures ? DicomNumber(*measures, DCM_SpacingBetweenSlices, thickness) : thickness;
  return step > 0.0 ? std::optional<double>(step) : std::nullopt;
}

int SegmentNumberOf(const FunctionalGroups& groups)
{
  DcmItem* identification = groups.Find(DCM_SegmentIdentificationSequence);
  return identification ? DicomInteger(*identification, DCM_ReferencedSegmentNumber, 0) : 0;
}

constexpr int MostPixelsAlong = 65535; // as Columns and Rows are stored
} // namespace

DicomSegmentationFrames::DicomSegmentationFrames(const std::filesystem::path& file,
                                                 const DicomDataset& dataset)
{
  // The pixels first: they bound the header's counts.
  this->ReadPixels(file, dataset);
  this->ReadPlanes(file, dataset);
}

void DicomSegmentationFrames::ReadPixels(const std::filesystem::path& file,
                                         const DicomDataset& dataset)
{
  DcmItem& root = dataset.Root();
  const int frames = DicomInteger(root, DCM_NumberOfFrames, 0);
  const int columns = DicomInteger(root, DCM_Columns, 0);
  const int rows = DicomInteger(root, DCM_Rows, 0);
  if (frames < 1 || columns < 1 || rows < 1 || columns > MostPixelsAlong || rows > MostPixelsAlong)
  {
    Refuse(file, "has no frames", "export the segmentation again");
  }
  this->Form.Columns = columns;
  this->Form.Rows = rows;
  this->FrameCount = static_cast<std::size_t>(frames);
  this->PixelsPerFrame = static_cast<std::int64_t>(columns) * rows;
  this->BitsPerPixel = DicomInteger(root, DCM_BitsAllocated, 0);
  if ((this->BitsPerPixel != 1 && this->BitsPerPixel != 8 && this->BitsPerPixel != 16) ||
      DicomNumber(root, DCM_SamplesPerPixel, 1.0) != 1.0)
  {
    Refuse(file, "has a pixel format that is not valid for a segmentation",
           "export the segmentation again");
  }
  if (this->BitsPerPixel == 1 && PixelCodingOf(dataset.TransferSyntax()) != PixelCoding::Native)
  {
    Refuse(file, "has compressed pixels of one bit, which are not supported",
           "export the segmentation again uncompressed or with eight bits a pixel");
  }
  DicomFrameDecoder decoder;
  this->PixelData.emplace(file, dataset, this->FrameCount, decoder);
  this->Pixels = this->PixelData->Bytes();
  const double needed = static_cast<double>(this->PixelsPerFrame) *
                        static_cast<double>(this->FrameCount) * this->BitsPerPixel / 8.0;
  if (!this->Pixels || static_cast<double>(this->PixelData->ByteCount()) < needed)
  {
    Refuse(file, "is truncated: it has fewer pixels than its header declares",
           "copy or export it again");
  }
}

void DicomSegmentationFrames::ReadPlanes(const std::filesystem::path& file,
                                         const DicomDataset& dataset)
{
  DcmItem& root = dataset.Root();
  const std::vector<DcmItem*> own = DicomItems(root, DCM_PerFrameFunctionalGroupsSequence);
  if (own.size() < this->FrameCount && this->FrameCount > 1)
  {
    Refuse(file,
           "describes " + std::to_string(own.size()) + " of its " +
               std::to_string(this->FrameCount) + " frames",
           "export the segmentation again with plane positions");
  }
  FunctionalGroups groups{nullptr, DicomItem(root, DCM_SharedFunctionalGroupsSequence)};
  StackedSlice plane = this->Form;
  SliceStackRules rules;
  rules.Sparse = true;
  for (std::size_t i = 0; i < this->FrameCount; ++i)
  {
    groups.Own = i < own.size() ? own[i] : nullptr;
    if (!ReadPlane(groups, plane))
    {
      Refuse(file, "does not say where frame " + std::to_string(i + 1) + " lies in the patient",
             "export the segmentation again with plane positions");
    }
    plane.Name = "frame " + std::to_string(i + 1);
    this->Planes.push_back(plane);
    this->SegmentNumbers.push_back(SegmentNumberOf(groups));
    rules.StatedStep = StatedStep(groups);
  }
  this->Stack = StackSlices(file, this->Planes, rules);
}

int DicomSegmentationFrames::Value(std::size_t frame, std::int64_t pixel) const
{
  const std::size_t place =
      frame * static_cast<std::size_t>(this->PixelsPerFrame) + static_cast<std::size_t>(pixel);
  switch (this->BitsPerPixel)
  {
  case 1:
    // Frames follow each other without padding, the first pixel in the lowest bit (PS3.5, 8.1.1).
    return (this->Pixels[place / 8] >> (place % 8)) & 1;
  case 8:
    return this->Pixels[place];
  default:
    return this->Pixels[2 * place] | (this->Pixels[2 * place + 1] << 8);
  }
}

std::int64_t DicomSegmentationFrames::SkipZeros(std::size_t frame, std::int64_t pixel) const
{
  const std::size_t first = frame * static_cast<std::size_t>(this->PixelsPerFrame);
  while (pixel < this->PixelsPerFrame && this->Value(frame, pixel) == 0)
  {
    // Most bytes of a binary frame are empty: eight pixels at once.
    const std::size_t place = first + static_cast<std::size_t>(pixel);
    const bool isEmptyByte =
        this->BitsPerPixel == 1 && place % 8 == 0 && this->Pixels[place / 8] == 0;
    pixel += isEmptyByte ? 8 : 1;
  }
  return std::min(pixel, this->PixelsPerFrame);
}

void DicomSegmentationFrames::AppendRuns(std::size_t frame, int threshold,
                                         std::vector<VoxelRun>& runs) const
{
  const std::int64_t first = this->FirstVoxel(frame);
  for (std::int64_t start = this->SkipZeros(frame, 0); start < this->PixelsPerFrame;)
  {
    std::int64_t end = start;
    while (end < this->PixelsPerFrame && this->Value(frame, end) >= threshold)
    {
      ++end;
    }
    if (end > start)
    {
      runs.push_back({first + start, end - start});
    }
    start = this->SkipZeros(frame, end > start ? end : end + 1);
  }
}

void DicomSegmentationFrames::AppendRunsByValue(std::size_t frame,
                                                std::map<int, std::vector<VoxelRun>>& runs) const
{
  const std::int64_t first = this->FirstVoxel(frame);
  for (std::int64_t start = this->SkipZeros(frame, 0); start < this->PixelsPerFrame;)
  {
    const int value = this->Value(frame, start);
    std::int64_t end = start + 1;
    while (end < this->PixelsPerFrame && this->Value(frame, end) == value)
    {
      ++end;
    }
    runs[value].push_back({first + start, end - start});
    start = this->SkipZeros(frame, end);
  }
}
} // namespace palpate
