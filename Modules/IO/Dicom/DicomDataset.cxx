#include "DicomDataset.h"

#include "AvailableMemory.h"
#include "BoundedDicomStream.h"
#include "DecimalText.h"
#include "Refusal.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

// DCMTK's configuration header must come before its others.
#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dctk.h"

namespace palpate
{
namespace
{
bool ReadVector(DcmItem& item, const DcmTagKey& tag, unsigned long first, Vector3& vector)
{
  for (unsigned long i = 0; i < 3; ++i)
  {
    vector[static_cast<Eigen::Index>(i)] =
        DicomNumber(item, tag, std::numeric_limits<double>::quiet_NaN(), first + i);
  }
  return vector.allFinite();
}
} // namespace

DicomDataset::DicomDataset(const std::filesystem::path& file, Extent extent)
    : Format(std::make_unique<DcmFileFormat>())
{
  const DcmTagKey stop = extent == Extent::All ? DCM_UndefinedTagKey : DCM_PixelData;
  // The parsed values are kept in addition to the bytes.
  const std::uint64_t available = AvailableMemoryBytes();
  BoundedDicomStream stream(file, available / 2);
  this->Format->transferInit();
  const OFCondition status =
      this->Format->readUntilTag(stream, EXS_Unknown, EGL_noChange, DCM_MaxReadLength, stop);
  this->Format->transferEnd();
  if (stream.IsTooDeep())
  {
    Refuse(file, "nests sequences too deeply to be read",
           "export it again without its private attributes");
  }
  if (stream.IsTooWide())
  {
    Refuse(file,
           "has more than " + std::to_string(BoundedDicomStream::MostElements) +
               " attributes in a data set or an item",
           "export it again without its private attributes");
  }
  if (stream.IsTooLong())
  {
    Refuse(file,
           "inflates to more than " + SignificantText(static_cast<double>(available) / 2e9) + " GB",
           "export it again, or use a larger machine");
  }
  if (status.bad() || this->Format->getDataset()->card() == 0)
  {
    Refuse(file, "is not a DICOM file, or it is truncated or damaged", "copy or export it again");
  }
  // If the conversion fails, the text remains as in the file.
  this->Format->convertToUTF8();
}

DicomDataset::~DicomDataset() = default;

DcmItem& DicomDataset::Root() const
{
  return *this->Format->getDataset();
}

std::string DicomDataset::TransferSyntax() const
{
  // If DCMTK does not know the stated syntax, it reads the data set as if none were stated.
  const std::string stated = DicomText(*this->Format->getMetaInfo(), DCM_TransferSyntaxUID);
  return !stated.empty() && DcmXfer(stated.c_str()).getXfer() == EXS_Unknown
             ? stated
             : DcmXfer(this->Format->getDataset()->getOriginalXfer()).getXferID();
}

std::vector<DcmItem*> DicomItems(DcmItem& item, const DcmTagKey& sequence)
{
  std::vector<DcmItem*> items;
  DcmSequenceOfItems* found = nullptr;
  if (item.findAndGetSequence(sequence, found).good())
  {
    // Not by index, since DCMTK walks the list from its start for each index.
    for (DcmObject* next = nullptr; (next = found->nextInContainer(next)) != nullptr;)
    {
      items.push_back(static_cast<DcmItem*>(next));
    }
  }
  return items;
}

DcmItem* DicomItem(DcmItem& item, const DcmTagKey& sequence)
{
  DcmItem* found = nullptr;
  const auto status = item.findAndGetSequenceItem(sequence, found);
  return status.good() ? found : nullptr;
}

std::string DicomText(DcmItem& item, const DcmTagKey& tag)
{
  OFString text;
  return item.findAndGetOFStringArray(tag, text).good() ? std::string(text.c_str()) : std::string();
}

double DicomNumber(DcmItem& item, const DcmTagKey& tag, double fallback, unsigned long index)
{
  // findAndGetFloat64 converts no integers; the string form serves decimal and binary attributes.
  OFString text;
  if (item.findAndGetOFString(tag, text, index).bad() || text.empty())
  {
    return fallback;
  }
  OFBool good = OFFalse;
  const double number = OFStandard::atof(text.c_str(), &good);
  return good && std::isfinite(number) ? number : fallback;
}

int DicomInteger(DcmItem& item, const DcmTagKey& tag, int fallback)
{
  const double number = DicomNumber(item, tag, fallback);
  const bool isInt = std::floor(number) == number && number >= std::numeric_limits<int>::min() &&
                     number <= std::numeric_limits<int>::max();
  return isInt ? static_cast<int>(number) : fallback;
}

const std::uint8_t* DicomPixelBytes(DcmItem& item, std::size_t& count)
{
  unsigned long values = 0;
  const Uint8* bytes = nullptr;
  const Uint16* words = nullptr;
  count = 0;
  if (item.findAndGetUint8Array(DCM_PixelData, bytes, &values).good() && bytes)
  {
    count = values;
    return bytes;
  }
  if (item.findAndGetUint16Array(DCM_PixelData, words, &values).good() && words)
  {
    count = 2 * static_cast<std::size_t>(values);
  }
  return reinterpret_cast<const std::uint8_t*>(words);
}

bool ReadPlanePosition(DcmItem& item, StackedSlice& plane)
{
  return ReadVector(item, DCM_ImagePositionPatient, 0, plane.PositionWorld);
}

bool ReadPlaneOrientation(DcmItem& item, StackedSlice& plane)
{
  if (!ReadVector(item, DCM_ImageOrientationPatient, 0, plane.RowWorld) ||
      !ReadVector(item, DCM_ImageOrientationPatient, 3, plane.ColumnWorld))
  {
    return false;
  }
  // Many files round to a few decimals: directions close to perpendicular unit vectors are made
  // exact; others are rejected.
  const double cosine = plane.RowWorld.dot(plane.ColumnWorld);
  if (std::abs(plane.RowWorld.norm() - 1.0) > 1e-3 ||
      std::abs(plane.ColumnWorld.norm() - 1.0) > 1e-3 || std::abs(cosine) > 1e-3)
  {
    return false;
  }
  plane.RowWorld.normalize();
  plane.ColumnWorld -= plane.RowWorld.dot(plane.ColumnWorld) * plane.RowWorld;
  plane.ColumnWorld.normalize();
  return true;
}

bool ReadPixelSpacing(DcmItem& item, StackedSlice& plane)
{
  // First value: between rows; second: between columns (PS3.3, 10.7.1.3).
  plane.Spacing[1] = DicomNumber(item, DCM_PixelSpacing, 0.0, 0);
  plane.Spacing[0] = DicomNumber(item, DCM_PixelSpacing, 0.0, 1);
  return plane.Spacing[0] > 0.0 && plane.Spacing[1] > 0.0;
}
} // namespace palpate
