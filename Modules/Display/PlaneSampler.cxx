#include "PlaneSampler.h"

#include "vtkImageData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace palpate
{
namespace
{
// A grid's voxels of one type, with indices counted from the first voxel.
template <typename T>
class VoxelGrid
{
public:
  VoxelGrid(const T* voxels, const ImageAxes& axes, int components)
      : Voxels(voxels), Size{axes.Size(0), axes.Size(1), axes.Size(2)},
        Stride{components, static_cast<std::ptrdiff_t>(components) * this->Size[0],
               static_cast<std::ptrdiff_t>(components) * this->Size[0] * this->Size[1]}
  {
  }

  float Nearest(const Vector3& index, float outside) const
  {
    std::ptrdiff_t offset = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double at = std::floor(index[axis] + 0.5);
      if (!(at >= 0.0 && at < this->Size[axis]))
      {
        return outside;
      }
      offset += static_cast<std::ptrdiff_t>(at) * this->Stride[axis];
    }
    return static_cast<float>(this->Voxels[offset]);
  }

  // The image extends half a voxel beyond the outermost centres.
  float Linear(const Vector3& index) const
  {
    Cell cell;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double last = this->Size[axis] - 1.0;
      if (!(index[axis] >= -0.5 && index[axis] <= last + 0.5))
      {
        return std::numeric_limits<float>::quiet_NaN();
      }
      const double place = std::clamp(index[axis], 0.0, last);
      const int low = static_cast<int>(place);
      cell.Add(place - low, low * this->Stride[axis],
               low + 1 < this->Size[axis] ? this->Stride[axis] : 0, axis);
    }
    return this->Interpolate(cell);
  }

  // The same if every index is known to have a successor.
  float LinearWithin(const Vector3& index) const
  {
    Cell cell;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int low = static_cast<int>(index[axis]);
      cell.Add(index[axis] - low, low * this->Stride[axis], this->Stride[axis], axis);
    }
    return this->Interpolate(cell);
  }

  // A line of voxels along an axis, each interpolated along both others, between which every index
  // is known to have a successor.
  class Line
  {
  public:
    Line(const VoxelGrid& grid, int axis, const Vector3& index)
        : StrideA(grid.Stride[(axis + 1) % 3]), StrideB(grid.Stride[(axis + 2) % 3]),
          Stride(grid.Stride[axis])
    {
      const double a = index[(axis + 1) % 3];
      const double b = index[(axis + 2) % 3];
      this->ShareA = static_cast<float>(a - static_cast<int>(a));
      this->ShareB = static_cast<float>(b - static_cast<int>(b));
      this->First =
          grid.Voxels + static_cast<int>(a) * this->StrideA + static_cast<int>(b) * this->StrideB;
    }
    float operator[](int index) const
    {
      const T* voxel = this->First + index * this->Stride;
      return Mix(this->AlongA(voxel), this->AlongA(voxel + this->StrideB), this->ShareB);
    }

  private:
    float AlongA(const T* voxel) const
    {
      return Mix(static_cast<float>(voxel[0]), static_cast<float>(voxel[this->StrideA]),
                 this->ShareA);
    }

    const T* First;
    std::ptrdiff_t StrideA;
    std::ptrdiff_t StrideB;
    std::ptrdiff_t Stride;
    float ShareA;
    float ShareB;
  };

  static float Mix(float first, float second, float share)
  {
    return first + share * (second - first);
  }

private:
  struct Cell
  {
    void Add(double share, std::ptrdiff_t offset, std::ptrdiff_t step, int axis)
    {
      this->Offset += offset;
      this->Share[axis] = static_cast<float>(share);
      this->Step[axis] = step;
    }
    std::ptrdiff_t Offset = 0;
    std::array<float, 3> Share{};
    std::array<std::ptrdiff_t, 3> Step{};
  };

  float Interpolate(const Cell& cell) const
  {
    const T* corner = this->Voxels + cell.Offset;
    const auto alongI = [&](const T* from) {
      return Mix(static_cast<float>(from[0]), static_cast<float>(from[cell.Step[0]]),
                 cell.Share[0]);
    };
    const auto alongJ = [&](const T* from)
    { return Mix(alongI(from), alongI(from + cell.Step[1]), cell.Share[1]); };
    return Mix(alongJ(corner), alongJ(corner + cell.Step[2]), cell.Share[2]);
  }

  const T* Voxels;
  std::array<int, 3> Size;
  std::array<std::ptrdiff_t, 3> Stride;
};

// The columns [first, last) of a row whose indices are strictly inside the grid along every axis.
std::array<int, 2> ColumnsWithin(const ImageAxes& axes, const Vector3& begin, const Vector3& step,
                                 int width)
{
  double first = 0.0;
  double last = width;
  for (int axis = 0; axis < 3; ++axis)
  {
    // Rounding errors are below this fraction of a voxel.
    constexpr double Margin = 1e-6;
    const double low = Margin;
    const double high = axes.Size(axis) - 1.0 - Margin;
    if (std::abs(step[axis]) < 1e-12)
    {
      last = begin[axis] > low && begin[axis] < high ? last : 0.0;
      continue;
    }
    const double atLow = (low - begin[axis]) / step[axis];
    const double atHigh = (high - begin[axis]) / step[axis];
    first = std::max(first, std::min(atLow, atHigh));
    last = std::min(last, std::max(atLow, atHigh));
  }
  if (!(last > first))
  {
    return {{0, 0}};
  }
  return {{static_cast<int>(std::ceil(first)), static_cast<int>(std::ceil(last))}};
}

// The axis that columns follow in steps of at most a voxel, or none.
std::optional<int> AxisOf(const Vector3& step)
{
  constexpr double Nothing = 1e-12; // of a voxel, as in ColumnsWithin
  std::optional<int> found;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (std::abs(step[axis]) < Nothing)
    {
      continue;
    }
    if (found || std::abs(step[axis]) > 1.0)
    {
      return {};
    }
    found = axis;
  }
  return found;
}

// Slices mostly lie along the grid, and have several pixels a voxel: voxels that columns share are
// interpolated once.
template <typename T>
void FillAlong(int axis, const VoxelGrid<T>& grid, const std::array<int, 2>& within,
               const Vector3& begin, const Vector3& step, float* values)
{
  const typename VoxelGrid<T>::Line line(grid, axis, begin);
  int held = std::numeric_limits<int>::min() / 2; // the index of `lower`
  float lower = 0.0F;
  float upper = 0.0F;
  for (int column = within[0]; column < within[1]; ++column)
  {
    const double place = begin[axis] + column * step[axis];
    const int low = static_cast<int>(place);
    if (low != held)
    {
      const float above = low + 1 == held ? lower : line[low + 1];
      lower = low == held + 1 ? upper : line[low];
      upper = above;
      held = low;
    }
    values[column] = VoxelGrid<T>::Mix(lower, upper, static_cast<float>(place - low));
  }
}

template <typename T>
void FillLinear(const VoxelGrid<T>& grid, const std::array<int, 2>& within, const Vector3& begin,
                const Vector3& step, int width, float* values)
{
  const auto fill = [&](int from, int to)
  {
    for (int column = from; column < to; ++column)
    {
      values[column] = grid.Linear(begin + column * step);
    }
  };
  fill(0, within[0]);
  const std::optional<int> axis = AxisOf(step);
  if (axis && within[1] > within[0])
  {
    FillAlong(*axis, grid, within, begin, step, values);
  }
  else
  {
    for (int column = within[0]; column < within[1]; ++column)
    {
      values[column] = grid.LinearWithin(begin + column * step);
    }
  }
  fill(within[1], width);
}

template <typename T>
void FillNearest(const VoxelGrid<T>& grid, const Vector3& begin, const Vector3& step, int width,
                 float outside, float* values)
{
  for (int column = 0; column < width; ++column)
  {
    values[column] = grid.Nearest(begin + column * step, outside);
  }
}
} // namespace

PlaneSampler::PlaneSampler(vtkImageData* image, const PixelGrid& pixels)
    : Axes(image), Pixels(pixels),
      FirstIndex(this->Axes.ToIndex(pixels.FirstWorld) -
                 Vector3(this->Axes.Extent[0], this->Axes.Extent[2], this->Axes.Extent[4])),
      ColumnStep(this->Axes.WorldToIndex * pixels.ColumnWorld),
      RowStep(this->Axes.WorldToIndex * pixels.RowWorld), Type(image->GetScalarType()),
      Components(image->GetNumberOfScalarComponents()), Voxels(image->GetScalarPointer())
{
}

void PlaneSampler::SampleLinear(int row, float* values) const
{
  const Vector3 begin = this->FirstIndex + row * this->RowStep;
  const std::array<int, 2> within =
      ColumnsWithin(this->Axes, begin, this->ColumnStep, this->Pixels.Width);
  switch (this->Type)
  {
    vtkTemplateMacro(FillLinear(
        VoxelGrid<VTK_TT>(static_cast<const VTK_TT*>(this->Voxels), this->Axes, this->Components),
        within, begin, this->ColumnStep, this->Pixels.Width, values));
  }
}

void PlaneSampler::SampleNearest(int row, float outside, float* values) const
{
  const Vector3 begin = this->FirstIndex + row * this->RowStep;
  switch (this->Type)
  {
    vtkTemplateMacro(FillNearest(
        VoxelGrid<VTK_TT>(static_cast<const VTK_TT*>(this->Voxels), this->Axes, this->Components),
        begin, this->ColumnStep, this->Pixels.Width, outside, values));
  }
}
} // namespace palpate
