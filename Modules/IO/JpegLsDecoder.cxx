#include "JpegLsDecoder.h"

#include "JpegLsBits.h"
#include "JpegLsParameters.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace palpate
{
namespace
{
// J of the standard: log2 of the lengths of runs.
constexpr std::array<int, 32> RunBits{0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2,  2,  3,  3,  3,  3,
                                      4, 4, 5, 5, 6, 6, 7, 7, 8, 9, 10, 11, 12, 13, 14, 15};

// A context's counts: A, B, C, N of the standard. They stay small: they are halved at RESET, and no
// error is larger than RANGE.
struct Context
{
  std::int64_t ErrorSum = 0;
  std::int64_t Bias = 0;
  int Correction = 0;
  int Count = 1;
};

// Of the two kinds of pixels that end a run: A, N, Nn.
struct RunContext
{
  std::int64_t ErrorSum = 0;
  int Count = 1;
  int NegativeCount = 0;
};

int GolombBits(std::int64_t errorSum, int count)
{
  int bits = 0;
  while ((std::int64_t{count} << bits) < errorSum)
  {
    ++bits;
  }
  return bits;
}

// One scan of one component. Lines have a place more at either end for their neighbours.
class Scan
{
public:
  Scan(const JpegLsParameters& parameters, const CompressedFrame& frame)
      : Form(parameters),
        Bits(frame.Stream.data() + parameters.ScanStart, frame.Stream.data() + frame.Stream.size()),
        Columns(frame.Columns), Above(static_cast<std::size_t>(frame.Columns) + 2, 0), Line(Above)
  {
    const std::int64_t start = std::max(2, (parameters.Range + 32) / 64);
    this->Contexts.fill({start, 0, 0, 1});
    this->RunContexts.fill({start, 1, 0});
  }

  // False where the bits end or make no sense.
  bool DecodeLine()
  {
    std::swap(this->Above, this->Line);
    this->Above.back() = this->Above[this->Above.size() - 2];
    this->Line.front() = this->Above[1];
    int column = 1;
    while (column <= this->Columns && this->IsGood && !this->Bits.HasEnded())
    {
      column = this->DecodeNext(column);
    }
    return this->IsGood && !this->Bits.HasEnded();
  }
  // After the last line: a damaged scan hardly ends where its bits do.
  bool IsAtEnd() const { return this->Bits.IsAtMarker(); }
  int Value(int column) const { return this->Line[static_cast<std::size_t>(column) + 1]; }

private:
  int Quantize(int gradient) const;
  int Restore(int predicted, int error) const;
  int ReadMappedError(int golombBits, int limit);
  int DecodeNext(int column);
  int DecodeRegular(int context, int left, int above, int corner);
  int DecodeRun(int column);
  int DecodeRunEnd(int left, int above);

  const JpegLsParameters& Form;
  JpegLsBits Bits;
  int Columns;
  std::vector<int> Above;
  std::vector<int> Line;
  std::array<Context, 365> Contexts;
  std::array<RunContext, 2> RunContexts;
  std::size_t RunIndex = 0;
  bool IsGood = true;
};

// The pixel of a line's place, and how far to go on.
int Scan::DecodeNext(int column)
{
  const auto place = static_cast<std::size_t>(column);
  const int left = this->Line[place - 1];
  const int above = this->Above[place];
  const int corner = this->Above[place - 1];
  const int right = this->Above[place + 1];
  const int context = 81 * this->Quantize(right - above) + 9 * this->Quantize(above - corner) +
                      this->Quantize(corner - left);
  if (context == 0)
  {
    return this->DecodeRun(column);
  }
  this->Line[place] = this->DecodeRegular(context, left, above, corner);
  return column + 1;
}

int Scan::Quantize(int gradient) const
{
  const int size = std::abs(gradient);
  const int region = size <= this->Form.Near        ? 0
                     : size < this->Form.Threshold1 ? 1
                     : size < this->Form.Threshold2 ? 2
                     : size < this->Form.Threshold3 ? 3
                                                    : 4;
  return gradient < 0 ? -region : region;
}

// The sample of a prediction and an error, which is coded modulo the range (A.4.4, A.8).
int Scan::Restore(int predicted, int error) const
{
  const int step = 2 * this->Form.Near + 1;
  int value = predicted + error * step;
  if (value < -this->Form.Near)
  {
    value += this->Form.Range * step;
  }
  else if (value > this->Form.MaximumValue + this->Form.Near)
  {
    value -= this->Form.Range * step;
  }
  return std::clamp(value, 0, this->Form.MaximumValue);
}

// A Golomb code of limited length (A.5.3). No error maps to more than the range.
int Scan::ReadMappedError(int golombBits, int limit)
{
  const int most = limit - this->Form.RangeBits - 1;
  const int zeros = this->Bits.ReadZeros(most);
  if (zeros > most || golombBits > this->Form.RangeBits)
  {
    this->IsGood = false;
    return 0;
  }
  const std::int64_t mapped =
      zeros < most ? (std::int64_t{zeros} << golombBits) + this->Bits.Read(golombBits)
                   : std::int64_t{this->Bits.Read(this->Form.RangeBits)} + 1;
  this->IsGood = this->IsGood && mapped <= this->Form.Range;
  return this->IsGood ? static_cast<int>(mapped) : 0;
}

// Regular mode (A.4 to A.6); a context of negative sign is its mirror image.
int Scan::DecodeRegular(int context, int left, int above, int corner)
{
  const int sign = context < 0 ? -1 : 1;
  Context& state = this->Contexts[static_cast<std::size_t>(std::abs(context))];
  const int lowest = std::min(left, above);
  const int highest = std::max(left, above);
  const int edge = corner >= highest ? lowest : corner <= lowest ? highest : left + above - corner;
  const int predicted = std::clamp(edge + sign * state.Correction, 0, this->Form.MaximumValue);

  const int bits = GolombBits(state.ErrorSum, state.Count);
  const int mapped = this->ReadMappedError(bits, this->Form.Limit);
  int error = mapped % 2 == 0 ? mapped / 2 : -(mapped + 1) / 2;
  if (this->Form.Near == 0 && bits == 0 && 2 * state.Bias <= -state.Count)
  {
    error = -error - 1; // the signs change places
  }
  state.ErrorSum += std::abs(error);
  state.Bias += std::int64_t{error} * (2 * this->Form.Near + 1);
  if (state.Count == this->Form.Reset)
  {
    state.ErrorSum >>= 1;
    state.Bias = state.Bias >= 0 ? state.Bias >> 1 : -((1 - state.Bias) >> 1);
    state.Count >>= 1;
  }
  ++state.Count;
  if (state.Bias <= -state.Count)
  {
    state.Bias = std::max<std::int64_t>(state.Bias + state.Count, 1 - state.Count);
    state.Correction = std::max(state.Correction - 1, -128);
  }
  else if (state.Bias > 0)
  {
    state.Bias = std::min<std::int64_t>(state.Bias - state.Count, 0);
    state.Correction = std::min(state.Correction + 1, 127);
  }
  return this->Restore(predicted, sign * error);
}

// Run mode (A.7): equal pixels, then one that ends them unless the line does. The next column.
int Scan::DecodeRun(int column)
{
  const int value = this->Line[static_cast<std::size_t>(column) - 1];
  const auto fill = [&](int count)
  {
    std::fill_n(this->Line.begin() + column, count, value);
    column += count;
  };
  while (this->Bits.Read(1) == 1)
  {
    const int length = 1 << RunBits[this->RunIndex];
    const int left = this->Columns + 1 - column;
    fill(std::min(length, left));
    if (length <= left)
    {
      this->RunIndex = std::min<std::size_t>(this->RunIndex + 1, 31);
    }
    if (column > this->Columns)
    {
      return column;
    }
  }
  const int rest = static_cast<int>(this->Bits.Read(RunBits[this->RunIndex]));
  if (column + rest > this->Columns)
  {
    this->IsGood = false;
    return column;
  }
  fill(rest);
  this->Line[static_cast<std::size_t>(column)] =
      this->DecodeRunEnd(value, this->Above[static_cast<std::size_t>(column)]);
  this->RunIndex -= this->RunIndex > 0 ? 1 : 0;
  return column + 1;
}

// The pixel that ends a run (A.7.2).
int Scan::DecodeRunEnd(int left, int above)
{
  const bool isFlat = std::abs(left - above) <= this->Form.Near;
  const int kind = isFlat ? 1 : 0;
  RunContext& state = this->RunContexts[static_cast<std::size_t>(kind)];
  const int bits = GolombBits(state.ErrorSum + (isFlat ? state.Count >> 1 : 0), state.Count);
  const int mapped = this->ReadMappedError(bits, this->Form.Limit - RunBits[this->RunIndex] - 1);
  const int size = (mapped + kind + 1) / 2;
  const bool isOdd = (mapped + kind) % 2 != 0;
  const bool isOddNegative = bits != 0 || 2 * state.NegativeCount >= state.Count;
  const int error = isOdd == isOddNegative ? -size : size;
  state.NegativeCount += error < 0 ? 1 : 0;
  state.ErrorSum += (mapped + 1 - kind) >> 1;
  if (state.Count == this->Form.Reset)
  {
    state.ErrorSum >>= 1;
    state.Count >>= 1;
    state.NegativeCount >>= 1;
  }
  ++state.Count;
  const int sign = !isFlat && left > above ? -1 : 1;
  return this->Restore(isFlat ? left : above, sign * error);
}
} // namespace

bool DecodeJpegLs(const CompressedFrame& frame, std::uint8_t* pixels)
{
  const std::optional<JpegLsParameters> parameters = ReadJpegLsParameters(frame);
  if (!parameters)
  {
    return false;
  }
  Scan scan(*parameters, frame);
  std::size_t pixel = 0;
  for (int row = 0; row < frame.Rows; ++row)
  {
    if (!scan.DecodeLine())
    {
      return false;
    }
    for (int column = 0; column < frame.Columns; ++column)
    {
      frame.Store(static_cast<std::uint32_t>(scan.Value(column)), parameters->Precision, pixel++,
                  pixels);
    }
  }
  return scan.IsAtEnd();
}
} // namespace palpate
