#include "DicomFrameDecoder.h"

#include "ChildProgram.h"
#include "FrameExchange.h"
#include "JpegFrameHeader.h"
#include "Refusal.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <unistd.h>

namespace palpate
{
namespace
{
constexpr const char* Program = "palpate-dicom-decoder";

// DCMTK's thresholds for fewer bits are not the standard's.
constexpr int LeastJpegLsPrecision = 8;

bool IsRead(PixelCoding coding, int marker)
{
  return coding == PixelCoding::JpegLs
             ? marker == JpegFrameHeader::JpegLs
             : marker == JpegFrameHeader::Baseline || marker == JpegFrameHeader::Extended ||
                   marker == JpegFrameHeader::Lossless;
}

// Bits per sample of the stream; empty if it does not match the frame.
std::optional<int> PrecisionOf(PixelCoding coding, const CompressedFrame& frame)
{
  const int most = 8 * frame.BytesPerPixel;
  if (coding == PixelCoding::RunLength)
  {
    return most;
  }
  const std::optional<JpegFrameHeader> header = ReadJpegFrameHeader(frame.Stream);
  const bool fits = header && IsRead(coding, header->Marker) && header->Columns == frame.Columns &&
                    header->Rows == frame.Rows && header->Components == 1 &&
                    header->Precision >= 2 && header->Precision <= std::min(16, most);
  return fits ? std::optional<int>(header->Precision) : std::nullopt;
}

FrameRequest RequestFor(PixelCoding coding, const CompressedFrame& frame, int precision)
{
  FrameRequest request;
  request.Coding = coding == PixelCoding::RunLength ? FrameRequest::Codec::RunLength
                   : coding == PixelCoding::Jpeg    ? FrameRequest::Codec::Jpeg
                                                    : FrameRequest::Codec::JpegLs;
  request.Columns = static_cast<std::uint32_t>(frame.Columns);
  request.Rows = static_cast<std::uint32_t>(frame.Rows);
  request.BytesPerSample = static_cast<std::uint32_t>((precision + 7) / 8);
  request.Precision = static_cast<std::uint32_t>(precision);
  request.StreamBytes = static_cast<std::uint32_t>(frame.Stream.size());
  return request;
}

void Store(const CompressedFrame& frame, const FrameRequest& request,
           const std::vector<std::uint8_t>& samples, std::uint8_t* pixels)
{
  const std::size_t size = request.BytesPerSample;
  for (std::size_t i = 0; i < frame.PixelCount(); ++i)
  {
    std::uint32_t sample = 0;
    for (std::size_t byte = 0; byte < size; ++byte)
    {
      sample |= std::uint32_t{samples[i * size + byte]} << (8 * byte);
    }
    frame.Store(sample, static_cast<int>(request.Precision), i, pixels);
  }
}
} // namespace

DicomFrameDecoder::~DicomFrameDecoder()
{
  this->Stop();
}

bool DicomFrameDecoder::Start()
{
  int sockets[2] = {-1, -1};
  if (this->Socket >= 0 || socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0)
  {
    return this->Socket >= 0;
  }
  this->Process = StartChildProgram(Program, {}, sockets[1]);
  close(sockets[1]);
  this->Socket = sockets[0];
  if (this->Process < 0)
  {
    this->Stop();
  }
  return this->Socket >= 0;
}

void DicomFrameDecoder::Stop() noexcept
{
  if (this->Socket >= 0)
  {
    close(this->Socket);
  }
  if (this->Process >= 0)
  {
    WaitForChildProgram(this->Process);
  }
  this->Socket = -1;
  this->Process = -1;
}

bool DicomFrameDecoder::Decode(const std::filesystem::path& file, PixelCoding coding,
                               const CompressedFrame& frame, std::uint8_t* pixels)
{
  const std::optional<int> precision = PrecisionOf(coding, frame);
  if (!precision || frame.Stream.size() > std::numeric_limits<std::uint32_t>::max())
  {
    return false;
  }
  if (coding == PixelCoding::JpegLs && *precision < LeastJpegLsPrecision)
  {
    Refuse(file,
           "has JPEG-LS pixels of " + std::to_string(*precision) + " bits, which are not supported",
           "export it again uncompressed or with at least eight bits per pixel");
  }
  if (!this->Start())
  {
    Refuse(file, std::string("is compressed, but ") + Program + " cannot be started to decode it",
           "install that program next to palpate or on the PATH");
  }
  const FrameRequest request = RequestFor(coding, frame, *precision);
  std::vector<std::uint8_t> samples(request.SampleBytes());
  if (!SendAll(this->Socket, &request, sizeof(request)) ||
      !SendAll(this->Socket, frame.Stream.data(), frame.Stream.size()) ||
      !ReceiveAll(this->Socket, samples.data(), samples.size()))
  {
    this->Stop();
    return false;
  }
  Store(frame, request, samples, pixels);
  return true;
}
} // namespace palpate
