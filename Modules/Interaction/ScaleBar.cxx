#include "ScaleBar.h"

#include "ViewText.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkTextActor.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double ScaleLeft = 0.02;   // of the view's width
constexpr double ScaleBottom = 0.03; // of its height
constexpr double LargestShare = 0.3; // of its width
constexpr double TickPoints = 4.0;
constexpr int ScaleTextSize = 11;
} // namespace

ScaleBar::ScaleBar() : Label(MakeViewText(ScaleLeft, ScaleBottom, ScaleTextSize))
{
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(this->Line);
  this->Bar->SetMapper(mapper);
  this->Bar->GetProperty()->SetColor(1.0, 1.0, 1.0);
  this->Bar->PickableOff();
  this->Add(this->Bar);
  this->Add(this->Label);
}

double ScaleBar::RoundLength(double millimeters)
{
  const double decade = std::pow(10.0, std::floor(std::log10(millimeters)));
  double length = decade;
  for (const double step : {2.0, 5.0, 10.0})
  {
    // Rounding must not reject an exact match.
    length = step * decade <= millimeters * (1.0 + 1e-12) ? step * decade : length;
  }
  return length;
}

void ScaleBar::Update(double pixelMillimeters, int width, int height, double pointPixels,
                      LengthUnit unit)
{
  this->Length = RoundLength(LargestShare * width * pixelMillimeters);
  const double left = ScaleLeft * width;
  const double right = left + this->Length / pixelMillimeters;
  const double bottom = ScaleBottom * height;
  const double tick = TickPoints * pointPixels;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(left, bottom + tick, 0.0);
  points->InsertNextPoint(left, bottom, 0.0);
  points->InsertNextPoint(right, bottom, 0.0);
  points->InsertNextPoint(right, bottom + tick, 0.0);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({0, 1, 2, 3});
  this->Line->SetPoints(points);
  this->Line->SetLines(lines);
  this->Bar->GetProperty()->SetLineWidth(static_cast<float>(0.5 * tick));
  SetViewText(this->Label, LengthText(unit, this->Length, this->Length < 1.0 ? 3 : 0));
  this->Label->SetPosition(ScaleLeft, ScaleBottom + 1.5 * tick / height);
}
} // namespace palpate
