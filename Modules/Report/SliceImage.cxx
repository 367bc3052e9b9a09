#include "SliceImage.h"

#include "PlaneSampler.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace palpate
{
std::vector<float> SampleLinear(vtkImageData* image, const SlicePlane& plane)
{
  const PlaneSampler sampler(image, plane.Pixels());
  std::vector<float> values(static_cast<std::size_t>(plane.Width) * plane.Height);
  for (int row = 0; row < plane.Height; ++row)
  {
    sampler.SampleLinear(row, values.data() + static_cast<std::size_t>(row) * plane.Width);
  }
  return values;
}

std::vector<float> SampleNearest(vtkImageData* image, const SlicePlane& plane)
{
  const PlaneSampler sampler(image, plane.Pixels());
  std::vector<float> values(static_cast<std::size_t>(plane.Width) * plane.Height);
  for (int row = 0; row < plane.Height; ++row)
  {
    sampler.SampleNearest(row, 0.0F, values.data() + static_cast<std::size_t>(row) * plane.Width);
  }
  return values;
}

RasterImage DrawGrey(const std::vector<float>& values, const SlicePlane& plane,
                     const GreyWindow& window)
{
  RasterImage raster(plane.Width, plane.Height);
  const double scale = 255.0 / (window.High - window.Low);
  for (std::size_t p = 0; p < values.size(); ++p)
  {
    const double grey = std::isfinite(values[p]) ? (values[p] - window.Low) * scale : 0.0;
    std::uint8_t* pixel = raster.Rgba.data() + 4 * p;
    std::fill_n(pixel, 3, static_cast<std::uint8_t>(std::clamp(grey, 0.0, 255.0)));
    pixel[3] = 255;
  }
  return raster;
}
} // namespace palpate
