#include "DicomSegmentationWriter.h"

#include "AvailableMemory.h"
#include "DicomWriting.h"
#include "FramePlanes.h"
#include "OrganCodes.h"
#include "Refusal.h"
#include "SegmentColor.h"

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dctk.h"
#include <algorithm>
#include <cstdint>
#include <map>
#include <tuple>

namespace palpate
{
namespace
{
// A segment's pixels in a plane.
struct SegmentFrame
{
  int Segment; // from 1
  int Plane;
  std::vector<std::uint8_t> Bits; // the first pixel in the lowest bit
};

std::vector<SegmentFrame> FramesOf(const std::filesystem::path& path,
                                   const Segmentation& segmentation, const FramePlanes& planes)
{
  std::map<std::pair<int, int>, int> numbers; // of the segments by layer and value
  for (const Segment& segment : segmentation.Segments)
  {
    numbers.emplace(std::pair(segment.Layer, segment.Value), static_cast<int>(numbers.size()) + 1);
  }
  std::vector<SegmentFrame> frames;
  std::vector<int> values;
  for (int plane = 0; plane < planes.Grid().Size[2]; ++plane)
  {
    for (std::size_t layer = 0; layer < segmentation.Layers.size(); ++layer)
    {
      planes.Read(segmentation.Layers[layer], plane, values);
      std::map<int, std::size_t> places; // of the frames by value
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        const auto number = numbers.find({static_cast<int>(layer), values[i]});
        if (values[i] == 0 || number == numbers.end())
        {
          continue;
        }
        const auto [place, isNew] = places.emplace(values[i], frames.size());
        if (isNew)
        {
          const std::size_t bytes = (values.size() + 7) / 8;
          CheckMemory(path, static_cast<double>(bytes));
          frames.push_back({number->second, plane, std::vector<std::uint8_t>(bytes, 0)});
        }
        frames[place->second].Bits[i / 8] |= static_cast<std::uint8_t>(1U << (i % 8));
      }
    }
  }
  std::sort(frames.begin(), frames.end(),
            [](const SegmentFrame& a, const SegmentFrame& b)
            { return std::tie(a.Segment, a.Plane) < std::tie(b.Segment, b.Plane); });
  return frames;
}

// Without padding between frames (PS3.5, 8.1.1). Takes the bits.
std::vector<std::uint8_t> Packed(const std::filesystem::path& path,
                                 std::vector<SegmentFrame>& frames, std::size_t pixels)
{
  constexpr double Most = 4294967294.0; // an even length of 32 bits
  const double bytes = static_cast<double>(frames.size()) * static_cast<double>(pixels) / 8.0;
  if (bytes > Most)
  {
    Refuse(path, "cannot be written: it would have more than 4 GB of pixels",
           "write fewer structures at a time (--label)");
  }
  CheckMemory(path, 2.0 * bytes);
  std::vector<std::uint8_t> packed((frames.size() * pixels + 15) / 16 * 2, 0);
  std::size_t place = 0;
  for (SegmentFrame& frame : frames)
  {
    // A frame may begin within a byte.
    const std::size_t shift = place % 8;
    for (std::size_t i = 0; i < frame.Bits.size(); ++i)
    {
      const unsigned bits = static_cast<unsigned>(frame.Bits[i]) << shift;
      packed[place / 8 + i] |= static_cast<std::uint8_t>(bits);
      if (shift > 0 && bits > 0xFFU)
      {
        packed[place / 8 + i + 1] |= static_cast<std::uint8_t>(bits >> 8U);
      }
    }
    place += pixels;
    frame.Bits = {};
  }
  return packed;
}

void PutImage(DcmItem& root, const ImageGrid& grid, std::size_t frames)
{
  PutDicomText(root, DCM_ImageType, "DERIVED\\PRIMARY");
  PutDicomText(root, DCM_ContentLabel, "SEGMENTATION");
  PutDicomText(root, DCM_ContentDescription, "");
  PutDicomText(root, DCM_ContentCreatorName, "");
  PutDicomText(root, DCM_LossyImageCompression, "00");
  PutDicomText(root, DCM_SegmentationType, "BINARY");
  PutDicomText(root, DCM_PhotometricInterpretation, "MONOCHROME2");
  PutDicomText(root, DCM_NumberOfFrames, std::to_string(frames));
  PutDicomNumber(root, DCM_SamplesPerPixel, 1);
  PutDicomNumber(root, DCM_Columns, static_cast<unsigned short>(grid.Size[0]));
  PutDicomNumber(root, DCM_Rows, static_cast<unsigned short>(grid.Size[1]));
  PutDicomNumber(root, DCM_BitsAllocated, 1);
  PutDicomNumber(root, DCM_BitsStored, 1);
  PutDicomNumber(root, DCM_HighBit, 0);
  PutDicomNumber(root, DCM_PixelRepresentation, 0);
}

void PutTermIfAny(DcmItem& item, const DcmTagKey& sequence, const CodedTerm& term)
{
  if (!term.Value.empty())
  {
    PutDicomTerm(item, sequence, term);
  }
}

void PutSegment(DcmItem& root, const Segment& segment, int number)
{
  DcmItem& item = NewDicomItem(root, DCM_SegmentSequence);
  PutDicomNumber(item, DCM_SegmentNumber, static_cast<unsigned short>(number));
  PutDicomText(item, DCM_SegmentLabel,
               DicomLongString(segment.Name.empty() ? "label " + std::to_string(segment.Label)
                                                    : segment.Name));
  // A person's or a network's: a mask does not say.
  PutDicomText(item, DCM_SegmentAlgorithmType, "SEMIAUTOMATIC");
  PutDicomText(item, DCM_SegmentAlgorithmName, "not stated");
  const bool isCoded = !segment.Codes.Category.Value.empty() && !segment.Codes.Type.Value.empty();
  const SegmentCodes codes = isCoded ? segment.Codes : CodesOfName(segment.Name);
  PutDicomTerm(item, DCM_SegmentedPropertyCategoryCodeSequence, codes.Category);
  DcmItem& type = PutDicomTerm(item, DCM_SegmentedPropertyTypeCodeSequence, codes.Type);
  PutTermIfAny(type, DCM_SegmentedPropertyTypeModifierCodeSequence, codes.TypeModifier);
  if (!codes.Region.Value.empty())
  {
    DcmItem& region = PutDicomTerm(item, DCM_AnatomicRegionSequence, codes.Region);
    PutTermIfAny(region, DCM_AnatomicRegionModifierSequence, codes.RegionModifier);
  }
  const std::array<std::uint16_t, 3> lab = RgbToCieLab(segment.Color);
  item.putAndInsertUint16Array(DCM_RecommendedDisplayCIELabValue, lab.data(), lab.size());
}

void PutDerivation(DcmItem& groups, const DicomSource::Slice* first, const DicomSource::Slice* end)
{
  DcmItem& derivation = NewDicomItem(groups, DCM_DerivationImageSequence);
  PutDicomTerm(derivation, DCM_DerivationCodeSequence, {"DCM", "113076", "Segmentation"});
  for (; first != end; ++first)
  {
    DcmItem& image =
        PutDicomReference(derivation, DCM_SourceImageSequence, first->SopClass, first->Instance);
    PutDicomTerm(image, DCM_PurposeOfReferenceCodeSequence,
                 {"DCM", "121322", "Source image for image processing operation"});
  }
}

void PutSharedGroups(DcmItem& root, const FramePlanes& planes, const DicomSource& source)
{
  const ImageGrid& grid = planes.Grid();
  DcmItem& shared = NewDicomItem(root, DCM_SharedFunctionalGroupsSequence);
  const Vector3 row = grid.Direction.col(0);
  const Vector3 column = grid.Direction.col(1);
  PutDicomText(NewDicomItem(shared, DCM_PlaneOrientationSequence), DCM_ImageOrientationPatient,
               DicomDecimals({row[0], row[1], row[2], column[0], column[1], column[2]}));
  DcmItem& measures = NewDicomItem(shared, DCM_PixelMeasuresSequence);
  PutDicomText(measures, DCM_PixelSpacing, DicomDecimals({grid.Spacing[1], grid.Spacing[0]}));
  PutDicomText(measures, DCM_SliceThickness, DicomDecimals({grid.Spacing[2]}));
  PutDicomText(measures, DCM_SpacingBetweenSlices, DicomDecimals({grid.Spacing[2]}));
  if (!planes.IsOnSeries())
  {
    const auto& slices = source.Slices();
    PutDerivation(shared, slices.data(), slices.data() + slices.size());
  }
}

void PutFrame(DcmItem& root, const SegmentFrame& frame, const FramePlanes& planes,
              const DicomSource& source)
{
  DcmItem& own = NewDicomItem(root, DCM_PerFrameFunctionalGroupsSequence);
  const Uint32 indices[2] = {static_cast<Uint32>(frame.Segment),
                             static_cast<Uint32>(frame.Plane) + 1};
  NewDicomItem(own, DCM_FrameContentSequence)
      .putAndInsertUint32Array(DCM_DimensionIndexValues, indices, 2);
  const Vector3 origin = planes.OriginWorld(frame.Plane);
  PutDicomText(NewDicomItem(own, DCM_PlanePositionSequence), DCM_ImagePositionPatient,
               DicomDecimals({origin[0], origin[1], origin[2]}));
  PutDicomNumber(NewDicomItem(own, DCM_SegmentIdentificationSequence), DCM_ReferencedSegmentNumber,
                 static_cast<unsigned short>(frame.Segment));
  if (planes.IsOnSeries())
  {
    const DicomSource::Slice* slice = &source.Slices()[static_cast<std::size_t>(frame.Plane)];
    PutDerivation(own, slice, slice + 1);
  }
}

// Frames are ordered by segment, then by position.
void PutDimensions(DcmItem& root)
{
  const std::string uid = NewDicomUid();
  PutDicomText(NewDicomItem(root, DCM_DimensionOrganizationSequence), DCM_DimensionOrganizationUID,
               uid);
  const std::tuple<DcmTagKey, DcmTagKey, const char*> dimensions[] = {
      {DCM_ReferencedSegmentNumber, DCM_SegmentIdentificationSequence, "Segment"},
      {DCM_ImagePositionPatient, DCM_PlanePositionSequence, "Position"}};
  for (const auto& [pointer, group, label] : dimensions)
  {
    DcmItem& item = NewDicomItem(root, DCM_DimensionIndexSequence);
    PutDicomText(item, DCM_DimensionOrganizationUID, uid);
    item.putAndInsertTagKey(DCM_DimensionIndexPointer, pointer);
    item.putAndInsertTagKey(DCM_FunctionalGroupPointer, group);
    PutDicomText(item, DCM_DimensionDescriptionLabel, label);
  }
}
} // namespace

bool WriteDicomSegmentation(const std::filesystem::path& path, const Segmentation& segmentation,
                            const DicomSource& source)
{
  const FramePlanes planes(GridOf(segmentation.Layers.front()), source,
                           FramePlanes::OtherVoxels::KeepOwn);
  std::vector<SegmentFrame> frames = FramesOf(path, segmentation, planes);
  const ImageGrid& grid = planes.Grid();
  const std::vector<std::uint8_t> pixels =
      Packed(path, frames,
             static_cast<std::size_t>(grid.Size[0]) * static_cast<std::size_t>(grid.Size[1]));
  DcmFileFormat format;
  DcmItem& root = *format.getDataset();
  source.Describe(root, UID_SegmentationStorage, "SEG");
  PutImage(root, grid, frames.size());
  PutDimensions(root);
  for (std::size_t i = 0; i < segmentation.Segments.size(); ++i)
  {
    PutSegment(root, segmentation.Segments[i], static_cast<int>(i) + 1);
  }
  PutSharedGroups(root, planes, source);
  for (const SegmentFrame& frame : frames)
  {
    PutFrame(root, frame, planes, source);
  }
  source.ReferenceAll(root);
  root.putAndInsertUint8Array(DCM_PixelData, pixels.data(), pixels.size());
  SaveDicom(path, format);
  return planes.IsOnSeries();
}
} // namespace palpate
