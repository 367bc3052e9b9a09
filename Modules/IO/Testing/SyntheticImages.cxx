#include "SyntheticImages.h"

#include <algorithm>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <zlib.h>

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dctk.h"

namespace palpate::test
{
namespace
{
template <typename T>
void Put(std::string& bytes, std::size_t offset, T value)
{
  std::memcpy(&bytes[offset], &value, sizeof(T));
}

std::string Decimals(const std::vector<double>& values)
{
  std::ostringstream text;
  text.precision(12);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    text << (i == 0 ? "" : "\\") << values[i];
  }
  return text.str();
}

void Require(const OFCondition& condition)
{
  if (condition.bad())
  {
    throw std::runtime_error(condition.text());
  }
}

void PutText(DcmItem& item, const DcmTagKey& tag, const std::string& text)
{
  Require(item.putAndInsertString(tag, text.c_str()));
}

void PutNumber(DcmItem& item, const DcmTagKey& tag, int value)
{
  Require(item.putAndInsertUint16(tag, static_cast<Uint16>(value)));
}

DcmItem& NewItem(DcmItem& parent, const DcmTagKey& sequence)
{
  DcmItem* item = nullptr;
  Require(parent.findOrCreateSequenceItem(sequence, item, -2));
  return *item;
}

void PutImageSize(DcmItem& item, int bits, int columns, int rows)
{
  PutNumber(item, DCM_SamplesPerPixel, 1);
  PutText(item, DCM_PhotometricInterpretation, "MONOCHROME2");
  PutNumber(item, DCM_Rows, rows);
  PutNumber(item, DCM_Columns, columns);
  PutNumber(item, DCM_BitsAllocated, bits);
  PutNumber(item, DCM_BitsStored, bits);
  PutNumber(item, DCM_HighBit, bits - 1);
  PutNumber(item, DCM_PixelRepresentation, 0);
}

void PutOrientation(DcmItem& item, const Vector3& row, const Vector3& column)
{
  PutText(item, DCM_ImageOrientationPatient,
          Decimals({row[0], row[1], row[2], column[0], column[1], column[2]}));
}

void PutSegmentDescriptions(DcmItem& item, const DicomSegmentationSpec& spec)
{
  for (const auto& description : spec.Segments)
  {
    DcmItem& segment = NewItem(item, DCM_SegmentSequence);
    PutNumber(segment, DCM_SegmentNumber, description.Number);
    PutText(segment, DCM_SegmentLabel, description.Name);
  }
}

void PutFrames(DcmItem& item, const DicomSegmentationSpec& spec)
{
  DcmItem& shared = NewItem(item, DCM_SharedFunctionalGroupsSequence);
  PutOrientation(NewItem(shared, DCM_PlaneOrientationSequence), Vector3::UnitX(), Vector3::UnitY());
  DcmItem& measures = NewItem(shared, DCM_PixelMeasuresSequence);
  PutText(measures, DCM_PixelSpacing, "2\\2");
  if (spec.StatedStep > 0.0)
  {
    PutText(measures, DCM_SpacingBetweenSlices, Decimals({spec.StatedStep}));
  }
  for (const auto& frame : spec.Frames)
  {
    DcmItem& own = NewItem(item, DCM_PerFrameFunctionalGroupsSequence);
    PutText(NewItem(own, DCM_PlanePositionSequence), DCM_ImagePositionPatient,
            Decimals({10.0, 20.0, frame.Height}));
    PutNumber(NewItem(own, DCM_SegmentIdentificationSequence), DCM_ReferencedSegmentNumber,
              frame.SegmentNumber);
  }
}

std::vector<Uint8> PackedPixels(const DicomSegmentationSpec& spec)
{
  std::vector<Uint8> bytes;
  std::size_t bit = 0;
  for (const auto& frame : spec.Frames)
  {
    for (const int pixel : frame.Pixels)
    {
      if (spec.BitsAllocated == 1)
      {
        bytes.resize(bit / 8 + 1, 0);
        bytes.back() = static_cast<Uint8>(bytes.back() | (pixel << (bit % 8)));
        ++bit;
        continue;
      }
      bytes.push_back(static_cast<Uint8>(pixel & 255));
      if (spec.BitsAllocated == 16)
      {
        bytes.push_back(static_cast<Uint8>(pixel >> 8));
      }
    }
  }
  bytes.resize((bytes.size() + 1) / 2 * 2, 0);
  return bytes;
}

void PutPixels(DcmItem& item, const DicomSliceSpec& spec)
{
  const auto count = static_cast<std::size_t>(spec.Columns * spec.Rows);
  std::vector<int> values(spec.Pixels);
  for (int& value : values)
  {
    value &= (1 << spec.BitsStored) - 1;
  }
  values.resize(count, spec.Value);
  // Words of a little-endian host, so the bytes have the order of the file.
  std::vector<Uint16> words(values.begin(), values.end());
  if (spec.BitsAllocated == 8)
  {
    std::vector<Uint8> bytes(values.begin(), values.end());
    bytes.resize((count + 1) / 2 * 2, 0);
    words.resize(bytes.size() / 2);
    std::memcpy(words.data(), bytes.data(), bytes.size());
  }
  Require(item.putAndInsertUint16Array(DCM_PixelData, words.data(), words.size()));
}

void Save(DcmFileFormat& format, const std::filesystem::path& file)
{
  Require(format.saveFile(file.c_str(), EXS_LittleEndianExplicit));
}
} // namespace

std::size_t NiftiSpec::VoxelCount() const
{
  std::size_t count = 1;
  for (short axis = 1; axis <= this->Dimensions[0]; ++axis)
  {
    count *= static_cast<std::size_t>(this->Dimensions[static_cast<std::size_t>(axis)]);
  }
  return count;
}

std::string NiftiBytes(const NiftiSpec& spec, const std::string& voxels)
{
  std::string bytes(352, '\0');
  Put(bytes, 0, std::int32_t{348});
  for (std::size_t i = 0; i < 8; ++i)
  {
    Put(bytes, 40 + 2 * i, spec.Dimensions[i]);
  }
  Put(bytes, 70, spec.Type);
  Put(bytes, 72, spec.Bits);
  for (std::size_t i = 0; i < 4; ++i)
  {
    Put(bytes, 76 + 4 * i, spec.PixelDimensions[i]);
  }
  Put(bytes, 108, 352.0F);
  Put(bytes, 112, spec.Slope);
  Put(bytes, 116, spec.Intercept);
  Put(bytes, 123, char{2}); // millimetres
  Put(bytes, 252, spec.QFormCode);
  Put(bytes, 254, spec.SFormCode);
  for (std::size_t i = 0; i < 6; ++i)
  {
    Put(bytes, 256 + 4 * i, spec.QForm[i]);
  }
  for (std::size_t i = 0; i < 12; ++i)
  {
    Put(bytes, 280 + 4 * i, spec.SForm[i]);
  }
  bytes.replace(344, 3, "n+1");
  return bytes + voxels;
}

std::string NiftiBytes(const NiftiSpec& spec)
{
  return NiftiBytes(spec,
                    std::string(spec.VoxelCount() * static_cast<std::size_t>(spec.Bits) / 8, '\0'));
}

std::string WithNiftiExtension(std::string bytes, const std::string& text, std::int32_t code)
{
  const auto size = static_cast<std::int32_t>((text.size() + 8 + 15) / 16 * 16);
  std::string extension = BytesOf(std::vector<std::int32_t>{size, code}) + text;
  extension.resize(static_cast<std::size_t>(size), '\0');
  bytes.insert(352, extension);
  bytes[348] = 1;
  const auto offset = static_cast<float>(352 + size);
  std::memcpy(&bytes[108], &offset, sizeof offset);
  return bytes;
}

std::vector<Eigen::Matrix3d> AllAxisOrders()
{
  std::vector<Eigen::Matrix3d> orders;
  std::array<int, 3> worldAxes{0, 1, 2};
  do
  {
    for (int signs = 0; signs < 8; ++signs)
    {
      Eigen::Matrix3d axes = Eigen::Matrix3d::Zero();
      for (int i = 0; i < 3; ++i)
      {
        axes(worldAxes[static_cast<std::size_t>(i)], i) = (signs >> i) % 2 == 0 ? 1.0 : -1.0;
      }
      orders.push_back(axes);
    }
  } while (std::next_permutation(worldAxes.begin(), worldAxes.end()));
  return orders;
}

std::string NrrdBytes(const std::vector<std::string>& lines, const std::string& voxels)
{
  std::string bytes = "NRRD0005\n";
  for (const std::string& line : lines)
  {
    bytes += line + '\n';
  }
  return bytes + '\n' + voxels;
}

std::vector<std::string> PlainNrrdLines(const std::string& type)
{
  return {"type: " + type,
          "dimension: 3",
          "space: left-posterior-superior",
          "sizes: 4 5 6",
          "space directions: (2,0,0) (0,2,0) (0,0,2)",
          "kinds: domain domain domain",
          "endian: little",
          "encoding: raw",
          "space origin: (10,20,30)"};
}

std::string MetaImageBytes(const std::string& type, const std::string& voxels,
                           const std::string& moreLines)
{
  return "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
         "CompressedData = False\nOffset = 10 20 30\nDimSize = 4 5 6\n" +
         (moreLines.empty() ? "TransformMatrix = 1 0 0 0 1 0 0 0 1\nElementSpacing = 2 2 2\n"
                            : moreLines) +
         "ElementType = " + type + "\nElementDataFile = LOCAL\n" + voxels;
}

namespace
{
std::string Packed(const std::string& bytes, int windowBits)
{
  z_stream stream{};
  deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}
} // namespace

std::string Gzipped(const std::string& bytes)
{
  return Packed(bytes, 16 + MAX_WBITS); // 16 + window bits: a gzip wrapper
}

std::string Deflated(const std::string& bytes)
{
  return Packed(bytes, MAX_WBITS);
}

void WriteDicomSlice(const std::filesystem::path& file, const DicomSliceSpec& spec)
{
  DcmFileFormat format;
  DcmItem& item = *format.getDataset();
  PutText(item, DCM_SOPClassUID, UID_MRImageStorage);
  PutText(item, DCM_SOPInstanceUID, "1.2.3.4." + std::to_string(spec.Value));
  PutText(item, DCM_Modality, "MR");
  PutText(item, DCM_PatientName, "Secret^Patient");
  PutText(item, DCM_PatientID, "secret-1");
  PutText(item, DCM_InstitutionName, "Secret Clinic");
  PutText(item, DCM_StudyInstanceUID, "1.2.3.1");
  PutText(item, DCM_FrameOfReferenceUID, "1.2.3.2");
  PutText(item, DCM_SeriesInstanceUID, spec.SeriesUid);
  PutText(item, DCM_SeriesDescription, spec.Description);
  if (!spec.Date.empty())
  {
    PutText(item, DCM_SeriesDate, spec.Date);
  }
  PutText(item, DCM_SeriesNumber, std::to_string(spec.SeriesNumber));
  PutText(item, DCM_ImagePositionPatient,
          Decimals({spec.PositionWorld[0], spec.PositionWorld[1], spec.PositionWorld[2]}));
  PutOrientation(item, spec.RowWorld, spec.ColumnWorld);
  PutText(item, DCM_PixelSpacing, "1.5\\2");
  PutImageSize(item, spec.BitsAllocated, spec.Columns, spec.Rows);
  PutNumber(item, DCM_BitsStored, spec.BitsStored);
  PutNumber(item, DCM_HighBit, spec.BitsStored - 1);
  PutNumber(item, DCM_PixelRepresentation, spec.IsSigned ? 1 : 0);
  if (!spec.Slope.empty())
  {
    PutText(item, DCM_RescaleSlope, spec.Slope);
    PutText(item, DCM_RescaleIntercept, spec.Intercept);
  }
  PutPixels(item, spec);
  Save(format, file);
}

void WriteDicomSegmentation(const std::filesystem::path& file, const DicomSegmentationSpec& spec)
{
  DcmFileFormat format;
  DcmItem& item = *format.getDataset();
  const bool isLabelMap = spec.Kind == "LABELMAP";
  PutText(item, DCM_SOPClassUID,
          std::string("1.2.840.10008.5.1.4.1.1.66.") + (isLabelMap ? "7" : "4"));
  PutText(item, DCM_SOPInstanceUID, "1.2.3.5");
  PutText(item, DCM_Modality, "SEG");
  PutText(item, DCM_PatientName, "Secret^Patient");
  PutText(item, DCM_SegmentationType, spec.Kind);
  PutText(item, DCM_NumberOfFrames, std::to_string(spec.Frames.size()));
  if (spec.Kind == "FRACTIONAL")
  {
    PutNumber(item, DCM_MaximumFractionalValue, 100);
  }
  PutImageSize(item, spec.BitsAllocated, spec.Columns, spec.Rows);
  PutSegmentDescriptions(item, spec);
  PutFrames(item, spec);
  const std::vector<Uint8> pixels = PackedPixels(spec);
  Require(item.putAndInsertUint8Array(DCM_PixelData, pixels.data(), pixels.size()));
  Save(format, file);
}
} // namespace palpate::test
