#include "PlumbLine.h"

#include "DecimalText.h"
#include "ViewText.h"
#include "vtkProbeRepresentation.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace palpate
{
namespace
{
constexpr double PlumbWidth = 1.5; // pixels
constexpr double BarWidth = 6.0;   // pixels
constexpr double BarPixels = 15.0; // of a newton
constexpr double BarAside = 24.0;  // pixels from the tool's edge

// mm of the world per pixel at a point.
double MillimetersPerPixel(vtkRenderer* renderer, const Vector3& point)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double pixels = std::max(1, renderer->GetSize()[1]);
  if (camera->GetParallelProjection() != 0)
  {
    return 2.0 * camera->GetParallelScale() / pixels;
  }
  const Vector3 sight(camera->GetDirectionOfProjection());
  const double depth = (point - Vector3(camera->GetPosition())).dot(sight);
  return 2.0 * depth * std::tan(0.5 * camera->GetViewAngle() * M_PI / 180.0) / pixels;
}
} // namespace

std::string PressText(vtkProbeRepresentation* probe, LengthUnit unit)
{
  vtkMatrix4x4* pose = probe->GetProbeMatrix();
  const Vector3 hand(pose->GetElement(0, 3), pose->GetElement(1, 3), pose->GetElement(2, 3));
  const double depth = probe->GetDepth();
  return FixedText(Vector3(probe->GetForce()).norm(), 2) + " N, " +
         LengthText(unit, depth < 0.0 ? (hand - probe->ProxyWorld()).norm() : depth, 1) + " deep";
}

void PlumbLine::SetRenderer(vtkRenderer* renderer)
{
  if (this->Renderer != nullptr)
  {
    this->Renderer->RemoveViewProp(this->Line.Actor());
    this->Renderer->RemoveViewProp(this->Bar.Actor());
  }
  if (renderer != nullptr)
  {
    renderer->AddViewProp(this->Line.Actor());
    renderer->AddViewProp(this->Bar.Actor());
  }
  this->Length.SetRenderer(renderer);
  this->Renderer = renderer;
}

void PlumbLine::ShowForce(vtkProbeRepresentation* probe, LengthUnit unit)
{
  const Vector3 tool = probe->ProxyWorld();
  const double force = Vector3(probe->GetForce()).norm();
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const double pixel = MillimetersPerPixel(this->Renderer, tool);
  const Vector3 up = Vector3(camera->GetViewUp()).normalized();
  const Vector3 right = Vector3(camera->GetDirectionOfProjection()).cross(up).normalized();
  const Vector3 foot = tool + (probe->GetToolRadius() + BarAside * pixel) * right;
  const double* color = probe->GetContactColor();
  this->Bar.SetCurves({{{foot, foot + force * BarPixels * pixel * up}, false}}, Vector3::Zero());
  this->Bar.SetStyle({{color[0], color[1], color[2]}}, 1.0, BarWidth * PointPixels(this->Renderer));
  this->Length.Update({{PressText(probe, unit), foot}}, {{1.0, 1.0, 1.0}});
}

void PlumbLine::Update(vtkProbeRepresentation* probe, LengthUnit unit)
{
  const bool isShown = probe != nullptr && probe->GetVisibility() && !probe->GetInContact() &&
                       probe->GetHasNearestPoint();
  const bool isPressed = probe != nullptr && probe->GetVisibility() && probe->GetInContact() &&
                         this->Renderer != nullptr;
  this->Line.SetVisible(isShown);
  this->Bar.SetVisible(isPressed);
  if (isPressed)
  {
    this->ShowForce(probe, unit);
    return;
  }
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
  this->Length.Update({{LengthText(unit, distance, 1), 0.5 * (tool + nearest)}}, {{1.0, 1.0, 1.0}});
}
} // namespace palpate
