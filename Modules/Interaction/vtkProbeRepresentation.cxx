#include "vtkProbeRepresentation.h"

#include "ToolSurface.h"

#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <limits>

vtkStandardNewMacro(vtkProbeRepresentation);

namespace
{
constexpr double Upright[4] = {1.0, 0.0, 0.0, 0.0};

bool AreNumbers(const double* numbers, int count)
{
  return std::all_of(numbers, numbers + count, [](double n) { return std::isfinite(n); });
}
} // namespace

vtkProbeRepresentation::vtkProbeRepresentation()
    : Tool(palpate::MakeToolSphere(1.0)), ProbeMatrix(vtkSmartPointer<vtkMatrix4x4>::New()),
      ProxyMatrix(vtkSmartPointer<vtkMatrix4x4>::New())
{
}

void vtkProbeRepresentation::SetToolSphere(double radius)
{
  this->SetTool(palpate::MakeToolSphere(radius));
}

double vtkProbeRepresentation::GetToolRadius()
{
  const vtkIdType count = this->Tool == nullptr ? 0 : this->Tool->GetNumberOfPoints();
  double least = count > 0 ? std::numeric_limits<double>::max() : 0.0;
  for (vtkIdType p = 0; p < count; ++p)
  {
    least = std::min(least, vtkMath::Norm(this->Tool->GetPoint(p)));
  }
  return least;
}

void vtkProbeRepresentation::SetPose(vtkMatrix4x4* matrix, const double position[3],
                                     const double orientation[4])
{
  if (!AreNumbers(position, 3) || !AreNumbers(orientation, 4))
  {
    return;
  }
  double rotation[3][3];
  vtkMath::QuaternionToMatrix3x3(orientation, rotation);
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      matrix->SetElement(row, column, rotation[row][column]);
    }
    matrix->SetElement(row, 3, position[row]);
  }
  this->Modified();
}

void vtkProbeRepresentation::SetProbePose(const double position[3], const double orientation[4])
{
  this->SetPose(this->ProbeMatrix, position, orientation);
}

void vtkProbeRepresentation::SetProxyPose(const double position[3], const double orientation[4])
{
  this->SetPose(this->ProxyMatrix, position, orientation);
}

void vtkProbeRepresentation::SetProbePose(const palpate::Vector3& position,
                                          const std::array<double, 4>& orientation)
{
  const double scalarFirst[4] = {orientation[3], orientation[0], orientation[1], orientation[2]};
  this->SetProbePose(position.data(), scalarFirst);
}

void vtkProbeRepresentation::SetProxyPose(const palpate::Vector3& position,
                                          const std::array<double, 4>& orientation)
{
  const double scalarFirst[4] = {orientation[3], orientation[0], orientation[1], orientation[2]};
  this->SetProxyPose(position.data(), scalarFirst);
}

void vtkProbeRepresentation::SetProbePosition(double x, double y, double z)
{
  const double position[3] = {x, y, z};
  this->SetProbePose(position, Upright);
}

void vtkProbeRepresentation::SetProxyPosition(double x, double y, double z)
{
  const double position[3] = {x, y, z};
  this->SetProxyPose(position, Upright);
}

void vtkProbeRepresentation::SetForce(double x, double y, double z)
{
  const double force[3] = {x, y, z};
  if (AreNumbers(force, 3) && !std::equal(force, force + 3, this->Force))
  {
    std::copy_n(force, 3, this->Force);
    this->Modified();
  }
}

void vtkProbeRepresentation::SetFoot(double x, double y, double z)
{
  const double point[3] = {x, y, z};
  const bool isSame = this->HasFoot && std::equal(point, point + 3, this->Foot);
  if (AreNumbers(point, 3) && !isSame)
  {
    std::copy_n(point, 3, this->Foot);
    this->HasFoot = true;
    this->Modified();
  }
}

void vtkProbeRepresentation::ClearFoot()
{
  if (this->HasFoot)
  {
    this->HasFoot = false;
    this->Modified();
  }
}

palpate::Vector3 vtkProbeRepresentation::ContactWorld()
{
  const palpate::Vector3 force(this->Force);
  if (this->HasFoot)
  {
    return palpate::Vector3(this->Foot);
  }
  return force.norm() > 0.0
             ? palpate::Vector3(this->ProxyWorld() - this->GetToolRadius() * force.normalized())
             : this->ProxyWorld();
}

void vtkProbeRepresentation::SetNearestPoint(double x, double y, double z)
{
  const double point[3] = {x, y, z};
  const bool isSame = this->HasNearestPoint && std::equal(point, point + 3, this->NearestPoint);
  if (AreNumbers(point, 3) && !isSame)
  {
    std::copy_n(point, 3, this->NearestPoint);
    this->HasNearestPoint = true;
    this->Modified();
  }
}

void vtkProbeRepresentation::ClearNearestPoint()
{
  if (this->HasNearestPoint)
  {
    this->HasNearestPoint = false;
    this->Modified();
  }
}

palpate::Vector3 vtkProbeRepresentation::ProxyWorld() const
{
  return {this->ProxyMatrix->GetElement(0, 3), this->ProxyMatrix->GetElement(1, 3),
          this->ProxyMatrix->GetElement(2, 3)};
}

void vtkProbeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tool: " << this->Tool.Get() << '\n';
  os << indent << "Force: (" << this->Force[0] << ", " << this->Force[1] << ", " << this->Force[2]
     << ")\n";
  os << indent << "ForceScale: " << this->ForceScale << '\n';
  os << indent << "InContact: " << this->InContact << '\n';
  os << indent << "HasFoot: " << this->HasFoot << '\n';
  os << indent << "ContactRadius: " << this->ContactRadius << '\n';
  os << indent << "Depth: " << this->Depth << '\n';
  os << indent << "HasNearestPoint: " << this->HasNearestPoint << '\n';
  os << indent << "Visibility: " << this->Visibility << '\n';
}
