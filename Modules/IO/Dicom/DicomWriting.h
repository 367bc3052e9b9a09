#pragma once

#include "PalpateIOModule.h"
#include "SegmentCodes.h"
#include "Vector3.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

class DcmFileFormat;
class DcmItem;
class DcmTagKey;

namespace palpate
{
/// Numbers as DICOM's decimal strings: at most 16 characters each, with as many digits as fit but
/// at most `decimals` behind the point, separated by backslashes.
PALPATEIO_EXPORT std::string DicomDecimals(const std::vector<double>& numbers, int decimals = 15);

/// A name as DICOM's long string: at most 64 characters without backslash and control characters,
/// cut between characters of UTF-8.
PALPATEIO_EXPORT std::string DicomLongString(const std::string& name);

void PutDicomText(DcmItem& item, const DcmTagKey& tag, const std::string& text);
void PutDicomNumber(DcmItem& item, const DcmTagKey& tag, unsigned short number);
/// A new item at the end of a sequence, which is created if necessary.
DcmItem& NewDicomItem(DcmItem& parent, const DcmTagKey& sequence);
/// The term as a new item; returns that item.
DcmItem& PutDicomTerm(DcmItem& parent, const DcmTagKey& sequence, const CodedTerm& term);
/// References an instance as a new item; returns that item.
DcmItem& PutDicomReference(DcmItem& parent, const DcmTagKey& sequence, const std::string& sopClass,
                           const std::string& instance);
std::string NewDicomUid();

/// Writes the object, little endian, under AtomicFile's rules. With explicit value representations
/// a text has at most 64 kB. Throws InputError.
void SaveDicom(const std::filesystem::path& path, DcmFileFormat& object, bool isExplicit = true);
} // namespace palpate
