#include "DicomPreview.h"

#include "AvailableMemory.h"
#include "DicomFrameDecoder.h"
#include "InputError.h"

#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace palpate
{
namespace
{
constexpr double Black = 0.01; // part of the pixels
constexpr double White = 0.99;

std::size_t MiddleOf(const DicomSeries& series)
{
  const Vector3 normal = series.Planes.front().NormalWorld();
  std::vector<std::size_t> order(series.Planes.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    order[i] = i;
  }
  const auto middle = order.begin() + static_cast<std::ptrdiff_t>(order.size() / 2);
  std::nth_element(order.begin(), middle, order.end(),
                   [&](std::size_t a, std::size_t b)
                   {
                     return normal.dot(series.Planes[a].PositionWorld) <
                            normal.dot(series.Planes[b].PositionWorld);
                   });
  return *middle;
}

vtkSmartPointer<vtkDataArray> ReadPixels(const DicomSeries& series, std::size_t slice)
{
  const StackedSlice& plane = series.Planes[slice];
  const vtkIdType count = static_cast<vtkIdType>(plane.Columns) * plane.Rows;
  auto pixels = vtkSmartPointer<vtkDataArray>::Take(
      vtkDataArray::CreateDataArray(series.Formats[slice].ScalarType()));
  CheckMemory(series.Files[slice], static_cast<double>(count) * pixels->GetDataTypeSize());
  pixels->SetNumberOfTuples(count);
  DicomFrameDecoder decoder;
  ReadSlicePixels(series.Files[slice], series.Formats[slice], count, pixels, 0, decoder);
  return pixels;
}

// The nearest pixels of the slice at those of the picture.
std::vector<double> Sampled(vtkDataArray* pixels, const StackedSlice& plane,
                            const DicomPreview& picture)
{
  std::vector<double> values;
  for (int row = 0; row < picture.Height; ++row)
  {
    const vtkIdType y = static_cast<vtkIdType>((row + 0.5) * plane.Rows / picture.Height);
    for (int column = 0; column < picture.Width; ++column)
    {
      const vtkIdType x = static_cast<vtkIdType>((column + 0.5) * plane.Columns / picture.Width);
      const double value = pixels->GetComponent(y * plane.Columns + x, 0);
      values.push_back(std::isfinite(value) ? value : 0.0);
    }
  }
  return values;
}

double Percentile(std::vector<double> values, double part)
{
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}
} // namespace

DicomPreview ReadDicomPreview(const DicomSeries& series, int side)
{
  try
  {
    const std::size_t slice = MiddleOf(series);
    const StackedSlice& plane = series.Planes[slice];
    const double width = plane.Columns * plane.Spacing[0];
    const double height = plane.Rows * plane.Spacing[1];
    const double scale = side / std::max(width, height);
    DicomPreview picture;
    picture.Width = std::clamp(static_cast<int>(std::lround(scale * width)), 1, side);
    picture.Height = std::clamp(static_cast<int>(std::lround(scale * height)), 1, side);
    const std::vector<double> values = Sampled(ReadPixels(series, slice), plane, picture);
    const double black = Percentile(values, Black);
    const double white = std::max(Percentile(values, White), black + 1e-9);
    for (const double value : values)
    {
      const double part = std::clamp((value - black) / (white - black), 0.0, 1.0);
      picture.Grey.push_back(static_cast<std::uint8_t>(std::lround(255.0 * part)));
    }
    return picture;
  }
  catch (const InputError&)
  {
    return {};
  }
}
} // namespace palpate
