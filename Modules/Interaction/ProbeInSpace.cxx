#include "ProbeInSpace.h"

#include "SurfaceMaterial.h"
#include "Vector3.h"
#include "vtkProbeRepresentation.h"

#include "vtkArrowSource.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr double ProbeOpacity = 0.35;
// Of an arrow of unit length: maximum ratio of thickness to length, mm.
constexpr double ArrowThickness = 14.0;
constexpr double LeastForce = 1e-3; // N; shorter arrows are not drawn

void SetToolMaterial(vtkActor* actor)
{
  actor->GetProperty()->SetAmbient(SurfaceMaterial::Ambient);
  actor->GetProperty()->SetDiffuse(SurfaceMaterial::Diffuse);
  actor->PickableOff();
}

// Transforms an arrow along x to one from a point along a vector, with constant thickness.
void PlaceArrow(const Vector3& from, const Vector3& vector, vtkMatrix4x4* matrix)
{
  const Vector3 along = vector.normalized();
  const Vector3 across = along.unitOrthogonal();
  const double thickness = std::min(ArrowThickness, vector.norm());
  Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> pose(matrix->GetData());
  pose.topRows<3>() << vector, thickness * across, thickness * along.cross(across), from;
  matrix->Modified();
}
} // namespace

ProbeInSpace::ProbeInSpace()
{
  vtkNew<vtkPolyDataMapper> tool;
  this->Probe->SetMapper(tool);
  vtkNew<vtkPolyDataMapper> sameTool;
  this->Proxy->SetMapper(sameTool);
  this->Probe->GetProperty()->SetOpacity(ProbeOpacity);
  vtkNew<vtkArrowSource> arrow;
  arrow->SetTipResolution(16);
  arrow->SetShaftResolution(12);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(arrow->GetOutputPort());
  this->Arrow->SetMapper(mapper);
  this->Arrow->SetUserMatrix(vtkNew<vtkMatrix4x4>());
  for (vtkActor* actor : {this->Probe.Get(), this->Proxy.Get(), this->Arrow.Get()})
  {
    SetToolMaterial(actor);
    this->Add(actor);
  }
}

void ProbeInSpace::Update(vtkProbeRepresentation* probe)
{
  const bool isShown = probe != nullptr && probe->GetVisibility() && probe->GetTool() != nullptr;
  const bool hasForce =
      isShown && Vector3(probe->GetForce()).norm() > LeastForce && probe->GetForceScale() > 0.0;
  this->Probe->SetVisibility(isShown ? 1 : 0);
  this->Proxy->SetVisibility(isShown ? 1 : 0);
  this->Arrow->SetVisibility(hasForce ? 1 : 0);
  if (!isShown)
  {
    return;
  }
  for (vtkActor* actor : {this->Probe.Get(), this->Proxy.Get()})
  {
    static_cast<vtkPolyDataMapper*>(actor->GetMapper())->SetInputData(probe->GetTool());
    actor->GetProperty()->SetColor(probe->GetColor());
  }
  this->Probe->SetUserMatrix(probe->GetProbeMatrix());
  this->Proxy->SetUserMatrix(probe->GetProxyMatrix());
  if (hasForce)
  {
    const Vector3 from = probe->ProxyWorld();
    PlaceArrow(from, probe->GetForceScale() * Vector3(probe->GetForce()),
               this->Arrow->GetUserMatrix());
    this->Arrow->GetProperty()->SetColor(probe->GetContactColor());
  }
}
} // namespace palpate
