#include "AxesMarker.h"

#include "ViewText.h"

#include "vtkCellArray.h"
#include "vtkCoordinate.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

namespace palpate
{
namespace
{
constexpr double AxisLength = 26.0; // points
constexpr double Reach = 42.0;      // from the corner to the centre
constexpr double LetterPlace = 1.3; // of an axis
constexpr int AxisLetterSize = 12;
constexpr double AxisWidth = 1.5;
} // namespace

AxesMarker::AxesMarker()
{
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(this->Lines);
  this->Axes->SetMapper(mapper);
  this->Axes->GetProperty()->SetColor(1.0, 1.0, 1.0);
  this->Axes->PickableOff();
  this->Add(this->Axes);
  for (int part = 0; part < 3; ++part)
  {
    auto& letter = this->Letters[static_cast<std::size_t>(part)];
    letter = MakeViewText(0.5, 0.5, AxisLetterSize); // centred
    letter->GetPositionCoordinate()->SetCoordinateSystemToViewport();
    SetViewText(letter, OrientationLetters(Vector3::Unit(part)));
    this->Add(letter);
  }
}

void AxesMarker::SetGrey(double grey)
{
  this->Axes->GetProperty()->SetColor(grey, grey, grey);
  for (const auto& letter : this->Letters)
  {
    letter->GetTextProperty()->SetColor(grey, grey, grey);
  }
}

void AxesMarker::Update(const ViewFrame& frame, int width, double pointPixels)
{
  const double length = AxisLength * pointPixels;
  const double middle[2] = {width - Reach * pointPixels, Reach * pointPixels};
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  const vtkIdType start = points->InsertNextPoint(middle[0], middle[1], 0.0);
  for (int part = 0; part < 3; ++part)
  {
    const double right = length * frame.RightWorld[part];
    const double up = length * frame.UpWorld[part];
    lines->InsertNextCell({start, points->InsertNextPoint(middle[0] + right, middle[1] + up, 0.0)});
    this->Letters[static_cast<std::size_t>(part)]->SetPosition(middle[0] + LetterPlace * right,
                                                               middle[1] + LetterPlace * up);
  }
  this->Lines->SetPoints(points);
  this->Lines->SetLines(lines);
  this->Axes->GetProperty()->SetLineWidth(static_cast<float>(AxisWidth * pointPixels));
}
} // namespace palpate
