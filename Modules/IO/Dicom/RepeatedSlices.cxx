#include "RepeatedSlices.h"

#include "DecimalText.h"
#include "DicomFrameDecoder.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"

#include <algorithm>
#include <cstddef>

namespace palpate
{
namespace
{
constexpr double SamePosition = 1e-3; // mm, as in StackSlices

// Pixels after each slice's rescale slope.
vtkSmartPointer<vtkDoubleArray> PixelsOf(const DicomSeries& series, std::size_t slice,
                                         DicomFrameDecoder& decoder)
{
  const StackedSlice& plane = series.Planes[slice];
  const vtkIdType count = static_cast<vtkIdType>(plane.Columns) * plane.Rows;
  auto pixels = vtkSmartPointer<vtkDoubleArray>::New();
  pixels->SetNumberOfTuples(count);
  auto stored = vtkSmartPointer<vtkDataArray>::Take(
      vtkDataArray::CreateDataArray(series.Formats[slice].ScalarType()));
  stored->SetNumberOfTuples(count);
  ReadSlicePixels(series.Files[slice], series.Formats[slice], count, stored, 0, decoder);
  pixels->DeepCopy(stored);
  return pixels;
}

bool AreEqual(const DicomSeries& series, std::size_t a, std::size_t b, DicomFrameDecoder& decoder)
{
  const auto first = PixelsOf(series, a, decoder);
  const auto second = PixelsOf(series, b, decoder);
  return std::equal(first->GetPointer(0), first->GetPointer(first->GetNumberOfValues()),
                    second->GetPointer(0), second->GetPointer(second->GetNumberOfValues()));
}

// The slices by their distance along the normal.
std::vector<std::size_t> OrderOf(const DicomSeries& series, std::vector<double>& heights)
{
  const Vector3 normal = series.Planes.front().NormalWorld();
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < series.Planes.size(); ++i)
  {
    heights.push_back(normal.dot(series.Planes[i].PositionWorld));
    order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return heights[a] < heights[b]; });
  return order;
}
} // namespace

DicomSeries WithoutRepeatedSlices(const DicomSeries& series, std::vector<std::string>& notes)
{
  std::vector<double> heights;
  const std::vector<std::size_t> order = OrderOf(series, heights);
  std::vector<char> isRepeated(order.size(), 0);
  std::string named;
  DicomFrameDecoder decoder;
  for (std::size_t i = 1, kept = 0; i < order.size(); ++i)
  {
    const bool isSame = heights[order[i]] - heights[order[kept]] < SamePosition &&
                        AreEqual(series, order[kept], order[i], decoder);
    kept = isSame ? kept : i;
    if (isSame)
    {
      isRepeated[order[i]] = 1;
      named = named.empty() ? series.Planes[order[i]].Place() : named;
    }
  }
  const auto count = std::count(isRepeated.begin(), isRepeated.end(), 1);
  if (count == 0)
  {
    return series;
  }
  DicomSeries once = series;
  once.Files.clear();
  once.Planes.clear();
  once.Formats.clear();
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (isRepeated[i] == 0)
    {
      once.Files.push_back(series.Files[i]);
      once.Planes.push_back(series.Planes[i]);
      once.Formats.push_back(series.Formats[i]);
    }
  }
  notes.push_back(CountText(count, "slice is", "slices are") +
                  " there twice with equal pixels and taken once (" + named +
                  (count > 1 ? ", ...)." : ")."));
  return once;
}
} // namespace palpate
