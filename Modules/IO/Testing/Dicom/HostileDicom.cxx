#include "HostileDicom.h"

#include <zlib.h>

namespace palpate::test
{
namespace
{
constexpr std::uint32_t UndefinedLength = 0xFFFFFFFF;

std::string Number(std::uint32_t value, std::size_t bytes, bool isBigEndian = false)
{
  std::string text;
  for (std::size_t i = 0; i < bytes; ++i)
  {
    const std::size_t byte = isBigEndian ? bytes - 1 - i : i;
    text += static_cast<char>(value >> (8 * byte) & 255U);
  }
  return text;
}

std::string Tag(std::uint16_t group, std::uint16_t element, bool isBigEndian = false)
{
  return Number(group, 2, isBigEndian) + Number(element, 2, isBigEndian);
}

// Tag, representation and length of a sequence.
std::string SequenceHead(std::uint32_t length, DicomCoding coding)
{
  const bool isBigEndian = coding == DicomCoding::BigEndian;
  const std::string vr = coding == DicomCoding::Implicit ? "" : std::string("SQ\0\0", 4);
  // Referenced image sequence, which is in the dictionary, as implicit coding requires.
  return Tag(0x0008, 0x1140, isBigEndian) + vr + Number(length, 4, isBigEndian);
}

std::string ItemHead(std::uint32_t length, bool isBigEndian)
{
  return Tag(0xFFFE, 0xE000, isBigEndian) + Number(length, 4, isBigEndian);
}

std::string RawDeflated(const std::string& bytes)
{
  z_stream stream{};
  deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
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

std::string TransferSyntax(DicomCoding coding)
{
  switch (coding)
  {
  case DicomCoding::Implicit:
    return "1.2.840.10008.1.2";
  case DicomCoding::BigEndian:
    return "1.2.840.10008.1.2.2";
  case DicomCoding::Deflated:
    return "1.2.840.10008.1.2.1.99";
  case DicomCoding::Explicit:
    break;
  }
  return "1.2.840.10008.1.2.1";
}

std::string PlanePosition(const std::string& height)
{
  return DicomSequence(0x0020, 0x9113, {DicomElement(0x0020, 0x0032, "DS", "0\\0\\" + height)});
}

std::string SharedGroups(const ClaimedSegmentation& claim)
{
  return PlanePosition("0") +
         DicomSequence(0x0020, 0x9116, {DicomElement(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0")}) +
         DicomSequence(0x0028, 0x9110,
                       {DicomElement(0x0018, 0x0088, "DS", claim.Step) +
                        DicomElement(0x0028, 0x0030, "DS", "2\\2")}) +
         DicomSequence(0x0062, 0x000A, {DicomShort(0x0062, 0x000B, 1)});
}
} // namespace

std::string DicomElement(std::uint16_t group, std::uint16_t element, const std::string& vr,
                         const std::string& value)
{
  const std::string padded =
      value.size() % 2 == 0 ? value : value + (vr == "UI" || vr == "OB" ? '\0' : ' ');
  const auto length = static_cast<std::uint32_t>(padded.size());
  const bool isLong = vr == "SQ" || vr == "OB" || vr == "OW" || vr == "UN";
  return Tag(group, element) + vr +
         (isLong ? Number(0, 2) + Number(length, 4) : Number(length, 2)) + padded;
}

std::string DicomShort(std::uint16_t group, std::uint16_t element, int value)
{
  return DicomElement(group, element, "US", Number(static_cast<std::uint32_t>(value), 2));
}

std::string DicomSequence(std::uint16_t group, std::uint16_t element,
                          const std::vector<std::string>& items)
{
  std::string content;
  for (const std::string& item : items)
  {
    content += ItemHead(static_cast<std::uint32_t>(item.size()), false) + item;
  }
  return DicomElement(group, element, "SQ", content);
}

std::string DicomFile(const std::string& dataset, DicomCoding coding)
{
  const std::string syntax = DicomElement(0x0002, 0x0010, "UI", TransferSyntax(coding));
  const std::string length =
      DicomElement(0x0002, 0x0000, "UL", Number(static_cast<std::uint32_t>(syntax.size()), 4));
  return std::string(128, '\0') + "DICM" + length + syntax +
         (coding == DicomCoding::Deflated ? RawDeflated(dataset) : dataset);
}

std::string NestedDicomSequences(std::size_t levels, DicomCoding coding, bool definedLengths)
{
  const bool isBigEndian = coding == DicomCoding::BigEndian;
  const std::size_t sequenceHead = coding == DicomCoding::Implicit ? 8 : 12;
  constexpr std::size_t ItemHeadBytes = 8;
  std::string bytes;
  std::string ends;
  for (std::size_t left = levels; left > 0; --left)
  {
    const std::size_t inItem = (left - 1) * (sequenceHead + ItemHeadBytes);
    const auto item = static_cast<std::uint32_t>(inItem);
    bytes += SequenceHead(definedLengths ? item + ItemHeadBytes : UndefinedLength, coding);
    bytes += ItemHead(definedLengths ? item : UndefinedLength, isBigEndian);
    if (!definedLengths)
    {
      ends += Tag(0xFFFE, 0xE00D, isBigEndian) + Number(0, 4) + Tag(0xFFFE, 0xE0DD, isBigEndian) +
              Number(0, 4);
    }
  }
  return bytes + ends;
}

std::string ClaimedSegmentationBytes(const ClaimedSegmentation& claim)
{
  std::vector<std::string> frames;
  for (const std::string& height : claim.Heights)
  {
    frames.push_back(PlanePosition(height));
  }
  frames.resize(frames.size() + claim.EmptyItems);
  return DicomFile(
      DicomElement(0x0008, 0x0016, "UI", "1.2.840.10008.5.1.4.1.1.66.4") +
      DicomShort(0x0028, 0x0002, 1) + DicomElement(0x0028, 0x0008, "IS", claim.Frames) +
      DicomShort(0x0028, 0x0010, claim.Rows) + DicomShort(0x0028, 0x0011, claim.Columns) +
      DicomShort(0x0028, 0x0100, 1) + DicomElement(0x0062, 0x0001, "CS", "BINARY") +
      claim.MoreElements + DicomSequence(0x5200, 0x9229, {SharedGroups(claim)}) +
      DicomSequence(0x5200, 0x9230, frames) + DicomElement(0x7FE0, 0x0010, "OB", claim.Pixels));
}
} // namespace palpate::test
