#include "ValueHistogram.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace palpate
{
namespace
{
constexpr vtkIdType MostSamples = 1 << 18;
constexpr double Outliers = 1e-3; // share of the values at either end
constexpr double HighestAirHu = -500.0;

// Finite values of every n-th voxel. The step shares no factor with the length of a row, so that
// the sample is not of few columns.
std::vector<double> SampleOf(vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const vtkIdType count = scalars != nullptr ? scalars->GetNumberOfTuples() : 0;
  const vtkIdType row = image->GetDimensions()[0];
  vtkIdType step = std::max<vtkIdType>(1, (count + MostSamples - 1) / MostSamples);
  while (step > 1 && std::gcd(step, row) != 1)
  {
    ++step;
  }
  std::vector<double> values;
  for (vtkIdType voxel = 0; voxel < count; voxel += step)
  {
    const double value = scalars->GetComponent(voxel, 0);
    if (std::isfinite(value))
    {
      values.push_back(value);
    }
  }
  return values;
}

double QuantileOf(std::vector<double>& values, double share)
{
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}
} // namespace

ValueHistogram HistogramOf(vtkImageData* image, int bins)
{
  ValueHistogram histogram;
  const auto count = static_cast<std::size_t>(std::max(2, bins));
  histogram.Counts.assign(count, 0);
  std::vector<double> values = SampleOf(image);
  if (values.empty())
  {
    return histogram;
  }
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  histogram.Lowest = *lowest;
  histogram.Highest = *highest;
  histogram.First = QuantileOf(values, Outliers);
  histogram.Last = QuantileOf(values, 1.0 - Outliers);
  if (!(histogram.Last > histogram.First)) // nearly all values are equal
  {
    histogram.First = histogram.Lowest;
    histogram.Last =
        histogram.Highest > histogram.Lowest
            ? histogram.Highest
            : std::max(histogram.Lowest + 1.0, std::nextafter(histogram.Lowest, HUGE_VAL));
  }
  const double scale = static_cast<double>(count) / (histogram.Last - histogram.First);
  for (const double value : values)
  {
    const double bin =
        std::clamp((value - histogram.First) * scale, 0.0, static_cast<double>(count - 1));
    ++histogram.Counts[static_cast<std::size_t>(bin)];
  }
  return histogram;
}

double OtsuThreshold(const ValueHistogram& histogram)
{
  double total = 0.0;
  double sum = 0.0; // of bin numbers
  for (std::size_t bin = 0; bin < histogram.Counts.size(); ++bin)
  {
    const auto weight = static_cast<double>(histogram.Counts[bin]);
    total += weight;
    sum += weight * static_cast<double>(bin);
  }
  double below = 0.0;
  double belowSum = 0.0;
  double greatest = 0.0;
  std::size_t best = 0;
  std::size_t last = 0; // as good as the best: in a gap between both classes
  for (std::size_t bin = 1; bin < histogram.Counts.size(); ++bin)
  {
    below += static_cast<double>(histogram.Counts[bin - 1]);
    belowSum += static_cast<double>(histogram.Counts[bin - 1]) * static_cast<double>(bin - 1);
    const double above = total - below;
    if (below == 0.0 || above == 0.0)
    {
      continue;
    }
    const double step = belowSum / below - (sum - belowSum) / above;
    const double between = below * above * step * step;
    if (between > greatest)
    {
      greatest = between;
      best = bin;
    }
    last = between == greatest ? bin : last;
  }
  return greatest > 0.0 ? 0.5 * (histogram.ValueAt(best) + histogram.ValueAt(last))
                        : histogram.First;
}

bool LooksLikeCt(const ValueHistogram& histogram)
{
  return histogram.Lowest < HighestAirHu;
}
} // namespace palpate
