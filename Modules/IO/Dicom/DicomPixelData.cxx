#include "DicomPixelData.h"

#include "AvailableMemory.h"
#include "CompressedFrame.h"
#include "DecimalText.h"
#include "DicomFrameDecoder.h"
#include "DicomPixels.h"
#include "DicomTransferSyntax.h"
#include "EncapsulatedFrames.h"
#include "Jpeg2000Decoder.h"
#include "Refusal.h"

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dcdeftag.h"
#include <algorithm>
#include <string>

namespace palpate
{
namespace
{
// Empty frames compress to a thousandth or less, but no real file to a ten-thousandth.
constexpr double MostBytesFromAnything = 64e6;
constexpr double MostPixelBytesFromByte = 16384.0;

// A header and a stream of a few bytes must not cause gigabytes to be allocated and filled.
void CheckRatio(const std::filesystem::path& file, double pixelBytes, std::size_t streamBytes)
{
  const double most =
      std::max(MostBytesFromAnything, MostPixelBytesFromByte * static_cast<double>(streamBytes));
  if (!(pixelBytes <= most))
  {
    Refuse(file,
           "is damaged: its header declares " + SignificantText(pixelBytes / 1e9) +
               " GB of pixels, but there are " + std::to_string(streamBytes) + " compressed bytes",
           "copy or export it again");
  }
}
} // namespace

void CheckTransferSyntax(const std::filesystem::path& file, const std::string& transferSyntaxUid)
{
  if (PixelCodingOf(transferSyntaxUid) == PixelCoding::Unread)
  {
    Refuse(file,
           "stores its pixels in the transfer syntax " + TransferSyntaxName(transferSyntaxUid) +
               ", which is not supported",
           "export it again uncompressed or as RLE, JPEG, JPEG-LS or JPEG 2000");
  }
}

DicomPixelData::DicomPixelData(const std::filesystem::path& file, const DicomDataset& dataset,
                               std::size_t frameCount, DicomFrameDecoder& decoder)
{
  CheckTransferSyntax(file, dataset.TransferSyntax());
  if (PixelCodingOf(dataset.TransferSyntax()) != PixelCoding::Native)
  {
    this->Decode(file, dataset, frameCount, decoder);
    return;
  }
  this->Native = DicomPixelBytes(dataset.Root(), this->Count);
}

void DicomPixelData::Decode(const std::filesystem::path& file, const DicomDataset& dataset,
                            std::size_t frameCount, DicomFrameDecoder& decoder)
{
  const DicomPixelFormat format = ReadPixelFormat(dataset);
  CompressedFrame frame;
  frame.Columns = DicomInteger(dataset.Root(), DCM_Columns, 0);
  frame.Rows = DicomInteger(dataset.Root(), DCM_Rows, 0);
  frame.BytesPerPixel = format.BitsAllocated / 8;
  frame.BitsStored = format.BitsStored;
  frame.HighBit = format.HighBit;
  frame.IsSigned = format.IsSigned;
  const EncapsulatedFrames frames(dataset.Root(), frameCount);
  if (!format.IsPlausible() || frame.Columns < 1 || frame.Rows < 1 || !frames.AreFound())
  {
    Refuse(file, "is truncated or damaged: its pixel data do not match its header",
           "copy or export it again");
  }
  const std::size_t frameBytes = frame.PixelCount() * static_cast<std::size_t>(frame.BytesPerPixel);
  const double allBytes = static_cast<double>(frameBytes) * static_cast<double>(frameCount);
  CheckRatio(file, allBytes, frames.ByteCount());
  CheckMemory(file, allBytes);
  this->Count = frameBytes * frameCount;
  this->Decoded.resize(this->Count);
  const PixelCoding coding = PixelCodingOf(dataset.TransferSyntax());
  for (std::size_t i = 0; i < frameCount; ++i)
  {
    frame.Stream = frames.Frame(i);
    std::uint8_t* pixels = this->Decoded.data() + i * frameBytes;
    if (!(coding == PixelCoding::Jpeg2000 ? DecodeJpeg2000(frame, pixels)
                                          : decoder.Decode(file, coding, frame, pixels)))
    {
      Refuse(file,
             "is truncated or damaged: its pixels cannot be decoded as " +
                 TransferSyntaxName(dataset.TransferSyntax()),
             "copy or export it again");
    }
  }
}
} // namespace palpate
