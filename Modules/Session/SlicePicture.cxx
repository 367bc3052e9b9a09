#include "SlicePicture.h"

#include "ImageAxes.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
// A grid's voxels of one type, with indices counted from the first voxel.
template <typename T>
class VoxelGrid
{
public:
  VoxelGrid(const T* voxels, const ImageAxes& axes)
      : Voxels(voxels), Size{axes.Size(0), axes.Size(1), axes.Size(2)}
  {
  }

  float Nearest(const Vector3& index) const
  {
    std::array<int, 3> at{};
    for (int axis = 0; axis < 3; ++axis)
    {
      at[axis] = static_cast<int>(std::floor(index[axis] + 0.5));
      if (at[axis] < 0 || at[axis] >= this->Size[axis])
      {
        return 0.0F;
      }
    }
    return this->At(at[0], at[1], at[2]);
  }

  // Up to half a voxel beyond the outermost centres belongs to the image.
  float Linear(const Vector3& index) const
  {
    std::array<int, 3> low{};
    std::array<int, 3> high{};
    std::array<float, 3> share{};
    for (int axis = 0; axis < 3; ++axis)
    {
      const double last = this->Size[axis] - 1.0;
      if (!(index[axis] >= -0.5 && index[axis] <= last + 0.5))
      {
        return std::numeric_limits<float>::quiet_NaN();
      }
      const double place = std::clamp(index[axis], 0.0, last);
      low[axis] = static_cast<int>(place);
      high[axis] = std::min(low[axis] + 1, this->Size[axis] - 1);
      share[axis] = static_cast<float>(place - low[axis]);
    }
    const auto alongI = [&](int j, int k)
    {
      const float first = this->At(low[0], j, k);
      return first + share[0] * (this->At(high[0], j, k) - first);
    };
    const auto alongJ = [&](int k)
    {
      const float first = alongI(low[1], k);
      return first + share[1] * (alongI(high[1], k) - first);
    };
    const float first = alongJ(low[2]);
    return first + share[2] * (alongJ(high[2]) - first);
  }

private:
  float At(int i, int j, int k) const
  {
    return static_cast<float>(
        this->Voxels[(static_cast<std::size_t>(k) * this->Size[1] + j) * this->Size[0] + i]);
  }

  const T* Voxels;
  std::array<int, 3> Size;
};

enum class Interpolation
{
  Nearest,
  Linear
};

template <typename T>
void Fill(const T* voxels, const ImageAxes& axes, const SlicePlane& plane, Interpolation kind,
          std::vector<float>& values)
{
  const VoxelGrid<T> grid(voxels, axes);
  const Vector3 firstVoxel(axes.Extent[0], axes.Extent[2], axes.Extent[4]);
  const Vector3 step = axes.WorldToIndex * plane.RightWorld * plane.PixelMillimeters;
  for (int row = 0; row < plane.Height; ++row)
  {
    Vector3 index = axes.ToIndex(plane.ToWorld({0.5, row + 0.5})) - firstVoxel;
    float* value = values.data() + static_cast<std::size_t>(row) * plane.Width;
    for (int column = 0; column < plane.Width; ++column, index += step)
    {
      value[column] = kind == Interpolation::Linear ? grid.Linear(index) : grid.Nearest(index);
    }
  }
}

std::vector<float> SampleImage(vtkImageData* image, const SlicePlane& plane, Interpolation kind)
{
  const ImageAxes axes(image);
  std::vector<float> values(static_cast<std::size_t>(plane.Width) * plane.Height);
  switch (image->GetScalarType())
  {
    vtkTemplateMacro(
        Fill(static_cast<const VTK_TT*>(image->GetScalarPointer()), axes, plane, kind, values));
  }
  return values;
}
} // namespace

std::vector<float> SampleLinear(vtkImageData* image, const SlicePlane& plane)
{
  return SampleImage(image, plane, Interpolation::Linear);
}

std::vector<float> SampleNearest(vtkImageData* image, const SlicePlane& plane)
{
  return SampleImage(image, plane, Interpolation::Nearest);
}

GreyWindow FindWindow(const std::vector<std::vector<float>>& slices)
{
  constexpr std::size_t Stride = 5; // that many fewer values place a percentile well enough
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

Picture DrawGrey(const std::vector<float>& values, const SlicePlane& plane,
                 const GreyWindow& window)
{
  Picture picture(plane.Width, plane.Height);
  const double scale = 255.0 / (window.High - window.Low);
  for (std::size_t p = 0; p < values.size(); ++p)
  {
    const double grey = std::isfinite(values[p]) ? (values[p] - window.Low) * scale : 0.0;
    std::uint8_t* pixel = picture.Rgba.data() + 4 * p;
    std::fill_n(pixel, 3, static_cast<std::uint8_t>(std::clamp(grey, 0.0, 255.0)));
    pixel[3] = 255;
  }
  return picture;
}
} // namespace palpate
