#include "PlumbLine.h"

#include "vtkProbeRepresentation.h"

#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr double PlumbWidth = 1.5; // pixels
}

void PlumbLine::SetRenderer(vtkRenderer* renderer)
{
  if (this->Renderer != nullptr)
  {
    this->Renderer->RemoveViewProp(this->Line.Actor());
  }
  if (renderer != nullptr)
  {
    renderer->AddViewProp(this->Line.Actor());
  }
  this->Length.SetRenderer(renderer);
  this->Renderer = renderer;
}

void PlumbLine::Update(vtkProbeRepresentation* probe, LengthUnit unit)
{
  const bool isShown = probe != nullptr && probe->GetVisibility() && !probe->GetInContact() &&
                       probe->GetHasNearestPoint();
  this->Line.SetVisible(isShown);
  if (!isShown)
  {
    this->Length.Update({}, {});
    return;
  }
  const Vector3 tool = probe->ProxyWorld();
  const Vector3 nearest(probe->GetNearestPoint());
  const double distance = std::max(0.0, (nearest - tool).norm() - probe->GetToolRadius());
  const double* color = probe->GetColor();
  this->Line.SetCurves({{{tool, nearest}, false}}, Vector3::Zero());
  this->Line.SetStyle({{color[0], color[1], color[2]}}, 1.0, PlumbWidth);
  this->Length.Update({{LengthText(unit, distance, 1), 0.5 * (tool + nearest)}},
                      {{color[0], color[1], color[2]}});
}
} // namespace palpate
