#include "BSplineCoefficients.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
const double Pole = std::sqrt(3.0) - 2.0;
constexpr double Gain = 6.0;
constexpr int Horizon = 40; // Pole^40 is below the rounding of double

// Lines of one length, some of them side by side so that memory is read in whole cache lines.
class LineFilter
{
public:
  LineFilter(int length, std::size_t stride, int lines)
      : Length(static_cast<std::size_t>(length)), Stride(stride),
        Lines(static_cast<std::size_t>(lines)), Buffer(Length * Lines)
  {
  }

  void Run(float* first, std::size_t lines)
  {
    for (std::size_t n = 0; n < this->Length; ++n)
    {
      std::copy_n(first + n * this->Stride, lines, &this->Buffer[n * this->Lines]);
    }
    for (std::size_t line = 0; line < lines; ++line)
    {
      this->Filter(&this->Buffer[line]);
    }
    for (std::size_t n = 0; n < this->Length; ++n)
    {
      std::transform(&this->Buffer[n * this->Lines], &this->Buffer[n * this->Lines] + lines,
                     first + n * this->Stride, [](double c) { return static_cast<float>(c); });
    }
  }

private:
  void Filter(double* line) const
  {
    const std::size_t step = this->Lines;
    const std::size_t last = (this->Length - 1) * step;
    line[0] = Gain * this->CausalStart(line);
    for (std::size_t at = step; at <= last; at += step)
    {
      line[at] = Gain * line[at] + Pole * line[at - step];
    }
    line[last] = Pole / (Pole * Pole - 1.0) * (line[last] + Pole * line[last - step]);
    for (std::size_t at = last; at > 0; at -= step)
    {
      line[at - step] = Pole * (line[at] - line[at - step]);
    }
  }

  // The recursion's value at the first sample, summed over the mirrored samples before it.
  double CausalStart(const double* line) const
  {
    const auto period = static_cast<int>(2 * this->Length - 2);
    const int terms = std::min(Horizon, period);
    double sum = 0.0;
    double power = 1.0;
    for (int n = 0; n < terms; ++n, power *= Pole)
    {
      const int mirrored = std::min(n, period - n);
      sum += power * line[static_cast<std::size_t>(mirrored) * this->Lines];
    }
    return terms == period ? sum / (1.0 - power) : sum;
  }

  std::size_t Length;
  std::size_t Stride;
  std::size_t Lines;
  std::vector<double> Buffer;
};
} // namespace

void FindBSplineCoefficients(const std::array<int, 3>& size, std::vector<float>& samples)
{
  constexpr int SideBySide = 16;
  const auto row = static_cast<std::size_t>(size[0]);
  const std::size_t slice = row * static_cast<std::size_t>(size[1]);
  LineFilter alongRows(size[0], 1, 1);
  for (std::size_t first = 0; first < samples.size(); first += row)
  {
    alongRows.Run(&samples[first], 1);
  }
  LineFilter acrossRows(size[1], row, SideBySide);
  LineFilter acrossSlices(size[2], slice, SideBySide);
  for (std::size_t i = 0; i < row; i += SideBySide)
  {
    const std::size_t lines = std::min<std::size_t>(SideBySide, row - i);
    for (std::size_t k = 0; k < samples.size(); k += slice)
    {
      acrossRows.Run(&samples[k + i], lines);
    }
    for (std::size_t j = 0; j < slice; j += row)
    {
      acrossSlices.Run(&samples[j + i], lines);
    }
  }
}
} // namespace palpate
