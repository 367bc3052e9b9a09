#include "CurveActor.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

namespace palpate
{
CurveActor::CurveActor()
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(this->Curves);
  mapper->ScalarVisibilityOff();
  this->Lines->SetMapper(mapper);
  this->Lines->GetProperty()->LightingOff();
  this->Lines->PickableOff();
}

void CurveActor::SetCurves(const std::vector<SurfaceCurve>& curves, const Vector3& lift)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  for (const SurfaceCurve& curve : curves)
  {
    const vtkIdType first = points->GetNumberOfPoints();
    lines->InsertNextCell(static_cast<int>(curve.Points.size()) + (curve.IsClosed ? 1 : 0));
    for (const Vector3& point : curve.Points)
    {
      const Vector3 lifted = point + lift;
      lines->InsertCellPoint(points->InsertNextPoint(lifted.data()));
    }
    if (curve.IsClosed)
    {
      lines->InsertCellPoint(first);
    }
  }
  this->Curves->SetPoints(points);
  this->Curves->SetLines(lines);
}

void CurveActor::SetStyle(const std::array<double, 3>& color, double opacity, double width)
{
  vtkProperty* property = this->Lines->GetProperty();
  property->SetColor(color[0], color[1], color[2]);
  property->SetOpacity(opacity);
  property->SetLineWidth(static_cast<float>(width));
}

void CurveActor::SetVisible(bool isVisible)
{
  this->Lines->SetVisibility(isVisible ? 1 : 0);
}
} // namespace palpate
