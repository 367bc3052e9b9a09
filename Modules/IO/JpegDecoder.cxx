#include "JpegDecoder.h"

#include "JpegSegments.h"

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmjpeg/djcparam.h"
#include "dcmtk/dcmjpeg/djdijg12.h"
#include "dcmtk/dcmjpeg/djdijg16.h"
#include "dcmtk/dcmjpeg/djdijg8.h"

namespace palpate
{
namespace
{
// A decoder of DCMTK's that notices the library's warnings (levels below 0). The layer above these
// decoders is passed by: its search for the precision does not end on some damaged streams.
template <typename Decoder>
class NoticingDecoder : public Decoder
{
public:
  explicit NoticingDecoder(const DJCodecParameter& parameter) : Decoder(parameter, OFFalse) {}
  void emitMessage(int level) const override { this->HasWarned = this->HasWarned || level < 0; }

  mutable bool HasWarned = false; // the library's callback is const
};

bool Fits(const JpegFrameHeader& header, const CompressedFrame& frame)
{
  const bool isSequential = header.Process == JpegMarker::BaselineFrame ||
                            header.Process == JpegMarker::ExtendedFrame ||
                            header.Process == JpegMarker::LosslessFrame;
  return isSequential && header.Columns == frame.Columns && header.Rows == frame.Rows &&
         header.Components == 1 && header.Precision >= 2 && header.Precision <= 16 &&
         header.Precision <= 8 * frame.BytesPerPixel;
}

template <typename Decoder, typename Sample>
bool Decode(const CompressedFrame& frame, int precision, std::uint8_t* pixels)
{
  const DJCodecParameter parameter(ECC_monochrome, EDC_never, EUC_never, EPC_default);
  NoticingDecoder<Decoder> decoder(parameter);
  std::vector<Sample> samples(frame.PixelCount());
  // Suspension, which asks for a further fragment, is no success either.
  if (decoder.init().bad() ||
      decoder
          .decode(const_cast<Uint8*>(frame.Stream.data()), static_cast<Uint32>(frame.Stream.size()),
                  reinterpret_cast<Uint8*>(samples.data()),
                  static_cast<Uint32>(samples.size() * sizeof(Sample)), OFFalse)
          .bad() ||
      decoder.HasWarned)
  {
    return false;
  }
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    frame.Store(samples[i], precision, i, pixels);
  }
  return true;
}
} // namespace

bool DecodeJpeg(const CompressedFrame& frame, std::uint8_t* pixels)
{
  const std::optional<JpegFrameHeader> header =
      ReadJpegFrameHeader(frame.Stream, ReadJpegSegments(frame.Stream));
  if (!header || !Fits(*header, frame))
  {
    return false;
  }
  if (header->Precision <= 8)
  {
    return Decode<DJDecompressIJG8Bit, std::uint8_t>(frame, header->Precision, pixels);
  }
  if (header->Precision <= 12)
  {
    return Decode<DJDecompressIJG12Bit, std::uint16_t>(frame, header->Precision, pixels);
  }
  return Decode<DJDecompressIJG16Bit, std::uint16_t>(frame, header->Precision, pixels);
}
} // namespace palpate
