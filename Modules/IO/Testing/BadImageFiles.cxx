#include "BadImageFiles.h"

#include "SyntheticImages.h"

#include <cmath>
#include <functional>
#include <limits>
#include <random>

namespace palpate::test
{
namespace
{
NiftiSpec With(const std::function<void(NiftiSpec&)>& change)
{
  NiftiSpec spec;
  change(spec);
  return spec;
}

std::string NrrdWith(std::size_t line, const std::string& text, std::size_t bytes = 120)
{
  std::vector<std::string> lines = PlainNrrdLines("unsigned char");
  lines[line] = text;
  return NrrdBytes(lines, std::string(bytes, '\1'));
}

std::string MetaWith(const std::string& from, const std::string& to)
{
  std::string bytes = MetaImageBytes("MET_UCHAR", std::string(120, '\1'));
  return bytes.replace(bytes.find(from), from.size(), to);
}

std::string WithWrongChecksum(std::string gzipped)
{
  gzipped[gzipped.size() - 6] = static_cast<char>(gzipped[gzipped.size() - 6] ^ 1);
  return gzipped;
}

std::string Overwritten(std::string packed)
{
  return packed.replace(packed.size() / 2, 50, 50, '\0');
}

template <typename T>
std::string NiftiWith(short type, T odd)
{
  std::vector<T> values(120, T(1));
  values[77] = odd;
  return NiftiBytes(With(
                        [type](auto& s)
                        {
                          s.Type = type;
                          s.Bits = 8 * sizeof(T);
                        }),
                    BytesOf(values));
}

// Later lines of the header win: 30 dimensions, more than MetaIO has room for.
std::string ManyDimensions()
{
  std::string sizes;
  for (int axis = 0; axis < 30; ++axis)
  {
    sizes += " 2";
  }
  std::string bytes = MetaWith("NDims = 3", "NDims = 30");
  const std::string good = " 4 5 6";
  return bytes.replace(bytes.find(good), good.size(), sizes);
}
} // namespace

std::string NrrdOfFloats(float odd)
{
  std::vector<float> values(120, 1.0F);
  values[77] = odd;
  return NrrdBytes(PlainNrrdLines("float"), BytesOf(values));
}

std::string Noise(std::size_t count)
{
  std::mt19937 random(7);
  std::string bytes(count, '\0');
  for (char& byte : bytes)
  {
    byte = static_cast<char>(random() % 4);
  }
  return bytes;
}

std::string LargeNifti()
{
  return NiftiBytes(With([](auto& s) { s.Dimensions = {3, 40, 50, 60, 1, 1, 1, 1}; }),
                    Noise(120000));
}

std::string LargeMetaImage(const std::string& packed, const std::string& dataFile)
{
  std::string bytes = MetaImageBytes("MET_UCHAR", packed);
  bytes.replace(bytes.find("CompressedData = False"), 22, "CompressedData = True");
  if (!packed.empty())
  {
    bytes.insert(bytes.find("DimSize"),
                 "CompressedDataSize = " + std::to_string(packed.size()) + "\n");
  }
  bytes.replace(bytes.find("ElementDataFile = LOCAL"), 23, "ElementDataFile = " + dataFile);
  return bytes.replace(bytes.find("DimSize = 4 5 6"), 15, "DimSize = 40 50 60");
}

std::string LargeNrrd(const std::string& packed)
{
  std::vector<std::string> lines = PlainNrrdLines("unsigned char");
  lines[3] = "sizes: 40 50 60";
  lines[7] = "encoding: gzip";
  return NrrdBytes(lines, packed);
}

std::vector<BadFile> BadCompressedFiles()
{
  const std::string nifti = Gzipped(LargeNifti());
  const std::string zlib = Deflated(Noise(120000));
  const std::string gzip = Gzipped(Noise(120000));
  std::string withoutSize = LargeMetaImage(zlib);
  withoutSize.erase(withoutSize.find("CompressedDataSize"),
                    withoutSize.find("DimSize") - withoutSize.find("CompressedDataSize"));
  return {
      {"half.nii.gz", nifti.substr(0, nifti.size() / 2), "is truncated"},
      {"unclosed.nii.gz", nifti.substr(0, nifti.size() - 8), "is truncated"},
      {"crc.nii.gz", WithWrongChecksum(nifti), "is damaged"},
      {"over.nii.gz", Overwritten(nifti), "is damaged"},
      {"few.nii.gz", Gzipped(LargeNifti().substr(0, 100000)), "is truncated"},
      {"half.mha", LargeMetaImage(zlib.substr(0, zlib.size() / 2)), "is truncated"},
      {"unclosed.mha", LargeMetaImage(zlib.substr(0, zlib.size() - 4)), "is truncated"},
      {"over.mha", LargeMetaImage(Overwritten(zlib)), "is damaged"},
      {"few.mha", LargeMetaImage(Deflated(Noise(60000))), "compressed data hold 60000"},
      {"unstated.mha", withoutSize, "no CompressedDataSize"},
      {"half.nrrd", LargeNrrd(gzip.substr(0, gzip.size() / 2)), "is truncated"},
      {"crc.nrrd", LargeNrrd(WithWrongChecksum(gzip)), "is damaged"},
      {"over.nrrd", LargeNrrd(Overwritten(gzip)), "is damaged"},
  };
}

std::vector<BadFile> BadNiftiFiles()
{
  const std::string good = NiftiBytes({}, std::string(120, '\1'));
  const NiftiSpec flat = With([](auto& s) { s.Dimensions = {2, 4, 5, 1, 1, 1, 1, 1}; });
  const NiftiSpec oneSlice = With([](auto& s) { s.Dimensions = {3, 4, 5, 1, 1, 1, 1, 1}; });
  const NiftiSpec series = With([](auto& s) { s.Dimensions = {4, 4, 5, 6, 7, 1, 1, 1}; });
  const NiftiSpec vectors = With([](auto& s) { s.Dimensions = {5, 4, 5, 6, 1, 3, 1, 1}; });
  const NiftiSpec color = With(
      [](auto& s)
      {
        s.Type = 128;
        s.Bits = 24;
      });
  const NiftiSpec zero = With([](auto& s) { s.PixelDimensions[2] = 0; });
  const NiftiSpec negative = With([](auto& s) { s.PixelDimensions[3] = -2; });
  const NiftiSpec sheared = With([](auto& s) { s.SForm[1] = 0.4F; });
  const NiftiSpec rescaled = With([](auto& s) { s.SForm[0] = 2.5F; });
  const NiftiSpec bits = With([](auto& s) { s.Type = 1; });
  const NiftiSpec huge = With([](auto& s) { s.Dimensions = {3, 32767, 32767, 32767, 1, 1, 1, 1}; });
  std::string version2 = good;
  version2[0] = 28;
  version2[1] = 2;
  return {
      {"empty.nii", "", "is empty"},
      {"short.nii", good.substr(0, 200), "has a truncated or damaged header"},
      {"cut.nii", good.substr(0, 400), "header declares 472 bytes but it has 400"},
      {"cut.nii.gz", Gzipped(good).substr(0, 60), "damaged"},
      {"garbage.nii", std::string(5000, 'x'), "is not a NIfTI file"},
      {"garbage.nii.gz", std::string(5000, 'x'), "is not a NIfTI file"},
      {"v2.nii", version2, "is not a NIfTI file"},
      {"flat.nii", NiftiBytes(flat), "is two-dimensional"},
      {"slice.nii", NiftiBytes(oneSlice), "is two-dimensional (4 x 5 x 1 voxels)"},
      {"series.nii", NiftiBytes(series), "holds 7 volumes; choose one"},
      {"vectors.nii", NiftiBytes(vectors), "has 5 dimensions (3 along axis 5)"},
      {"color.nii", NiftiBytes(color), "holds colours"},
      {"zero.nii", NiftiBytes(zero), "a voxel spacing of 0"},
      {"negative.nii", NiftiBytes(negative), "a voxel spacing of -2"},
      {"sheared.nii", NiftiBytes(sheared), "not perpendicular"},
      {"rescaled.nii", NiftiBytes(rescaled), "different voxel sizes in its sform"},
      {"bits.nii", NiftiBytes(bits), "type that is not supported (code 1)"},
      {"nan.nii", NiftiWith(16, std::nanf("")), "1 voxels that are NaN or infinite"},
      {"inf.nii", NiftiWith(16, INFINITY), "1 voxels that are NaN or infinite"},
      {"nan64.nii.gz", Gzipped(NiftiWith(64, std::nan(""))), "1 voxels that are NaN or infinite"},
      {"huge.nii", NiftiBytes(huge, std::string(100, '\1')), "is truncated"},
      {"huge.nii.gz", Gzipped(NiftiBytes(huge, std::string(100, '\1'))), "cannot hold them"},
  };
}

std::vector<BadFile> BadNrrdFiles()
{
  constexpr float NaN = std::numeric_limits<float>::quiet_NaN();
  const std::string good = NrrdBytes(PlainNrrdLines("unsigned char"), std::string(120, '\1'));
  return {
      {"empty.nrrd", "", "is empty"},
      {"garbage.nrrd", std::string(5000, 'x'), "is not an NRRD image"},
      {"short.nrrd", good.substr(0, 40), "is not an NRRD image, or its header is damaged"},
      {"cut.nrrd", good.substr(0, good.size() - 30), "truncated"},
      {"flat.nrrd", NrrdWith(3, "sizes: 4 5 1", 20), "is two-dimensional"},
      {"sheared.nrrd", NrrdWith(4, "space directions: (2,0,0) (0.3,2,0) (0,0,2)"),
       "not perpendicular"},
      {"zero.nrrd", NrrdWith(4, "space directions: (2,0,0) (0,0,0) (0,0,2)"), ""},
      {"vectors.nrrd",
       NrrdBytes({"type: unsigned char", "dimension: 4", "sizes: 3 4 5 6",
                  "kinds: vector domain domain domain", "encoding: raw"},
                 std::string(360, '\1')),
       "has 3 values per voxel"},
      {"series.nrrd",
       NrrdBytes({"type: unsigned char", "dimension: 4", "sizes: 4 5 6 2",
                  "kinds: domain domain domain domain", "encoding: raw"},
                 std::string(240, '\1')),
       ""},
      {"lost.nhdr",
       NrrdBytes(
           {"type: uchar", "dimension: 3", "sizes: 4 5 6", "encoding: raw", "data file: lost.raw"},
           ""),
       "lacks its data file"},
      {"nan.nrrd", NrrdOfFloats(NaN), "1 voxels that are NaN or infinite"},
      {"infinite.nrrd", NrrdOfFloats(-INFINITY), "NaN or infinite"},
  };
}

std::vector<BadFile> BadOtherFiles()
{
  const std::string good = MetaImageBytes("MET_UCHAR", std::string(120, '\1'));
  return {
      {"empty.mha", "", "is empty"},
      {"garbage.mha", std::string(5000, 'x'), "is not a MetaImage file"},
      {"cut.mha", good.substr(0, good.size() - 20),
       "declares 120 bytes of voxels but there are 100"},
      {"zero.mha", MetaWith("ElementSpacing = 2 2 2", "ElementSpacing = 2 0 2"),
       "a voxel spacing of 0"},
      {"negative.mha", MetaWith("ElementSpacing = 2 2 2", "ElementSpacing = 2 -1 2"),
       "a voxel spacing of -1"},
      {"sheared.mha", MetaWith("1 0 0 0 1 0", "1 0 0 0.2 1 0"), "not perpendicular"},
      {"many.mha", ManyDimensions(), "damaged header"},
      {"flat.mha", MetaWith("DimSize = 4 5 6", "DimSize = 4 30 1"), "is two-dimensional"},
      {"lost.mhd", MetaWith("LOCAL", "lost.raw"), "lacks its data file"},
      {"plain.txt", "hello", "is not in a known image format"},
      {"empty.dcm", "", "is empty"},
      {"garbage.dcm", std::string(5000, 'x'), ""},
      {"marked.dcm", std::string(128, '\0') + "DICM" + std::string(500, 'y'), ""},
  };
}
} // namespace palpate::test
