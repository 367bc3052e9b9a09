#pragma once

#include "CompressedFrame.h"
#include "DicomTransferSyntax.h"
#include "PalpateIOModule.h"

#include <filesystem>
#include <sys/types.h>

namespace palpate
{
/// Decodes run-length, JPEG (baseline, extended, lossless) and JPEG-LS frames with DCMTK's codecs.
/// They run in a process of their own, palpate-dicom-decoder, because a damaged stream can violate
/// their assertions; it has limits on memory and time that follow from the frame. It is started
/// with the first frame and ends with the object.
class PALPATEIO_EXPORT DicomFrameDecoder
{
public:
  DicomFrameDecoder() = default;
  DicomFrameDecoder(const DicomFrameDecoder&) = delete;
  DicomFrameDecoder& operator=(const DicomFrameDecoder&) = delete;
  ~DicomFrameDecoder();

  /// Decodes a frame of `file` into `pixels`, which must be large enough. Returns false if the
  /// stream is damaged (also if the codec would only warn) or its size, depth or number of
  /// components differ from the frame's. Throws InputError for JPEG-LS of fewer than eight bits,
  /// for which DCMTK's thresholds differ from the standard's, and if the program is not installed.
  [[nodiscard]] bool Decode(const std::filesystem::path& file, PixelCoding coding,
                            const CompressedFrame& frame, std::uint8_t* pixels);

private:
  bool Start();
  void Stop() noexcept;

  int Socket = -1;
  pid_t Process = -1;
};
} // namespace palpate
