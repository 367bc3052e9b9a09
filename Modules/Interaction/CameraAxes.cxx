#include "CameraAxes.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

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

double MillimetersPerPixel(vtkRenderer* renderer, const Vector3& pointWorld)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const int height = std::max(1, renderer->GetSize()[1]);
  if (camera->GetParallelProjection() != 0)
  {
    return 2.0 * camera->GetParallelScale() / height;
  }
  const double away = (pointWorld - Vector3(camera->GetPosition()))
                          .dot(Vector3(camera->GetDirectionOfProjection()));
  const double half = vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle());
  return 2.0 * std::max(away, 0.0) * std::tan(half) / height;
}
} // namespace palpate
