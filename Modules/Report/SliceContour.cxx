#include "SliceContour.h"

#include "DecimalText.h"
#include "ImageAxes.h"
#include "SurfaceCut.h"
#include "VoxelMask.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"

#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
namespace
{
// Points closer than this to the last one, in pixels, are omitted from a path.
constexpr double Resolution = 0.4;

std::string PointText(const Eigen::Vector2d& point)
{
  return FixedText(point.x(), 1) + " " + FixedText(point.y(), 1);
}

std::string CurvePath(const SurfaceCurve& curve, const SlicePlane& plane)
{
  Eigen::Vector2d last = plane.ToImage(curve.Points.front());
  std::string path = "M" + PointText(last);
  for (std::size_t p = 1; p < curve.Points.size(); ++p)
  {
    const Eigen::Vector2d point = plane.ToImage(curve.Points[p]);
    const bool isEnd = !curve.IsClosed && p + 1 == curve.Points.size();
    if (isEnd || (point - last).norm() >= Resolution)
    {
      path += "L" + PointText(point);
      last = point;
    }
  }
  return path + (curve.IsClosed ? "Z" : "");
}

// Marks the voxels of one slice that have a value, row by row.
template <typename T>
void MarkSlice(const T* voxels, const ImageAxes& image, const SlicePlane& plane, int value,
               std::vector<char>& inside)
{
  const std::array<std::ptrdiff_t, 3> strides{
      {1, image.Size(0), static_cast<std::ptrdiff_t>(image.Size(0)) * image.Size(1)}};
  const int columns = image.Size(plane.RightAxis);
  const int rows = image.Size(plane.DownAxis);
  voxels += strides[plane.SliceAxis] * (plane.SliceNumber - 1);
  inside.reserve(static_cast<std::size_t>(rows) * columns);
  for (int row = 0; row < rows; ++row)
  {
    for (int column = 0; column < columns; ++column)
    {
      const T voxel = voxels[row * strides[plane.DownAxis] + column * strides[plane.RightAxis]];
      inside.push_back(static_cast<double>(voxel) == value ? 1 : 0);
    }
  }
}

// The voxels of one slice that have a value.
class SliceMask
{
public:
  SliceMask(vtkImageData* mask, int value, const SlicePlane& plane) : Axes(mask), Plane(plane)
  {
    switch (mask->GetScalarType())
    {
      vtkTemplateMacro(MarkSlice(static_cast<const VTK_TT*>(mask->GetScalarPointer()), this->Axes,
                                 plane, value, this->Inside));
    }
    this->FindBounds();
  }

  // Path of the edges along one axis of the slice; consecutive edges are joined.
  std::string EdgesAlong(int axis, int otherAxis) const
  {
    std::string path;
    for (int line = this->First(otherAxis); line <= this->Last(otherAxis) + 1; ++line)
    {
      int start = 0;
      bool isOpen = false;
      for (int step = this->First(axis); step <= this->Last(axis) + 1; ++step)
      {
        const bool isEdge = this->IsInside(axis, step, otherAxis, line - 1) !=
                            this->IsInside(axis, step, otherAxis, line);
        if (isEdge && !isOpen)
        {
          start = step;
        }
        else if (!isEdge && isOpen)
        {
          path += "M" + this->Corner(axis, start, otherAxis, line) + "L" +
                  this->Corner(axis, step, otherAxis, line);
        }
        isOpen = isEdge;
      }
    }
    return path;
  }

private:
  // Of the marked voxels, by image axis; empty where there are none.
  int First(int axis) const { return this->Bounds[2 * axis]; }
  int Last(int axis) const { return this->Bounds[2 * axis + 1]; }

  void FindBounds()
  {
    const int right = this->Plane.RightAxis;
    const int down = this->Plane.DownAxis;
    const LabelBounds box = FindLabelBounds(
        this->Inside.data(), {this->Axes.Size(right), this->Axes.Size(down), 1}, char{1});
    this->Bounds[2 * right] = this->Axes.Extent[2 * right] + box.First[0];
    this->Bounds[2 * right + 1] = this->Axes.Extent[2 * right] + box.Last[0];
    this->Bounds[2 * down] = this->Axes.Extent[2 * down] + box.First[1];
    this->Bounds[2 * down + 1] = this->Axes.Extent[2 * down] + box.Last[1];
  }

  bool IsInside(int axis, int along, int otherAxis, int across) const
  {
    if (along < this->First(axis) || along > this->Last(axis) || across < this->First(otherAxis) ||
        across > this->Last(otherAxis))
    {
      return false;
    }
    const bool alongRight = axis == this->Plane.RightAxis;
    const int column = (alongRight ? along : across) - this->Axes.Extent[2 * this->Plane.RightAxis];
    const int row = (alongRight ? across : along) - this->Axes.Extent[2 * this->Plane.DownAxis];
    return this->Inside[static_cast<std::size_t>(row) * this->Axes.Size(this->Plane.RightAxis) +
                        column] != 0;
  }

  // The lower corner of a voxel.
  std::string Corner(int axis, int along, int otherAxis, int across) const
  {
    Vector3 index = Vector3::Zero();
    index[axis] = along - 0.5;
    index[otherAxis] = across - 0.5;
    index[this->Plane.SliceAxis] = this->Plane.SliceIndex;
    return PointText(this->Plane.ToImage(this->Axes.ToWorld(index)));
  }

  ImageAxes Axes;
  const SlicePlane& Plane;
  std::vector<char> Inside;
  std::array<int, 6> Bounds{};
};
} // namespace

std::string SurfaceContourPath(vtkPolyData* surface, const SlicePlane& plane)
{
  std::string path;
  for (const SurfaceCurve& curve : CutSurface(surface, plane.CornerWorld, plane.NormalWorld()))
  {
    path += CurvePath(curve, plane);
  }
  return path;
}

std::string MaskOutlinePath(vtkImageData* mask, int value, const SlicePlane& plane)
{
  const SliceMask slice(mask, value, plane);
  return slice.EdgesAlong(plane.RightAxis, plane.DownAxis) +
         slice.EdgesAlong(plane.DownAxis, plane.RightAxis);
}
} // namespace palpate
