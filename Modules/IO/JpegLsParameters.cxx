#include "JpegLsParameters.h"

#include "JpegSegments.h"

#include <algorithm>

namespace palpate
{
namespace
{
// Parameters that a stream states; 0 where it leaves one to its default.
struct Preset
{
  int MaximumValue = 0;
  int Threshold1 = 0;
  int Threshold2 = 0;
  int Threshold3 = 0;
  int Reset = 0;
};

bool ReadPreset(const std::vector<std::uint8_t>& stream, const JpegSegment& segment, Preset& preset)
{
  // Identifier 1: five words. The others are mapping tables and sizes above 65535.
  if (segment.End - segment.First != 11 || stream[segment.First] != 1)
  {
    return false;
  }
  const auto word = [&](std::size_t index)
  { return JpegWord(stream, segment.First + 1 + 2 * index); };
  preset = {word(0), word(1), word(2), word(3), word(4)};
  return true;
}

// One component without mapping table or point transform: its NEAR, else -1.
int ReadNear(const std::vector<std::uint8_t>& stream, const JpegSegment& scan)
{
  if (scan.End - scan.First != 6 || stream[scan.First] != 1 || stream[scan.First + 2] != 0 ||
      stream[scan.First + 4] != 0 || stream[scan.First + 5] != 0)
  {
    return -1;
  }
  return stream[scan.First + 3];
}

int BitsFor(int values)
{
  int bits = 0;
  while ((1 << bits) < values)
  {
    ++bits;
  }
  return bits;
}

// The standard's CLAMP: the default itself gives way where it is out of range.
int ClampThreshold(int threshold, int lowest, int maximumValue)
{
  return threshold > maximumValue || threshold < lowest ? lowest : threshold;
}

// Default thresholds (T.87, C.2.4.1.1), where the stream states none.
void SetThresholds(const Preset& preset, JpegLsParameters& parameters)
{
  const int maximum = parameters.MaximumValue;
  const int near = parameters.Near;
  int first = 0;
  int second = 0;
  int third = 0;
  if (maximum >= 128)
  {
    const int factor = (std::min(maximum, 4095) + 128) / 256;
    first = factor * (3 - 2) + 2 + 3 * near;
    second = factor * (7 - 3) + 3 + 5 * near;
    third = factor * (21 - 4) + 4 + 7 * near;
  }
  else
  {
    const int factor = 256 / (maximum + 1);
    first = std::max(2, 3 / factor + 3 * near);
    second = std::max(3, 7 / factor + 5 * near);
    third = std::max(4, 21 / factor + 7 * near);
  }
  const auto choose = [&](int stated, int usual, int lowest)
  { return stated != 0 ? stated : ClampThreshold(usual, lowest, maximum); };
  parameters.Threshold1 = choose(preset.Threshold1, first, near + 1);
  parameters.Threshold2 = choose(preset.Threshold2, second, parameters.Threshold1);
  parameters.Threshold3 = choose(preset.Threshold3, third, parameters.Threshold2);
}

bool IsValid(const JpegLsParameters& parameters)
{
  return parameters.MaximumValue < (1 << parameters.Precision) &&
         parameters.Near <= std::min(255, parameters.MaximumValue / 2) &&
         parameters.Threshold1 >= parameters.Near + 1 &&
         parameters.Threshold2 >= parameters.Threshold1 &&
         parameters.Threshold3 >= parameters.Threshold2 &&
         parameters.Threshold3 <= parameters.MaximumValue && parameters.Reset >= 3 &&
         parameters.Reset <= std::max(255, parameters.MaximumValue);
}

std::optional<JpegLsParameters> Derive(int precision, int near, const Preset& preset)
{
  JpegLsParameters parameters;
  parameters.Precision = precision;
  parameters.MaximumValue = preset.MaximumValue != 0 ? preset.MaximumValue : (1 << precision) - 1;
  parameters.Near = near;
  parameters.Reset = preset.Reset != 0 ? preset.Reset : 64;
  SetThresholds(preset, parameters);
  if (!IsValid(parameters))
  {
    return std::nullopt;
  }
  parameters.Range = (parameters.MaximumValue + 2 * near) / (2 * near + 1) + 1;
  parameters.RangeBits = BitsFor(parameters.Range);
  const int bits = std::max(2, BitsFor(parameters.MaximumValue + 1));
  parameters.Limit = 2 * (bits + std::max(8, bits));
  return parameters;
}

bool Fits(const JpegFrameHeader& header, const CompressedFrame& frame)
{
  return header.Process == JpegMarker::JpegLsFrame && header.Columns == frame.Columns &&
         header.Rows == frame.Rows && header.Components == 1 && header.Precision >= 2 &&
         header.Precision <= 16 && header.Precision <= 8 * frame.BytesPerPixel;
}
} // namespace

std::optional<JpegLsParameters> ReadJpegLsParameters(const CompressedFrame& frame)
{
  const std::vector<JpegSegment> segments = ReadJpegSegments(frame.Stream);
  const std::optional<JpegFrameHeader> header = ReadJpegFrameHeader(frame.Stream, segments);
  if (!header || !Fits(*header, frame))
  {
    return std::nullopt;
  }
  Preset preset;
  for (const JpegSegment& segment : segments)
  {
    const bool isPreset = segment.Marker == JpegMarker::JpegLsParameters;
    if ((isPreset && !ReadPreset(frame.Stream, segment, preset)) ||
        segment.Marker == JpegMarker::RestartInterval)
    {
      return std::nullopt;
    }
  }
  const int near = ReadNear(frame.Stream, segments.back());
  std::optional<JpegLsParameters> parameters;
  if (near >= 0)
  {
    parameters = Derive(header->Precision, near, preset);
  }
  if (parameters)
  {
    parameters->ScanStart = segments.back().End;
  }
  return parameters;
}
} // namespace palpate
