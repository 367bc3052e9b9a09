#include "CameraAxes.h"

#include "vtkCamera.h"

#include <Eigen/Geometry>

namespace palpate
{
Matrix3 CameraAxes(vtkCamera* camera)
{
  const Vector3 back = -Vector3(camera->GetDirectionOfProjection());
  const Vector3 right = Vector3(camera->GetViewUp()).cross(back).normalized();
  Matrix3 axes;
  axes << right, back.cross(right), back;
  return axes;
}
} // namespace palpate
