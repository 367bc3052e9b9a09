// palpate-dicom-decoder: decodes compressed DICOM frames with DCMTK's codecs, in a process of its
// own because they violate assertions on some damaged streams. Its standard input is the socket of
// a DicomFrameDecoder; it ends at the first frame that it cannot decode, or when its client ends.

#include "FrameExchange.h"
#include "ProcessLimits.h"

#include <csignal>
#include <iostream>
#include <memory>
#include <sstream>
#include <unistd.h>
#include <vector>

#include "dcmtk/config/osconfig.h"

#include "dcmtk/dcmdata/dcpixseq.h"
#include "dcmtk/dcmdata/dcpxitem.h"
#include "dcmtk/dcmdata/dcrledrg.h"
#include "dcmtk/dcmdata/dctk.h"
#include "dcmtk/dcmjpeg/djdecode.h"
#include "dcmtk/dcmjpls/djdecode.h"
#include "dcmtk/oflog/oflog.h"

namespace
{
using palpate::FrameRequest;

// Limits memory and time by the sizes of the frame and its stream, to several times the needs of
// the slowest codec.
void LimitFrame(const FrameRequest& request)
{
  constexpr rlim_t SomeMemory = rlim_t{64} << 20;
  constexpr rlim_t SomeSeconds = 5;
  constexpr rlim_t BytesPerSecond = rlim_t{8} << 20;
  const rlim_t bytes = request.SampleBytes() + request.StreamBytes;
  const rlim_t seconds = SomeSeconds + bytes / BytesPerSecond;
  palpate::LimitResource(RLIMIT_AS, palpate::MappedBytes() + SomeMemory + 8 * bytes);
  palpate::LimitResource(RLIMIT_CPU, palpate::ProcessorSeconds() + seconds);
  alarm(static_cast<unsigned int>(12 * seconds));
}

E_TransferSyntax SyntaxOf(FrameRequest::Codec codec)
{
  switch (codec)
  {
  case FrameRequest::Codec::RunLength:
    return EXS_RLELossless;
  case FrameRequest::Codec::Jpeg:
    return EXS_JPEGProcess14SV1; // its decoder also handles the other processes
  case FrameRequest::Codec::JpegLs:
    break;
  }
  return EXS_JPEGLSLossless;
}

void PutForm(DcmDataset& dataset, const FrameRequest& request)
{
  const auto put = [&](const DcmTagKey& tag, std::uint32_t value)
  { dataset.putAndInsertUint16(DcmTag(tag, EVR_US), static_cast<Uint16>(value)); };
  put(DCM_SamplesPerPixel, 1);
  put(DCM_Rows, request.Rows);
  put(DCM_Columns, request.Columns);
  put(DCM_BitsAllocated, 8 * request.BytesPerSample);
  put(DCM_BitsStored, request.Precision);
  put(DCM_HighBit, request.Precision - 1);
  put(DCM_PixelRepresentation, 0);
  dataset.putAndInsertString(DcmTag(DCM_PhotometricInterpretation, EVR_CS), "MONOCHROME2");
}

// The stream's length must be even.
void PutStream(DcmDataset& dataset, E_TransferSyntax syntax, const std::vector<Uint8>& stream)
{
  auto sequence = std::make_unique<DcmPixelSequence>(DcmTag(DCM_PixelData, EVR_OB));
  sequence->insert(new DcmPixelItem(DcmTag(DCM_Item, EVR_OB))); // an empty table of offsets
  auto item = std::make_unique<DcmPixelItem>(DcmTag(DCM_Item, EVR_OB));
  item->putUint8Array(stream.data(), stream.size());
  sequence->insert(item.release());
  auto pixels = std::make_unique<DcmPixelData>(DcmTag(DCM_PixelData, EVR_OB));
  pixels->putOriginalRepresentation(syntax, nullptr, sequence.release());
  dataset.insert(pixels.release(), OFTrue);
}

// Returns false if the frame is damaged, also if DCMTK would only warn.
bool AnswerFrame(int socket, const FrameRequest& request, std::ostringstream& warnings)
{
  std::vector<Uint8> stream((request.StreamBytes + std::size_t{1}) / 2 * 2);
  if (!palpate::ReceiveAll(socket, stream.data(), request.StreamBytes))
  {
    return false;
  }
  const E_TransferSyntax syntax = SyntaxOf(request.Coding);
  DcmDataset dataset;
  PutForm(dataset, request);
  PutStream(dataset, syntax, stream);
  const Uint16* words = nullptr;
  unsigned long count = 0;
  return dataset.chooseRepresentation(EXS_LittleEndianExplicit, nullptr).good() &&
         dataset.findAndGetUint16Array(DCM_PixelData, words, &count).good() &&
         2 * static_cast<std::size_t>(count) == (request.SampleBytes() + 1) / 2 * 2 &&
         warnings.str().empty() && palpate::SendAll(socket, words, request.SampleBytes());
}
} // namespace

int main()
{
  palpate::LimitResource(RLIMIT_CORE, 0);
  DcmRLEDecoderRegistration::registerCodecs();
  DJDecoderRegistration::registerCodecs(EDC_never, EUC_never);
  DJLSDecoderRegistration::registerCodecs();
  OFLog::configure(OFLogger::WARN_LOG_LEVEL);
  std::ostringstream warnings; // DCMTK's log goes there
  std::streambuf* const errors = std::cerr.rdbuf(warnings.rdbuf());
  FrameRequest request;
  bool isGood = true;
  while (isGood && palpate::ReceiveAll(STDIN_FILENO, &request, sizeof(request)))
  {
    LimitFrame(request);
    isGood = AnswerFrame(STDIN_FILENO, request, warnings);
    alarm(0);
  }
  std::cerr.rdbuf(errors);
  return isGood ? 0 : 1;
}
