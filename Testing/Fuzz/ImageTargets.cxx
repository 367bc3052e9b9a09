#include "ImageTargets.h"

#include "BinaryFields.h"
#include "CaretLabels.h"
#include "GzipMutator.h"
#include "ImageReading.h"
#include "StoredImages.h"
#include "SyntheticImages.h"
#include "TextMutator.h"

namespace palpate::test
{
namespace
{
constexpr const char* NrrdHeadEnd = "\n\n";
constexpr const char* MetaHeadEnd = "ElementDataFile = LOCAL\n";

std::string Labels()
{
  return std::string(60, '\0') + std::string(30, '\1') + std::string(30, '\2');
}

std::string LabelExtension()
{
  return CaretTextOf({{1, {"liver", {}}}, {2, {"spleen", {}}}});
}

std::vector<std::string> NiftiSeeds()
{
  NiftiSpec reals;
  reals.Type = 16;
  reals.Bits = 32;
  reals.QFormCode = 1;
  return {NiftiBytes({}, Labels()),
          WithNiftiExtension(NiftiBytes({}, Labels()), LabelExtension(), 0),
          NiftiBytes(reals, BytesOf(std::vector<float>(reals.VoxelCount(), 1.0F)))};
}

std::vector<std::string> CompressedNiftiSeeds()
{
  std::vector<std::string> seeds = NiftiSeeds();
  for (std::string& seed : seeds)
  {
    seed = Gzipped(seed);
  }
  return seeds;
}

// Offsets from nifti1.h.
Mutator NiftiMutator()
{
  using Type = BinaryField::Type;
  std::vector<BinaryField> fields{{0, 4},
                                  {39, 1},
                                  {108, 4, Type::Real}, // offset of the voxels
                                  {112, 4, Type::Real},
                                  {116, 4, Type::Real},
                                  {120, 2},
                                  {123, 1}, // units
                                  {252, 2},
                                  {254, 2},
                                  {344, 4}, // the magic string
                                  {348, 4}, // extensions
                                  {352, 4},
                                  {356, 4}};
  for (const auto& more : {FieldsFrom(40, 8, 2), FieldsFrom(40, 8, 2), FieldsFrom(68, 3, 2),
                           FieldsFrom(76, 8, 4, Type::Real), FieldsFrom(256, 18, 4, Type::Real)})
  {
    fields.insert(fields.end(), more.begin(), more.end());
  }
  const Mutator change = FieldMutator(fields);
  return OneOf({change, change, change, MutateBytes});
}

std::vector<std::string> Nifti2Seeds()
{
  NiftiSpec series;
  series.Dimensions = {4, 4, 5, 6, 1, 1, 1, 1};
  return {Nifti2Bytes({}, Labels()), ReversedNifti2(Nifti2Bytes(series, Labels()), 1)};
}

// Offsets from nifti2.h.
Mutator Nifti2Mutator()
{
  using Type = BinaryField::Type;
  std::vector<BinaryField> fields{{0, 4},   {4, 4},   {12, 2},  {14, 2},
                                  {168, 8}, {344, 4}, {348, 4}, {500, 4}};
  for (const auto& more : {FieldsFrom(16, 8, 8), FieldsFrom(104, 8, 8, Type::Real),
                           FieldsFrom(176, 2, 8, Type::Real), FieldsFrom(352, 18, 8, Type::Real)})
  {
    fields.insert(fields.end(), more.begin(), more.end());
  }
  const Mutator change = FieldMutator(fields);
  return OneOf({change, change, FieldMutator(fields, ByteOrder::Big), MutateBytes});
}

// Headers of pairs, whose voxels are in another file.
std::vector<std::string> PairSeeds()
{
  return {NiftiPairHeader({}), AnalyzeHeader({}), ReversedNifti1(AnalyzeHeader({}), 1)};
}

InputReader PairReader()
{
  return FileReader("a.hdr", ReadImage,
                    [](const std::filesystem::path& folder)
                    { WriteAll(folder / "a.img", Labels()); });
}

std::vector<std::string> MghSeeds()
{
  MghSpec reals;
  reals.Type = 3;
  return {MghBytes({}, Labels()), MghBytes(reals, BigEndian(std::vector<float>(120, 1.0F)))};
}

std::vector<std::string> CompressedMghSeeds()
{
  return {Gzipped(MghSeeds().front()), Gzipped(MghSeeds().back())};
}

Mutator MghMutator()
{
  std::vector<BinaryField> fields = FieldsFrom(0, 7, 4);
  fields.push_back({28, 2});
  const std::vector<BinaryField> geometry = FieldsFrom(30, 15, 4, BinaryField::Type::Real);
  fields.insert(fields.end(), geometry.begin(), geometry.end());
  const Mutator change = FieldMutator(fields, ByteOrder::Big);
  return OneOf({change, change, change, MutateBytes});
}

std::vector<std::string> GiplSeeds()
{
  GiplSpec reals;
  reals.Type = 65;
  return {GiplBytes({}, Labels()), GiplBytes(reals, BigEndian(std::vector<double>(120, 1.0)))};
}

Mutator GiplMutator()
{
  using Type = BinaryField::Type;
  std::vector<BinaryField> fields = FieldsFrom(0, 5, 2);
  fields.push_back({252, 4});
  for (const auto& more : {FieldsFrom(10, 4, 4, Type::Real), FieldsFrom(204, 4, 8, Type::Real)})
  {
    fields.insert(fields.end(), more.begin(), more.end());
  }
  const Mutator change = FieldMutator(fields, ByteOrder::Big);
  return OneOf({change, change, change, MutateBytes});
}

TextGrammar NrrdGrammar()
{
  return {{"type: float",
           "type: unsigned char",
           "type: int64",
           "type: block",
           "dimension: 4",
           "dimension: 3",
           "sizes: 4 5 6",
           "sizes: 1 1 1",
           "encoding: gzip",
           "encoding: raw",
           "encoding: ascii",
           "encoding: hex",
           "encoding: bzip2",
           "endian: big",
           "space: right-anterior-superior",
           "space: scanner-xyz",
           "space dimension: 3",
           "spacings: 1 1 1",
           "axis mins: 0 0 0",
           "centers: cell node none",
           "kinds: list domain",
           "line skip: 1",
           "byte skip: -1",
           "data file: a.raw",
           "data file: LIST",
           "data file: %d.raw 1 9 1",
           "units: \"mm\" \"mm\" \"mm\"",
           "labels: \"a\" \"b\"",
           "measurement frame: (1,0,0) (0,1,0) (0,0,1)",
           "k:=v\rdimension: 16\r",
           "k:=v\rsizes: 2147483647 2147483647 2147483647\r",
           "k:=v\rdata file: -\r",
           "k:=v\rspace: right-anterior-superior\r",
           "k:=v\rspace dimension: 8\r",
           std::string("data file: -\0", 13),
           "none",
           "nan",
           "(nan,0,0)",
           "NRRD0001",
           "Segment0_LabelValue:=3",
           "Segment0_Layer:=7",
           "Segment9999999_Name:=a",
           "Segment0_Extent:=0 1 2",
           "Segmentation_ContainedRepresentationNames:=x"},
          {{"(", ")"}},
          NrrdHeadEnd};
}

Mutator NrrdMutator()
{
  const Mutator text = TextMutator(NrrdGrammar());
  return OneOf({text, text, text, MutateBytes});
}

std::vector<std::string> NrrdSeeds()
{
  std::vector<std::string> spaced = PlainNrrdLines("short");
  spaced[2] = "space: right-anterior-superior";
  return {NrrdBytes(PlainNrrdLines("unsigned char"), Labels()),
          NrrdBytes(spaced, std::string(240, '\1'))};
}

std::vector<std::string> CompressedNrrdSeeds()
{
  std::vector<std::string> lines = PlainNrrdLines("unsigned char");
  lines[7] = "encoding: gzip";
  return {NrrdBytes(lines, Gzipped(Labels()))};
}

std::vector<std::string> SlicerSeeds()
{
  std::vector<std::string> lines = PlainNrrdLines("unsigned char");
  lines.insert(lines.end(), {"Segment0_Name:=a", "Segment0_LabelValue:=1", "Segment0_Layer:=0",
                             "Segment0_Color:=1 0 0", "Segment1_Name:=b", "Segment1_LabelValue:=2",
                             "Segment1_Layer:=0"});
  std::vector<std::string> layered = lines;
  layered[1] = "dimension: 4";
  layered[3] = "sizes: 2 4 5 6";
  layered[4] = "space directions: none (2,0,0) (0,2,0) (0,0,2)";
  layered[5] = "kinds: list domain domain domain";
  layered.back() = "Segment1_Layer:=1";
  std::string both;
  for (const char label : Labels())
  {
    both += {label, label};
  }
  return {NrrdBytes(lines, Labels()), NrrdBytes(layered, both)};
}

std::vector<std::string> MetaImageSeeds()
{
  std::string packed = Deflated(Labels());
  const std::size_t size = packed.size();
  packed = MetaImageBytes("MET_UCHAR", packed);
  const std::string raw = "CompressedData = False";
  packed.replace(packed.find(raw), raw.size(),
                 "CompressedData = True\nCompressedDataSize = " + std::to_string(size));
  return {MetaImageBytes("MET_UCHAR", Labels()),
          MetaImageBytes("MET_SHORT", std::string(240, '\1')), packed};
}

Mutator MetaImageMutator()
{
  const Mutator text = TextMutator({{"ObjectType = Image",
                                     "NDims = 4",
                                     "NDims = 3",
                                     "BinaryData = False",
                                     "CompressedData = True",
                                     "CompressedDataSize = 10",
                                     "HeaderSize = -1",
                                     "HeaderSize = 100",
                                     "ElementNumberOfChannels = 3",
                                     "ElementType = MET_DOUBLE",
                                     "ElementType = MET_NONE",
                                     "ElementType = MET_LONG_LONG",
                                     "ElementSize = 1 1 1",
                                     "AnatomicalOrientation = RAI",
                                     "ElementDataFile = a.raw",
                                     "ElementDataFile = LIST",
                                     "ElementDataFile = %d.raw 1 9 1",
                                     "Orientation = 1 0 0 0 1 0 0 0 1",
                                     "CenterOfRotation = 0 0 0",
                                     "HeaderSize = 1000000",
                                     "Comment = x",
                                     "Comment = " + std::string(300, '1') + "\n",
                                     "Name = " + std::string(600, 'x') + "\n",
                                     "DimSize : 1500 1500 1000 =\n",
                                     "NDims : 12 =\n",
                                     "ElementDataFile : LIST =\n",
                                     "ElementDataFile : %s%n 1 6 1 =\n",
                                     "DimSize\rFoo = 1500 1500 1000\n",
                                     "\vDimSize = 1500 1500 1000\n",
                                     " : ",
                                     "\r"},
                                    {},
                                    MetaHeadEnd});
  return OneOf({text, text, text, MutateBytes});
}

// Headers whose voxels are in another file.
std::string NrrdHeaderSeed()
{
  std::vector<std::string> lines = PlainNrrdLines("unsigned char");
  lines.push_back("data file: a.raw");
  return NrrdBytes(lines, "");
}

std::string MetaHeaderSeed()
{
  std::string header = MetaImageBytes("MET_UCHAR", "");
  const std::string local = "LOCAL";
  return header.replace(header.find(local), local.size(), "a.raw");
}

InputReader HeaderReader(const std::string& name)
{
  return FileReader(name, ReadImage,
                    [](const std::filesystem::path& folder)
                    { WriteAll(folder / "a.raw", Labels()); });
}

std::string ColorTable()
{
  std::string bytes;
  for (int i = 0; i < 768; ++i)
  {
    bytes += static_cast<char>(i);
  }
  return bytes;
}

// Reads a label map together with the mutated file that describes it.
InputReader NextToLabelMap(const std::string& name)
{
  return FileReader(
      name, [](const std::filesystem::path& file) { ReadImage(file.parent_path() / "a.nii"); },
      [](const std::filesystem::path& folder)
      {
        WriteAll(folder / "a.nii.txt", "1 one 1\n2 two 2\n");
        WriteAll(folder / "a.nii", NiftiBytes({}, Labels()));
      });
}

FuzzTarget ImageTarget(const std::string& name, const std::string& file,
                       std::vector<std::string> (*seeds)(), Mutator mutate)
{
  return {name, file, seeds, std::move(mutate), [file] { return FileReader(file, ReadImage); }};
}
} // namespace

std::vector<FuzzTarget> ImageTargets()
{
  const Mutator nrrd = NrrdMutator();
  return {
      ImageTarget("nifti", "a.nii", NiftiSeeds, NiftiMutator()),
      ImageTarget("nifti-gzip", "a.nii.gz", CompressedNiftiSeeds, GzipMutator(NiftiMutator())),
      ImageTarget("nifti-2", "a.nii", Nifti2Seeds, Nifti2Mutator()),
      {"nifti-pair", "a.hdr", PairSeeds, OneOf({NiftiMutator(), MutateBytes}), PairReader},
      ImageTarget("freesurfer", "a.mgh", MghSeeds, MghMutator()),
      ImageTarget("freesurfer-gzip", "a.mgz", CompressedMghSeeds, GzipMutator(MghMutator())),
      ImageTarget("gipl", "a.gipl", GiplSeeds, GiplMutator()),
      ImageTarget("nrrd", "a.nrrd", NrrdSeeds, nrrd),
      ImageTarget("nrrd-gzip", "a.nrrd", CompressedNrrdSeeds,
                  OneOf({nrrd, Behind(NrrdHeadEnd, GzipMutator(MutateBytes))})),
      {"nrrd-header", "a.nhdr", [] { return std::vector<std::string>{NrrdHeaderSeed()}; }, nrrd,
       [] { return HeaderReader("a.nhdr"); }},
      ImageTarget("slicer-segmentation", "a.seg.nrrd", SlicerSeeds, nrrd),
      ImageTarget("metaimage", "a.mha", MetaImageSeeds, MetaImageMutator()),
      {"metaimage-header", "a.mhd", [] { return std::vector<std::string>{MetaHeaderSeed()}; },
       MetaImageMutator(), [] { return HeaderReader("a.mhd"); }},
      {"label-names", "a.nii.txt",
       [] { return std::vector<std::string>{"1 Precentral_L 2001\n2 Precentral_R 2002\n"}; },
       OneOf({TextMutator({}), MutateBytes}), [] { return NextToLabelMap("a.nii.txt"); }},
      {"label-table", "a.tsv",
       [] { return std::vector<std::string>{"index\tname\tcolor\n1\tliver\t#ff8800\n"}; },
       OneOf({TextMutator({}), MutateBytes}), [] { return NextToLabelMap("a.tsv"); }},
      {"label-extension", "a.xml", [] { return std::vector<std::string>{LabelExtension()}; },
       OneOf({TextMutator({{"<!ENTITY a \"b\">", "<![CDATA[", "]]>", "<LabelTable>", "Key=\"-1\""},
                           {{"<Label Key=\"1\">", "</Label>"}},
                           {}}),
              MutateBytes}),
       []
       {
         return FileReader("a.xml",
                           [](const std::filesystem::path& file) { LabelsOfCaret(ReadAll(file)); });
       }},
      {"label-dataset", "dataset.json",
       [] { return std::vector<std::string>{R"({"labels": {"background": 0, "liver": 1}})"}; },
       OneOf({TextMutator({}), MutateBytes}), [] { return NextToLabelMap("dataset.json"); }},
      {"label-colours", "a.nii.lut", [] { return std::vector<std::string>{ColorTable()}; },
       MutateBytes, [] { return NextToLabelMap("a.nii.lut"); }}};
}
} // namespace palpate::test
