#pragma once

#include "PalpateIOModule.h"
#include "QuietStandardStreams.h"
#include "SliceStack.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

class DcmFileFormat;
class DcmItem;
class DcmTagKey;

namespace palpate
{
/// A DICOM file parsed by DCMTK; its attributes count as absent if they are damaged. Text is UTF-8
/// if the file's character set can be converted. The standard streams are muted during the object's
/// lifetime.
class PALPATEIO_EXPORT DicomDataset
{
public:
  enum class Extent
  {
    UpToPixels,
    All
  };
  /// Throws InputError if DCMTK cannot parse the file, if it nests sequences too deeply or if it
  /// inflates to more than fits into memory.
  DicomDataset(const std::filesystem::path& file, Extent extent);
  DicomDataset(const DicomDataset&) = delete;
  DicomDataset& operator=(const DicomDataset&) = delete;
  ~DicomDataset();

  DcmItem& Root() const;
  /// UID of the file's transfer syntax: the stated one, otherwise the one that DCMTK recognises.
  std::string TransferSyntax() const;

private:
  // DCMTK also prints when a damaged attribute is read.
  QuietStandardStreams Quiet;
  std::unique_ptr<DcmFileFormat> Format;
};

/// All items of a sequence, in the file's order; empty if it is absent.
PALPATEIO_EXPORT std::vector<DcmItem*> DicomItems(DcmItem& item, const DcmTagKey& sequence);
/// The first item of a sequence; null if it is absent.
PALPATEIO_EXPORT DcmItem* DicomItem(DcmItem& item, const DcmTagKey& sequence);
/// Empty if absent.
PALPATEIO_EXPORT std::string DicomText(DcmItem& item, const DcmTagKey& tag);
/// `fallback` if absent.
PALPATEIO_EXPORT double DicomNumber(DcmItem& item, const DcmTagKey& tag, double fallback,
                                    unsigned long index = 0);
/// `fallback` if absent, not a whole number or outside of int.
PALPATEIO_EXPORT int DicomInteger(DcmItem& item, const DcmTagKey& tag, int fallback);
/// The pixels in memory (little-endian, as the host); null if there are none or they are
/// compressed. The data set owns them.
PALPATEIO_EXPORT const std::uint8_t* DicomPixelBytes(DcmItem& item, std::size_t& count);
/// Reads position, orientation or pixel spacing into `plane`, each from an item that holds it.
/// Returns false if it is absent, not finite or not valid for a plane.
PALPATEIO_EXPORT bool ReadPlanePosition(DcmItem& item, StackedSlice& plane);
PALPATEIO_EXPORT bool ReadPlaneOrientation(DcmItem& item, StackedSlice& plane);
PALPATEIO_EXPORT bool ReadPixelSpacing(DcmItem& item, StackedSlice& plane);
} // namespace palpate
