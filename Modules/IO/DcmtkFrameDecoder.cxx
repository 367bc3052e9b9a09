#include "DcmtkFrameDecoder.h"

#include "DicomDataset.h"
#include "JpegFrameHeader.h"

#include <memory>

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dcpixseq.h"
#include "dcmtk/dcmdata/dcpxitem.h"
#include "dcmtk/dcmdata/dctk.h"
#include "dcmtk/dcmjpeg/djdecode.h"
#include "dcmtk/dcmjpls/djdecode.h"

namespace palpate
{
namespace
{
// DCMTK ignores every call but the first.
void RegisterDecoders()
{
  DJDecoderRegistration::registerCodecs(EDC_never, EUC_never);
  DJLSDecoderRegistration::registerCodecs(EJLSUC_never);
}

// The transfer syntax that stands for what the stream really is; EXS_Unknown for what is not read.
// A progressive stream could ask for any number of passes over the image.
E_TransferSyntax SyntaxOf(const JpegFrameHeader& header)
{
  switch (header.Process)
  {
  case 0xC0:
  case 0xC1:
    return EXS_JPEGProcess2_4;
  case 0xC3:
    return EXS_JPEGProcess14;
  case 0xF7:
    return EXS_JPEGLSLossless;
  default:
    return EXS_Unknown;
  }
}

bool Fits(const JpegFrameHeader& header, const CompressedFrame& frame)
{
  return header.Columns == frame.Columns && header.Rows == frame.Rows && header.Components == 1 &&
         header.Precision >= 1 && header.Precision <= 16 &&
         header.Precision <= 8 * frame.BytesPerPixel;
}

bool PutPixels(DcmDataset& dataset, const CompressedFrame& frame, E_TransferSyntax syntax)
{
  auto pixels = std::make_unique<DcmPixelData>(DcmTag(DCM_PixelData, EVR_OB));
  auto sequence = std::make_unique<DcmPixelSequence>(DcmTag(DCM_PixelSequenceTag));
  DcmOffsetList offsets;
  // An empty offset table, then the frame.
  if (sequence->insert(new DcmPixelItem(DcmTag(DCM_Item))).bad() ||
      sequence
          ->storeCompressedFrame(offsets, const_cast<Uint8*>(frame.Stream.data()),
                                 static_cast<Uint32>(frame.Stream.size()), 0)
          .bad())
  {
    return false;
  }
  pixels->putOriginalRepresentation(syntax, nullptr, sequence.release());
  return dataset.insert(pixels.release()).good();
}

// A data set of its own, described by the stream itself: DCMTK then neither sees what the file says
// of fragments nor where that and the stream's depth differ.
bool PutFrame(DcmDataset& dataset, const CompressedFrame& frame, const JpegFrameHeader& header,
              E_TransferSyntax syntax)
{
  const auto put = [&](const DcmTagKey& tag, int value)
  { return dataset.putAndInsertUint16(tag, static_cast<Uint16>(value)).good(); };
  return put(DCM_SamplesPerPixel, 1) &&
         dataset.putAndInsertString(DCM_PhotometricInterpretation, "MONOCHROME2").good() &&
         put(DCM_Rows, header.Rows) && put(DCM_Columns, header.Columns) &&
         put(DCM_BitsAllocated, header.Precision > 8 ? 16 : 8) &&
         put(DCM_BitsStored, header.Precision) && put(DCM_HighBit, header.Precision - 1) &&
         put(DCM_PixelRepresentation, 0) && PutPixels(dataset, frame, syntax);
}
} // namespace

bool DecodeWithDcmtk(const CompressedFrame& frame, std::uint8_t* pixels)
{
  const std::optional<JpegFrameHeader> header = ReadJpegFrameHeader(frame.Stream);
  if (!header || !Fits(*header, frame) || SyntaxOf(*header) == EXS_Unknown)
  {
    return false;
  }
  RegisterDecoders();
  DcmDataset dataset;
  if (!PutFrame(dataset, frame, *header, SyntaxOf(*header)) ||
      dataset.chooseRepresentation(EXS_LittleEndianExplicit, nullptr).bad())
  {
    return false;
  }
  std::size_t count = 0;
  const std::uint8_t* decoded = DicomPixelBytes(dataset, count);
  const std::size_t size = header->Precision > 8 ? 2 : 1;
  if (!decoded || count < size * frame.PixelCount())
  {
    return false;
  }
  for (std::size_t i = 0; i < frame.PixelCount(); ++i)
  {
    const std::uint32_t high = size == 2 ? decoded[2 * i + 1] : 0;
    frame.Store(decoded[size * i] | high << 8, header->Precision, i, pixels);
  }
  return true;
}
} // namespace palpate
