#include "ProbeInSlice.h"

#include "PlumbLine.h"
#include "ViewText.h"
#include "vtkProbeRepresentation.h"

#include "vtkActor.h"
#include "vtkCoordinate.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkTextProperty.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr double CutProbeOpacity = 0.6;
constexpr double ProbeWidth = 1.0; // points
constexpr double ProxyWidth = 2.0;
constexpr double ArrowWidth = 2.0;
constexpr double HeadPoints = 9.0;
constexpr double CrossPoints = 3.5;
constexpr double TextGap = 5.0; // points from the tool
constexpr int TextSize = 11;
constexpr double TextWidth = 120.0; // points, of "10.00 N, 10.0 mm deep"

std::array<double, 3> ToArray(const double* color)
{
  return {{color[0], color[1], color[2]}};
}
} // namespace

std::vector<SurfaceCurve> ToolSection(vtkPolyData* tool, vtkMatrix4x4* place,
                                      const Vector3& originWorld, const Vector3& normalWorld)
{
  const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> pose(place->GetData());
  const Matrix3 turn = pose.topLeftCorner<3, 3>();
  const Vector3 position = pose.topRightCorner<3, 1>();
  std::vector<SurfaceCurve> curves =
      CutSurface(tool, turn.transpose() * (originWorld - position), turn.transpose() * normalWorld);
  for (SurfaceCurve& curve : curves)
  {
    for (Vector3& point : curve.Points)
    {
      point = turn * point + position;
    }
  }
  return curves;
}

std::vector<SurfaceCurve> FlatArrow(const Vector3& from, const Vector3& vector,
                                    const Vector3& normal, double headLength)
{
  const double length = vector.norm();
  if (!(length > 0.0))
  {
    return {};
  }
  const Vector3 along = vector / length;
  const Vector3 across = normal.cross(along);
  const Vector3 tip = from + vector;
  const double head = std::min(headLength, length);
  const Vector3 back = tip - head * along;
  return {{{from, tip}, false},
          {{back + 0.5 * head * across, tip, back - 0.5 * head * across}, false}};
}

bool HasRoomAtRight(const SlicePosition& slice, const Vector3& beginWorld)
{
  const double begin =
      (beginWorld - slice.CenterWorld).dot(slice.Frame.RightWorld) / slice.PixelMillimeters;
  return begin + TextWidth * slice.PointPixels <= 0.5 * slice.Width;
}

ProbeInSlice::ProbeInSlice() : Text(MakeViewText(0.0, 0.5, TextSize))
{
  for (const HaloCurve* curve : {&this->Probe, &this->Proxy, &this->Arrow, &this->Contact})
  {
    for (vtkActor* actor : curve->Actors())
    {
      this->Add(actor);
    }
  }
  this->Text->GetPositionCoordinate()->SetCoordinateSystemToWorld();
  this->Add(this->Text);
}

// Where the tool's surface is pressed, and how strongly.
void ProbeInSlice::ShowContact(vtkProbeRepresentation* probe, const SlicePosition& slice,
                               LengthUnit unit)
{
  const Vector3 proxy = probe->ProxyWorld();
  const Vector3 place = slice.Projected(probe->ContactWorld());
  const double pixel = slice.PointPixels * slice.PixelMillimeters;
  const Vector3 right = CrossPoints * pixel * slice.Frame.RightWorld;
  const Vector3 up = CrossPoints * pixel * slice.Frame.UpWorld;
  this->Contact.SetCurves({{{place - right - up, place + right + up}, false},
                           {{place - right + up, place + right - up}, false}},
                          slice.Lift(ArrowLayer));
  this->Contact.SetStyle(ToArray(probe->GetContactColor()), 1.0, ArrowWidth * slice.PointPixels);
  const Vector3 aside = (probe->GetToolRadius() + TextGap * pixel) * slice.Frame.RightWorld;
  const bool isAtRight = HasRoomAtRight(slice, proxy + aside);
  const Vector3 edge = slice.Projected(isAtRight ? Vector3(proxy + aside) : Vector3(proxy - aside));
  this->Text->GetTextProperty()->SetJustification(isAtRight ? VTK_TEXT_LEFT : VTK_TEXT_RIGHT);
  this->Text->GetPositionCoordinate()->SetValue(edge.x(), edge.y(), edge.z());
  SetViewText(this->Text, PressText(probe, unit));
}

void ProbeInSlice::Update(vtkProbeRepresentation* probe, const SlicePosition& slice,
                          LengthUnit unit)
{
  const bool isShown = probe != nullptr && probe->GetVisibility() && probe->GetTool() != nullptr;
  this->SetVisible(isShown);
  if (!isShown)
  {
    return;
  }
  const Vector3& normal = slice.Frame.TowardsViewerWorld;
  const auto cut = [&](vtkMatrix4x4* place)
  { return ToolSection(probe->GetTool(), place, slice.CenterWorld, normal); };
  const std::vector<SurfaceCurve> proxy = cut(probe->GetProxyMatrix());
  this->Probe.SetCurves(cut(probe->GetProbeMatrix()), slice.Lift(ProbeLayer));
  this->Proxy.SetCurves(proxy, slice.Lift(ProbeLayer));
  const double size = slice.PointPixels;
  this->Probe.SetStyle(ToArray(probe->GetColor()), CutProbeOpacity, ProbeWidth * size);
  this->Proxy.SetStyle(ToArray(probe->GetColor()), 1.0, ProxyWidth * size);

  const Vector3 from = probe->ProxyWorld();
  const Vector3 arrow = probe->GetForceScale() * Vector3(probe->GetForce());
  const Vector3 inPlane = arrow - arrow.dot(normal) * normal;
  this->Arrow.SetCurves(proxy.empty() ? std::vector<SurfaceCurve>{}
                                      : FlatArrow(slice.Projected(from), inPlane, normal,
                                                  HeadPoints * size * slice.PixelMillimeters),
                        slice.Lift(ArrowLayer));
  this->Arrow.SetStyle(ToArray(probe->GetContactColor()), 1.0, ArrowWidth * size);
  const bool isPressed = probe->GetInContact() && !proxy.empty();
  this->Text->SetVisibility(isPressed ? 1 : 0);
  for (vtkActor* actor : this->Contact.Actors())
  {
    actor->SetVisibility(isPressed ? 1 : 0);
  }
  if (isPressed)
  {
    this->ShowContact(probe, slice, unit);
  }
}
} // namespace palpate
