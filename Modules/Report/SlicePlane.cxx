#include "SlicePlane.h"

#include "BodyAxes.h"

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

// Lays out planes around one box of voxels.
class Layout
{
public:
  Layout(const ImageAxes& image, const IndexBox& box, int longestSide)
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

    Vector3 middleIndex = 0.5 * (this->Box.Low + this->Box.High).cast<double>();
    middleIndex[plane.SliceAxis] = sliceIndex;
    plane.CornerWorld = this->Image.ToWorld(middleIndex) -
                        0.5 * this->PixelMillimeters *
                            (plane.Width * plane.RightWorld + plane.Height * plane.DownWorld);
    return plane;
  }

  std::vector<SlicePlane> All(int axialCount) const
  {
    std::vector<SlicePlane> planes;
    const int axis = this->Body.Axis[2];
    int previous = this->Box.Low[axis] - 1;
    for (int k = 0; k < axialCount; ++k)
    {
      // The centres of equal parts of the structure's height, from below.
      const int part = this->Body.Sign[2] > 0.0 ? k : axialCount - 1 - k;
      const double height = this->Box.High[axis] - this->Box.Low[axis];
      const int index =
          this->Box.Low[axis] + static_cast<int>(std::lround(height * (part + 0.5) / axialCount));
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
    return (this->Box.High[axis] - this->Box.Low[axis] + 1) * this->Image.Spacing[axis];
  }
  int Center(int bodyAxis) const
  {
    const int axis = this->Body.Axis[bodyAxis];
    return (this->Box.Low[axis] + this->Box.High[axis]) / 2;
  }

  const ImageAxes& Image;
  const IndexBox& Box;
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
  IndexBox box;
  if (!FindValueBox(mask, value, box))
  {
    return {};
  }
  return Layout(image, box, longestSide).All(axialCount);
}
} // namespace palpate
