#include "SliceGeometry.h"

#include "BodyAxes.h"
#include "ImageAxes.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
struct Properties
{
  const char* Name;
  ViewSide Side;
  // To the patient's head, front or right: the direction of increasing RAS coordinates, in which
  // imaging programs count slices.
  int ForwardAxis;
  double ForwardSign;
  std::array<double, 3> Color;
};

// In the order of SliceOrientation.
constexpr std::array<Properties, 3> AllProperties{
    {{"Axial", ViewSide::Inferior, 2, 1.0, {{0.84, 0.37, 0.0}}},
     {"Coronal", ViewSide::Anterior, 1, -1.0, {{0.0, 0.62, 0.45}}},
     {"Sagittal", ViewSide::Left, 0, -1.0, {{0.94, 0.89, 0.26}}}}};

const Properties& PropertiesOf(SliceOrientation orientation)
{
  return AllProperties[static_cast<std::size_t>(orientation)];
}

Vector3 BodyForward(SliceOrientation orientation)
{
  const Properties& properties = PropertiesOf(orientation);
  return properties.ForwardSign * Vector3::Unit(properties.ForwardAxis);
}

// The image's directions need not be perpendicular; those of a view are.
ViewFrame Orthonormal(const Vector3& right, const Vector3& up)
{
  const Vector3 towards = right.cross(up).normalized();
  return {right, towards.cross(right), towards};
}
} // namespace

const char* NameOf(SliceOrientation orientation)
{
  return PropertiesOf(orientation).Name;
}

std::array<double, 3> ColorOf(SliceOrientation orientation)
{
  return PropertiesOf(orientation).Color;
}

SliceGeometry::SliceGeometry(SliceOrientation orientation, bool isAlongImage, vtkImageData* image)
    : Frame(FrameOf(PropertiesOf(orientation).Side)), ForwardWorld(BodyForward(orientation))
{
  if (image == nullptr)
  {
    return;
  }
  const ImageAxes axes(image);
  const BodyAxes body(axes);
  int part = 0;
  this->ForwardWorld.cwiseAbs().maxCoeff(&part);
  const int axis = body.Axis[static_cast<std::size_t>(part)];
  this->StepMillimeters = axes.Spacing[static_cast<std::size_t>(axis)];
  if (!isAlongImage)
  {
    return;
  }
  const Vector3 forward = body.NearestWorld(axes, this->ForwardWorld);
  this->Frame = Orthonormal(body.NearestWorld(axes, this->Frame.RightWorld),
                            body.NearestWorld(axes, this->Frame.UpWorld));
  const double side = this->Frame.TowardsViewerWorld.dot(forward) < 0.0 ? -1.0 : 1.0;
  this->ForwardWorld = side * this->Frame.TowardsViewerWorld;
  this->StepMillimeters *= std::abs(forward.dot(this->ForwardWorld));
  this->Count = axes.Size(axis);
  const bool isIndexForward = forward.dot(axes.UnitWorld[static_cast<std::size_t>(axis)]) > 0.0;
  Vector3 first(axes.Extent[0], axes.Extent[2], axes.Extent[4]);
  first[axis] = axes.Extent[static_cast<std::size_t>(2 * axis + (isIndexForward ? 0 : 1))];
  this->FirstWorld = axes.ToWorld(first);
}

int SliceGeometry::NumberOf(const Vector3& world) const
{
  const double steps = (world - this->FirstWorld).dot(this->ForwardWorld) / this->StepMillimeters;
  constexpr double Far = 1e6; // keeps the number within range
  return static_cast<int>(std::lround(std::clamp(steps, -Far, Far)));
}

Vector3 SliceGeometry::Moved(const Vector3& world, int steps) const
{
  if (!this->HasNumbers())
  {
    return world + steps * this->StepMillimeters * this->ForwardWorld;
  }
  const int number = std::clamp(this->NumberOf(world) + steps, 0, this->Count - 1);
  const double path = (this->FirstWorld - world).dot(this->ForwardWorld);
  return world + (path + number * this->StepMillimeters) * this->ForwardWorld;
}
} // namespace palpate
