#include "GreyWindow.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace palpate
{
GreyWindow FindWindow(const std::vector<std::vector<float>>& slices)
{
  constexpr std::size_t Stride = 5; // a fifth of the values gives the percentiles well enough
  std::vector<float> finite;
  for (const std::vector<float>& values : slices)
  {
    for (std::size_t v = 0; v < values.size(); v += Stride)
    {
      if (std::isfinite(values[v]))
      {
        finite.push_back(values[v]);
      }
    }
  }
  if (finite.empty())
  {
    return {};
  }
  const auto at = [&finite](double share)
  {
    const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(finite.size() - 1));
    std::nth_element(finite.begin(), finite.begin() + rank, finite.end());
    return static_cast<double>(finite[static_cast<std::size_t>(rank)]);
  };
  const GreyWindow window{at(0.01), at(0.995)};
  return window.High > window.Low ? window : GreyWindow{window.Low - 0.5, window.Low + 0.5};
}

GreyWindow WindowOf(vtkImageData* image)
{
  constexpr vtkIdType Samples = 200000;
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const vtkIdType count = scalars->GetNumberOfTuples();
  const vtkIdType stride = std::max<vtkIdType>(1, count / Samples);
  std::vector<float> values;
  for (vtkIdType v = 0; v < count; v += stride)
  {
    values.push_back(static_cast<float>(scalars->GetComponent(v, 0)));
  }
  return FindWindow({values});
}
} // namespace palpate
