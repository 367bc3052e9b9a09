#include "EncapsulatedFrames.h"

#include <numeric>

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dcdeftag.h"
#include "dcmtk/dcmdata/dcitem.h"
#include "dcmtk/dcmdata/dcpixel.h"
#include "dcmtk/dcmdata/dcpixseq.h"
#include "dcmtk/dcmdata/dcpxitem.h"

namespace palpate
{
namespace
{
// Tag and length before each fragment, which offsets include.
constexpr std::uint64_t ItemHeaderBytes = 8;

DcmPixelSequence* FindSequence(DcmItem& root)
{
  DcmElement* element = nullptr;
  if (root.findAndGetElement(DCM_PixelData, element).bad())
  {
    return nullptr;
  }
  auto* pixels = dynamic_cast<DcmPixelData*>(element);
  if (!pixels)
  {
    return nullptr;
  }
  E_TransferSyntax syntax = EXS_Unknown;
  const DcmRepresentationParameter* parameter = nullptr;
  DcmPixelSequence* sequence = nullptr;
  pixels->getOriginalRepresentationKey(syntax, parameter);
  return pixels->getEncapsulatedRepresentation(syntax, parameter, sequence).good() ? sequence
                                                                                   : nullptr;
}

const Uint8* BytesOf(DcmPixelItem& item)
{
  Uint8* bytes = nullptr;
  return item.getUint8Array(bytes).good() ? bytes : nullptr;
}

std::vector<std::uint64_t> Offsets(DcmPixelItem& table)
{
  std::vector<std::uint64_t> offsets;
  const Uint8* bytes = BytesOf(table);
  for (std::size_t i = 0; bytes && i + 4 <= table.getLength(); i += 4)
  {
    offsets.push_back(bytes[i] | bytes[i + 1] << 8 | bytes[i + 2] << 16 |
                      std::uint64_t{bytes[i + 3]} << 24);
  }
  return offsets;
}

// True for the first marker of a JPEG, JPEG-LS or JPEG 2000 stream.
bool StartsStream(DcmPixelItem& item)
{
  const Uint8* bytes = BytesOf(item);
  return bytes && item.getLength() >= 2 && bytes[0] == 0xFF &&
         (bytes[1] == 0xD8 || bytes[1] == 0x4F);
}
} // namespace

EncapsulatedFrames::EncapsulatedFrames(DcmItem& root, std::size_t frameCount)
{
  if (!this->CollectFragments(root) || this->Fragments.size() < frameCount)
  {
    return;
  }
  if (frameCount == 1)
  {
    this->FirstFragments = {0, this->Fragments.size()};
    return;
  }
  if (this->Fragments.size() == frameCount)
  {
    this->FirstFragments.resize(frameCount + 1);
    std::iota(this->FirstFragments.begin(), this->FirstFragments.end(), std::size_t{0});
    return;
  }
  this->DivideByOffsets(frameCount);
  if (!this->AreFound())
  {
    this->DivideByMarks(frameCount);
  }
}

bool EncapsulatedFrames::CollectFragments(DcmItem& root)
{
  DcmPixelSequence* sequence = FindSequence(root);
  if (!sequence || sequence->getItem(this->OffsetTable, 0).bad())
  {
    return false;
  }
  // Not by index, since DCMTK walks the list from its start for each index.
  for (DcmObject* next = this->OffsetTable; (next = sequence->nextInContainer(next)) != nullptr;)
  {
    auto* item = dynamic_cast<DcmPixelItem*>(next);
    if (item == nullptr)
    {
      return false;
    }
    this->Fragments.push_back(item);
  }
  return true;
}

void EncapsulatedFrames::DivideByOffsets(std::size_t frameCount)
{
  const std::vector<std::uint64_t> offsets = Offsets(*this->OffsetTable);
  std::vector<std::size_t> first;
  std::uint64_t place = 0;
  for (std::size_t i = 0; i < this->Fragments.size(); ++i)
  {
    if (first.size() < offsets.size() && place == offsets[first.size()])
    {
      first.push_back(i);
    }
    place += ItemHeaderBytes + this->Fragments[i]->getLength();
  }
  if (offsets.size() == frameCount && first.size() == frameCount && first.front() == 0)
  {
    first.push_back(this->Fragments.size());
    this->FirstFragments = first;
  }
}

void EncapsulatedFrames::DivideByMarks(std::size_t frameCount)
{
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < this->Fragments.size(); ++i)
  {
    if (StartsStream(*this->Fragments[i]))
    {
      first.push_back(i);
    }
  }
  if (first.size() == frameCount && first.front() == 0)
  {
    first.push_back(this->Fragments.size());
    this->FirstFragments = first;
  }
}

std::size_t EncapsulatedFrames::ByteCount() const
{
  std::size_t bytes = 0;
  for (DcmPixelItem* fragment : this->Fragments)
  {
    bytes += fragment->getLength();
  }
  return bytes;
}

std::vector<std::uint8_t> EncapsulatedFrames::Frame(std::size_t frame) const
{
  std::vector<std::uint8_t> stream;
  for (std::size_t i = this->FirstFragments[frame]; i < this->FirstFragments[frame + 1]; ++i)
  {
    if (const Uint8* bytes = BytesOf(*this->Fragments[i]))
    {
      stream.insert(stream.end(), bytes, bytes + this->Fragments[i]->getLength());
    }
  }
  return stream;
}
} // namespace palpate
