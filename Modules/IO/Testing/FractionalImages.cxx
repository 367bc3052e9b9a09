#include "FractionalImages.h"

#include "SyntheticImages.h"
#include "TemporaryFolder.h"

namespace palpate::test
{
namespace
{
// 120 voxels of two labels, in fractions of a millimetre.
std::string Voxels()
{
  std::string voxels(120, '\0');
  voxels[7] = 1;
  voxels[100] = 2;
  return voxels;
}

std::string FractionalNrrd()
{
  std::vector<std::string> lines = PlainNrrdLines("unsigned char");
  lines[4] = "space directions: (1.5,0,0) (0,0.75,0) (0,0,3.25)";
  lines[8] = "space origin: (10.125,-20.5,30.75)";
  lines.insert(lines.end(), {"Segment0_Name:=a", "Segment0_LabelValue:=1", "Segment0_Layer:=0",
                             "Segment0_Color:=0.25 0.5 0.75"});
  return NrrdBytes(lines, Voxels());
}

// Without directions, so that its library's numbers are used.
std::string FractionalSpacings()
{
  return NrrdBytes({"type: unsigned char", "dimension: 3", "sizes: 4 5 6",
                    "spacings: 1.5 0.75 3.25", "encoding: raw"},
                   Voxels());
}

std::string FractionalNifti()
{
  NiftiSpec spec;
  spec.Type = 4;
  spec.Bits = 16;
  spec.PixelDimensions = {1.0F, 1.5F, 0.75F, 3.25F};
  // RAS.
  spec.SForm = {-1.5F, 0, 0, -10.125F, 0, -0.75F, 0, 20.5F, 0, 0, 3.25F, 30.75F};
  spec.Slope = 0.5F;
  return NiftiBytes(spec, BytesOf(std::vector<short>(120, 3)));
}

std::string FractionalMetaImage()
{
  std::string bytes = MetaImageBytes("MET_UCHAR", Voxels(),
                                     "TransformMatrix = 0.6 0.8 0 -0.8 0.6 0 0 0 1\n"
                                     "ElementSpacing = 1.5 0.75 3.25\n");
  const std::string offset = "10 20 30";
  return bytes.replace(bytes.find(offset), offset.size(), "10.125 -20.5 30.75");
}

void WriteFractionalDicom(const std::filesystem::path& folder)
{
  std::filesystem::create_directory(folder);
  for (int slice = 0; slice < 3; ++slice)
  {
    DicomSliceSpec spec;
    spec.PositionWorld = FractionalOrigin() + Vector3(0.0, 0.0, 3.25 * slice);
    spec.Value = static_cast<std::uint16_t>(slice);
    spec.Slope = "0.5";
    spec.Intercept = "-1.25";
    WriteDicomSlice(folder / (std::to_string(slice) + ".dcm"), spec);
  }
}

void WriteFractionalDicomSegmentation(const std::filesystem::path& file)
{
  DicomSegmentationSpec spec;
  spec.StatedStep = 3.25;
  spec.Segments = {{1, "a"}};
  for (int frame = 0; frame < 3; ++frame)
  {
    spec.Frames.push_back({1, 3.25 * frame, std::vector<int>(12, 1)});
  }
  WriteDicomSegmentation(file, spec);
}

} // namespace

void WriteFractionalImages(const std::filesystem::path& folder)
{
  WriteAll(folder / "a.nii", FractionalNifti());
  WriteAll(folder / "a.seg.nrrd", FractionalNrrd());
  WriteAll(folder / "b.nrrd", FractionalSpacings());
  WriteAll(folder / "a.mha", FractionalMetaImage());
  WriteFractionalDicom(folder / "dicom");
  WriteFractionalDicomSegmentation(folder / "seg.dcm");
}
} // namespace palpate::test
