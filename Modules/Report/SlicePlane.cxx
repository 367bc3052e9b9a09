#include "SlicePlane.h"

#include "BodyAxes.h"
#include "VoxelMask.h"

#include "vtkImageData.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// Margin around the structure in the images, in mm and as a fraction of its size.
constexpr double SmallestMargin = 6.0;
constexpr double MarginShare = 0.22;

// The voxels that have a value, in the image's own indices.
LabelBounds BoxOf(vtkImageData* mask, int value, const ImageAxes& axes)
{
  LabelBounds box;
  switch (mask->GetScalarType())
  {
    vtkTemplateMacro(box = FindLabelBounds(static_cast<const VTK_TT*>(mask->GetScalarPointer()),
                                           {axes.Size(0), axes.Size(1), axes.Size(2)},
                                           static_cast<VTK_TT>(value)));
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    box.First[axis] += axes.Extent[2 * axis];
    box.Last[axis] += axes.Extent[2 * axis];
  }
  return box;
}

// Lays out planes around one box of voxels.
class Layout
{
public:
  Layout(const ImageAxes& image, const LabelBounds& box, int longestSide)
      : Image(image), Box(box), Body(image)
  {
    double longest = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      longest = std::max(longest, this->SideMillimeters(axis));
    }
    this->Margin = std::max(SmallestMargin, MarginShare * longest);
    this->PixelMillimeters = (longest + 2.0 * this->Margin) / longestSide;
  }

  // A plane perpendicular to body axis `across`; the image's right and down are body axes with a
  // sign.
  SlicePlane Make(const std::string& name, int across, int right, int down, double downSign,
                  int sliceIndex) const
  {
    SlicePlane plane;
    plane.Name = name;
    plane.RightAxis = this->Body.Axis[right];
    plane.DownAxis = this->Body.Axis[down];
    plane.SliceAxis = this->Body.Axis[across];
    plane.RightWorld = this->Body.Sign[right] * this->Image.UnitWorld[plane.RightAxis];
    plane.DownWorld = downSign * this->Body.Sign[down] * this->Image.UnitWorld[plane.DownAxis];
    plane.PixelMillimeters = this->PixelMillimeters;
    const double width = this->SideMillimeters(plane.RightAxis) + 2.0 * this->Margin;
    const double height = this->SideMillimeters(plane.DownAxis) + 2.0 * this->Margin;
    plane.Width = std::max(1, static_cast<int>(std::lround(width / this->PixelMillimeters)));
    plane.Height = std::max(1, static_cast<int>(std::lround(height / this->PixelMillimeters)));
    plane.SliceIndex = sliceIndex;
    plane.SliceNumber = sliceIndex - this->Image.Extent[2 * plane.SliceAxis] + 1;
    plane.SliceCount = this->Image.Size(plane.SliceAxis);

    Vector3 middleIndex;
    for (int axis = 0; axis < 3; ++axis)
    {
      middleIndex[axis] = 0.5 * (this->Box.First[axis] + this->Box.Last[axis]);
    }
    middleIndex[plane.SliceAxis] = sliceIndex;
    plane.CornerWorld = this->Image.ToWorld(middleIndex) -
                        0.5 * this->PixelMillimeters *
                            (plane.Width * plane.RightWorld + plane.Height * plane.DownWorld);
    return plane;
  }

  SlicePlane At(const Vector3& pointWorld) const
  {
    const int axis = this->Body.Axis[2];
    const Vector3 fromOrigin = pointWorld - this->Image.ToWorld(Vector3::Zero());
    const double index = fromOrigin.dot(this->Image.UnitWorld[axis]) / this->Image.Spacing[axis];
    const double first = this->Image.Extent[2 * axis];
    const double last = first + this->Image.Size(axis) - 1;
    return this->Make("Axial", 2, 0, 1, 1.0,
                      static_cast<int>(std::lround(std::clamp(index, first, last))));
  }

  std::vector<SlicePlane> All(int axialCount) const
  {
    std::vector<SlicePlane> planes;
    const int axis = this->Body.Axis[2];
    int previous = this->Box.First[axis] - 1;
    for (int k = 0; k < axialCount; ++k)
    {
      // The centres of equal parts of the structure's height, from below.
      const int part = this->Body.Sign[2] > 0.0 ? k : axialCount - 1 - k;
      const double height = this->Box.Last[axis] - this->Box.First[axis];
      const int index =
          this->Box.First[axis] + static_cast<int>(std::lround(height * (part + 0.5) / axialCount));
      if (k == 0 || index != previous)
      {
        planes.push_back(this->Make("Axial", 2, 0, 1, 1.0, index));
      }
      previous = index;
    }
    planes.push_back(this->Make("Sagittal", 0, 1, 2, -1.0, this->Center(0)));
    planes.push_back(this->Make("Coronal", 1, 0, 2, -1.0, this->Center(1)));
    return planes;
  }

private:
  double SideMillimeters(int axis) const
  {
    return (this->Box.Last[axis] - this->Box.First[axis] + 1) * this->Image.Spacing[axis];
  }
  int Center(int bodyAxis) const
  {
    const int axis = this->Body.Axis[bodyAxis];
    return (this->Box.First[axis] + this->Box.Last[axis]) / 2;
  }

  const ImageAxes& Image;
  const LabelBounds& Box;
  BodyAxes Body;
  double Margin;
  double PixelMillimeters;
};
} // namespace

Vector3 SlicePlane::NormalWorld() const
{
  return this->RightWorld.cross(this->DownWorld);
}

std::vector<SlicePlane> ChooseSlicePlanes(vtkImageData* mask, int value, int axialCount,
                                          int longestSide)
{
  const ImageAxes image(mask);
  const LabelBounds box = BoxOf(mask, value, image);
  return box.IsEmpty() ? std::vector<SlicePlane>()
                       : Layout(image, box, longestSide).All(axialCount);
}

std::vector<SlicePlane> SlicePlanesAt(const std::vector<Vector3>& pointsWorld, vtkImageData* mask,
                                      int value, int longestSide)
{
  std::vector<SlicePlane> planes;
  const ImageAxes image(mask);
  const LabelBounds box = BoxOf(mask, value, image);
  if (!box.IsEmpty())
  {
    const Layout layout(image, box, longestSide);
    for (const Vector3& point : pointsWorld)
    {
      planes.push_back(layout.At(point));
    }
  }
  return planes;
}
} // namespace palpate
