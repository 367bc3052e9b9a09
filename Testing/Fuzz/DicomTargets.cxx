#include "DicomTargets.h"

#include "CompressedDicom.h"
#include "DicomMutator.h"
#include "ImageReading.h"
#include "SyntheticContours.h"
#include "SyntheticImages.h"

namespace palpate::test
{
namespace
{
// A pixel format that the codec supports.
struct CompressedSlice
{
  Codec Coding;
  int BitsAllocated;
  int BitsStored;
  bool IsSigned;
};

DicomSliceSpec Slice(int number)
{
  DicomSliceSpec spec;
  spec.PositionWorld = {0, 0, 3.0 * number};
  return spec;
}

std::string SliceBytes(const DicomSliceSpec& spec)
{
  return WrittenBytes("a.dcm",
                      [&](const std::filesystem::path& file) { WriteDicomSlice(file, spec); });
}

DicomSliceSpec SliceOfSize(int number)
{
  DicomSliceSpec spec = Slice(number);
  spec.Columns = 24;
  spec.Rows = 20;
  return spec;
}

std::string CompressedBytes(const CompressedSlice& kind)
{
  DicomSliceSpec spec = SliceOfSize(1);
  spec.BitsAllocated = kind.BitsAllocated;
  spec.BitsStored = kind.BitsStored;
  spec.IsSigned = kind.IsSigned;
  for (int i = 0; i < spec.Columns * spec.Rows; ++i)
  {
    spec.Pixels.push_back((i * i / 50 + i % 24) % 100);
  }
  return WrittenBytes("a.dcm",
                      [&](const std::filesystem::path& file)
                      {
                        WriteDicomSlice(file, spec);
                        Compress(file, kind.Coding);
                      });
}

std::string SegmentationBytes(const DicomSegmentationSpec& spec, const Codec* coding = nullptr)
{
  return WrittenBytes("a.dcm",
                      [&](const std::filesystem::path& file)
                      {
                        WriteDicomSegmentation(file, spec);
                        if (coding != nullptr)
                        {
                          Compress(file, *coding);
                        }
                      });
}

std::vector<std::string> SegmentationSeeds()
{
  DicomSegmentationSpec binary;
  binary.Segments = {{1, "a"}, {2, "b"}};
  binary.Frames = {{1, 0.0, std::vector<int>(12, 1)}, {2, 6.0, std::vector<int>(12, 1)}};
  DicomSegmentationSpec fractional = binary;
  fractional.Kind = "FRACTIONAL";
  fractional.BitsAllocated = 8;
  fractional.Frames[0].Pixels.assign(12, 100);
  fractional.Frames[1].Pixels.assign(12, 60);
  DicomSegmentationSpec map;
  map.Kind = "LABELMAP";
  map.BitsAllocated = 8;
  map.Frames = {{0, 0.0, std::vector<int>(12, 1)}, {0, 3.0, std::vector<int>(12, 2)}};
  return {SegmentationBytes(binary), SegmentationBytes(fractional), SegmentationBytes(map)};
}

std::vector<std::string> CompressedSegmentationSeeds()
{
  DicomSegmentationSpec map;
  map.Kind = "LABELMAP";
  map.BitsAllocated = 8;
  map.Columns = 16;
  map.Rows = 12;
  map.Frames = {{0, 0.0, std::vector<int>(192, 1)}, {0, 3.0, std::vector<int>(192, 2)}};
  std::vector<std::string> seeds;
  for (const Codec& coding : LosslessCodecs)
  {
    seeds.push_back(SegmentationBytes(map, &coding));
  }
  return seeds;
}

std::vector<std::string> StructureSetSeeds()
{
  StructureSetSpec box = BoxOfContours({0, 3, 6});
  StructureSetSpec two = BoxOfContours({0, 3});
  two.Structures.push_back({2, "b", {{RectangleText(2, 2, 20, 9, 3)}}, "255\\0\\0"});
  std::vector<std::string> seeds;
  for (const StructureSetSpec& spec : {box, two})
  {
    seeds.push_back(WrittenBytes("a.dcm", [&](const std::filesystem::path& file)
                                 { WriteStructureSet(file, spec); }));
  }
  return seeds;
}

// Digits of coordinates, which are far apart from each other in a file.
Mutator ContourMutator()
{
  return [](std::string& bytes, Random& random)
  {
    const std::size_t start = Below(random, bytes.size());
    for (std::size_t i = start, left = 1 + Below(random, 6); i < bytes.size() && left > 0; ++i)
    {
      const bool isDigit = bytes[i] >= '0' && bytes[i] <= '9';
      if (isDigit && Below(random, 4) == 0)
      {
        bytes[i] = Choose(std::string("0123456789.-e\\"), random);
        --left;
      }
    }
  };
}

// The second of three slices, read as part of their series.
InputReader SeriesReader(DicomSliceSpec other)
{
  return FileReader(
      "1.dcm", [](const std::filesystem::path& file) { ReadImage(file.parent_path()); },
      [other = std::move(other)](const std::filesystem::path& folder) mutable
      {
        WriteDicomSlice(folder / "0.dcm", other);
        other.PositionWorld = {0, 0, 6};
        WriteDicomSlice(folder / "2.dcm", other);
      });
}

FuzzTarget CompressedTarget(const std::string& name, const std::vector<CompressedSlice>& kinds)
{
  return {name, "a.dcm",
          [kinds]
          {
            std::vector<std::string> seeds;
            for (const CompressedSlice& kind : kinds)
            {
              seeds.push_back(CompressedBytes(kind));
            }
            return seeds;
          },
          OneOf({MutateFrames, MutateFrames, MutateFrames, MutateDicom}),
          [] { return SeriesReader(SliceOfSize(0)); }};
}
} // namespace

std::vector<FuzzTarget> DicomTargets()
{
  const Mutator dicom = OneOf({MutateDicom, MutateDicom, MutateDicom, MutateBytes});
  return {{"dicom-series", "a.dcm", [] { return std::vector<std::string>{SliceBytes(Slice(1))}; },
           dicom, [] { return SeriesReader(Slice(0)); }},
          {"dicom-segmentation", "a.dcm", SegmentationSeeds, dicom,
           [] { return FileReader("a.dcm", ReadImage); }},
          {"dicom-structure-set", "a.dcm", StructureSetSeeds,
           OneOf({MutateDicom, ContourMutator(), ContourMutator(), MutateBytes}),
           [] { return FileReader("a.dcm", ReadImage); }},
          {"dicom-segmentation-compressed", "a.dcm", CompressedSegmentationSeeds,
           OneOf({MutateFrames, MutateDicom}), [] { return FileReader("a.dcm", ReadImage); }},
          CompressedTarget("dicom-run-length",
                           {{Codec::RunLength, 16, 12, true}, {Codec::RunLength, 8, 8, false}}),
          CompressedTarget("dicom-jpeg", {{Codec::JpegBaseline, 8, 8, false},
                                          {Codec::JpegExtended, 16, 12, false},
                                          {Codec::JpegLossless, 8, 8, false},
                                          {Codec::JpegLossless, 16, 16, true}}),
          CompressedTarget("dicom-jpeg-ls", {{Codec::JpegLs, 8, 8, false},
                                             {Codec::JpegLs, 16, 16, true},
                                             {Codec::JpegLsNearLossless, 16, 12, false}}),
          CompressedTarget("dicom-jpeg-2000", {{Codec::Jpeg2000, 8, 8, false},
                                               {Codec::Jpeg2000, 16, 16, true},
                                               {Codec::Jpeg2000Lossy, 16, 12, false}})};
}
} // namespace palpate::test
