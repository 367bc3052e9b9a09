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
/// A DICOM file parsed by DCMTK, and readers of its attributes that treat what is absent or damaged
/// as absent. Text comes out as UTF-8 where the file's character set can be converted. The standard
/// streams are muted while it lives.
class PALPATEIO_EXPORT DicomDataset
{
public:
  /// How much of the file is read.
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
  /// UID of the transfer syntax that the file states; the one that DCMTK recognises where it states
  /// none.
  std::string TransferSyntax() const;

private:
  // DCMTK also prints when a damaged attribute is looked at.
  QuietStandardStreams Quiet;
  std::unique_ptr<DcmFileFormat> Format;
};

/// All items of a sequence, in the file's order; none where it is absent.
PALPATEIO_EXPORT std::vector<DcmItem*> DicomItems(DcmItem& item, const DcmTagKey& sequence);
/// The first item of a sequence, null where it is absent.
PALPATEIO_EXPORT DcmItem* DicomItem(DcmItem& item, const DcmTagKey& sequence);
/// Empty where absent.
PALPATEIO_EXPORT std::string DicomText(DcmItem& item, const DcmTagKey& tag);
/// `fallback` where absent.
PALPATEIO_EXPORT double DicomNumber(DcmItem& item, const DcmTagKey& tag, double fallback,
                                    unsigned long index = 0);
/// `fallback` where absent, not whole or outside of int.
PALPATEIO_EXPORT int DicomInteger(DcmItem& item, const DcmTagKey& tag, int fallback);
/// The pixels as they lie in memory (little-endian, as the host's), null where there are none or
/// they are compressed. They stay in the data set.
PALPATEIO_EXPORT const std::uint8_t* DicomPixelBytes(DcmItem& item, std::size_t& count);
/// Reads position, orientation or pixel spacing into `plane`, each from an item that holds it.
/// False where it is absent, not finite or no plane's.
PALPATEIO_EXPORT bool ReadPlanePosition(DcmItem& item, SlicePlane& plane);
PALPATEIO_EXPORT bool ReadPlaneOrientation(DcmItem& item, SlicePlane& plane);
PALPATEIO_EXPORT bool ReadPixelSpacing(DcmItem& item, SlicePlane& plane);
} // namespace palpate
