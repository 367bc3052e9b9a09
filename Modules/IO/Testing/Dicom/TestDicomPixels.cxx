#include "MessageOf.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"
#include "VolumeFile.h"

#include <gtest/gtest.h>

namespace palpate::dicom_pixels_test
{
namespace
{
using namespace palpate::test;

// A volume of two slices that differ only in position.
Volume ReadTwoSlices(DicomSliceSpec first, DicomSliceSpec second)
{
  const TemporaryFolder folder;
  second.PositionWorld = {0, 0, 3};
  WriteDicomSlice(folder / "1.dcm", first);
  WriteDicomSlice(folder / "2.dcm", second);
  return ReadVolume(folder.Path());
}

void ExpectValue(const DicomSliceSpec& spec, int vtkType, double value)
{
  const Volume volume = ReadTwoSlices(spec, spec);
  EXPECT_EQ(volume.Image->GetScalarType(), vtkType);
  EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(3, 2, 0, 0), value);
  EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(0, 0, 1, 0), value);
}

TEST(DicomPixels, KeepsUnsignedValues)
{
  DicomSliceSpec spec;
  spec.Value = 65535;
  ExpectValue(spec, VTK_UNSIGNED_SHORT, 65535);
}

TEST(DicomPixels, TakesSignFromStoredBits)
{
  DicomSliceSpec spec;
  spec.IsSigned = true;
  spec.Value = 0xFFFE;
  ExpectValue(spec, VTK_SHORT, -2);
  spec.BitsStored = 12;
  spec.Value = 0x0FFD;
  ExpectValue(spec, VTK_SHORT, -3);
}

TEST(DicomPixels, IgnoresBitsAboveStoredBits)
{
  // An overlay in the top bits, as written by old scanners.
  DicomSliceSpec spec;
  spec.BitsStored = 12;
  spec.Value = 0xF123;
  ExpectValue(spec, VTK_UNSIGNED_SHORT, 0x123);
}

TEST(DicomPixels, WholeRescaleGivesInt)
{
  DicomSliceSpec spec;
  spec.Value = 100;
  spec.Slope = "2";
  spec.Intercept = "-1024";
  ExpectValue(spec, VTK_INT, -824);
}

TEST(DicomPixels, FractionalRescaleGivesFloat)
{
  DicomSliceSpec spec;
  spec.Value = 100;
  spec.Slope = "0.25";
  spec.Intercept = "0.5";
  ExpectValue(spec, VTK_FLOAT, 25.5);
}

TEST(DicomPixels, SlicesOfDifferentScaleShareType)
{
  DicomSliceSpec first;
  first.Value = 100;
  first.Slope = "0.25";
  first.Intercept = "0";
  DicomSliceSpec second;
  second.Value = 7;
  const Volume volume = ReadTwoSlices(first, second);
  EXPECT_EQ(volume.Image->GetScalarType(), VTK_FLOAT);
  EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(0, 0, 0, 0), 25.0);
  EXPECT_EQ(volume.Image->GetScalarComponentAsDouble(0, 0, 1, 0), 7.0);
}

TEST(DicomPixels, RejectsTooFewPixels)
{
  const TemporaryFolder folder;
  DicomSliceSpec spec;
  WriteDicomSlice(folder / "1.dcm", spec);
  spec.PositionWorld = {0, 0, 3};
  WriteDicomSlice(folder / "2.dcm", spec);
  std::string bytes = ReadAll(folder / "2.dcm");
  // The last element is the pixels: 24 bytes, preceded by their length field.
  bytes.resize(bytes.size() - 4);
  bytes[bytes.size() - 24] = 20;
  WriteAll(folder / "2.dcm", bytes);
  EXPECT_TRUE(Contains(MessageOf([&] { ReadVolume(folder.Path()); }),
                       "its pixel data do not match its header"));
}
} // namespace
} // namespace palpate::dicom_pixels_test
