#include "BoundedXmlParser.h"

#include "vtkInputStream.h"
#include "vtkObjectFactory.h"
#include "vtkXMLDataElement.h"

#include <cstring>

namespace palpate
{
namespace
{
constexpr unsigned int MostDepth = 32;
// LZMA, the strongest of VTK's compressors, reaches some thousand.
constexpr std::uint64_t MostBlockBytesFromByte = 8192;
constexpr std::uint64_t SmallBlock = std::uint64_t{1} << 20;
} // namespace

vtkStandardNewMacro(BoundedXmlParser);

void BoundedXmlParser::StartElement(const char* name, const char** attributes)
{
  if (++this->Depth > MostDepth)
  {
    this->TooDeep = true;
    return;
  }
  this->Superclass::StartElement(name, attributes);
}

void BoundedXmlParser::EndElement(const char* name)
{
  if (this->Depth-- <= MostDepth)
  {
    this->Superclass::EndElement(name);
  }
}

// Seeks to the first byte of an array's data, as the superclass does before reading.
void BoundedXmlParser::SeekData(vtkXMLDataElement* array)
{
  vtkTypeInt64 offset = 0;
  if (array->GetScalarAttribute("offset", offset) != 0)
  {
    this->DataStream = this->AppendedDataStream;
    this->DataStream->SetStream(this->Stream);
    this->Stream->clear();
    this->SeekG(this->AppendedDataPosition + offset);
    return;
  }
  this->DataStream = this->InlineDataStream;
  this->DataStream->SetStream(this->Stream);
  this->Stream->clear();
  this->SeekInlineDataPosition(array);
}

std::uint64_t BoundedXmlParser::StatedBlockCount()
{
  std::uint32_t narrow = 0;
  std::uint64_t wide = 0;
  void* const word = this->HeaderType == 64 ? static_cast<void*>(&wide) : &narrow;
  const std::size_t bytes = this->HeaderType == 64 ? sizeof wide : sizeof narrow;
  this->DataStream->StartReading();
  const std::size_t got = this->DataStream->Read(static_cast<unsigned char*>(word), bytes);
  this->DataStream->EndReading();
  this->PerformByteSwap(word, 1, bytes);
  return got < bytes ? 0 : wide + narrow;
}

bool BoundedXmlParser::HasSoundBlocks(vtkXMLDataElement* array, std::uint64_t fileBytes)
{
  const char* format = array->GetAttribute("format");
  const bool isBinary = array->GetAttribute("offset") != nullptr ||
                        (format != nullptr && std::strcmp(format, "binary") == 0);
  if (!isBinary || this->Compressor == nullptr)
  {
    return true;
  }
  this->SeekData(array);
  if (this->StatedBlockCount() > fileBytes)
  {
    return false;
  }
  this->SeekData(array);
  if (this->ReadCompressionHeader() == 0)
  {
    return false;
  }
  std::uint64_t packed = 0;
  for (std::size_t block = 0; block < this->NumberOfBlocks; ++block)
  {
    const std::uint64_t bytes = this->BlockCompressedSizes[block];
    packed += bytes;
    if (bytes > fileBytes || packed > fileBytes ||
        this->FindBlockSize(block) > SmallBlock + MostBlockBytesFromByte * bytes)
    {
      return false;
    }
  }
  // A stated size of the last block counts even if there are no blocks.
  return this->NumberOfBlocks == 0
             ? this->PartialLastBlockUncompressedSize == 0
             : this->BlockUncompressedSize > 0 &&
                   this->PartialLastBlockUncompressedSize <= this->BlockUncompressedSize &&
                   this->BlockUncompressedSize <= SmallBlock + MostBlockBytesFromByte * fileBytes;
}
} // namespace palpate
