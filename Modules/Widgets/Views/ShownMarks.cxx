#include "ShownMarks.h"

#include "vtkPoints.h"

namespace palpate
{
void ShownMarks::Show(const StudyState& state)
{
  if (this->Landmarks == state.Landmarks && this->Measurements == state.Measurements)
  {
    return;
  }
  this->Landmarks = state.Landmarks;
  this->Measurements = state.Measurements;
  this->Update();
}

void ShownMarks::ShowPreview(const std::optional<StudyMeasurement>& preview)
{
  if (!(this->Preview == preview))
  {
    this->Preview = preview;
    this->Update();
  }
}

void ShownMarks::ShowDrawing(const StudyDrawing& drawing, const std::vector<Vector3>& next)
{
  if (!(this->Drawing == drawing) || this->Next != next)
  {
    this->Drawing = drawing;
    this->Next = next;
    this->Update();
  }
}

void ShownMarks::ShowRing(const std::vector<Vector3>& ring, const std::string& text)
{
  if (this->Ring != ring || this->RingText != text)
  {
    this->Ring = ring;
    this->RingText = text;
    this->Update();
  }
}

void ShownMarks::ShowTrial(const TrialMarks& marks)
{
  this->Trial = marks;
  this->Update();
}

void ShownMarks::SetLengthUnit(LengthUnit unit)
{
  this->Unit = unit;
  this->Update();
}

void ShownMarks::Update()
{
  this->Shown->RemoveAll();
  for (const StudyLandmark& mark : this->Landmarks)
  {
    this->Shown->AddLandmark(mark.Name.c_str(), mark.PositionWorld.data());
  }
  for (const StudyMeasurement& measurement : this->Measurements)
  {
    if (!measurement.IsOpen || !this->Preview)
    {
      this->Add(measurement);
    }
  }
  if (this->Preview)
  {
    this->Add(*this->Preview);
  }
  this->AddDrawing();
  if (!this->Ring.empty())
  {
    vtkNew<vtkPoints> line;
    line->SetDataTypeToDouble();
    for (const Vector3& place : this->Ring)
    {
      line->InsertNextPoint(place.data());
    }
    this->Shown->AddCurve(this->RingText.c_str(), this->Ring.front().data(), line, true);
  }
  this->AddTrial();
}

void ShownMarks::AddTrial()
{
  for (const StudyLandmark& mark : this->Trial.Points)
  {
    this->Shown->AddLandmark(mark.Name.c_str(), mark.PositionWorld.data());
  }
  if (!this->Trial.Line.empty())
  {
    vtkNew<vtkPoints> line;
    line->SetDataTypeToDouble();
    for (const Vector3& place : this->Trial.Line)
    {
      line->InsertNextPoint(place.data());
    }
    this->Shown->AddCurve("", this->Trial.Line.front().data(), line, false);
  }
}

void ShownMarks::AddDrawing()
{
  vtkNew<vtkPoints> line;
  line->SetDataTypeToDouble();
  const std::vector<SurfaceTouch>& all = this->Drawing.Touches;
  for (std::size_t n = 0; n < all.size(); ++n)
  {
    if (all[n].Stroke == 0)
    {
      this->Shown->AddLandmark(all[n].IsOutside ? "outside" : "", all[n].PointWorld.data());
      continue;
    }
    line->InsertNextPoint(all[n].PointWorld.data());
    if (n + 1 == all.size() || all[n + 1].Stroke != all[n].Stroke)
    {
      this->Shown->AddCurve("", all[n].PointWorld.data(), line, false);
      line->Initialize();
    }
  }
  if (this->Drawing.CenterWorld)
  {
    this->Shown->AddLandmark("middle", this->Drawing.CenterWorld->data());
  }
  for (std::size_t n = 0; n < this->Next.size(); ++n)
  {
    const std::string number = std::to_string(all.size() + n + 1);
    this->Shown->AddLandmark(number.c_str(), this->Next[n].data());
  }
}

void ShownMarks::Add(const StudyMeasurement& measurement)
{
  // Curves of other programs may have thousands of points: spheres at all of them would hide it.
  constexpr std::size_t MostSpheres = 50;
  const std::vector<Vector3>& points = measurement.PointsWorld;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (points.size() <= MostSpheres || i == 0 || i + 1 == points.size())
    {
      this->Shown->AddLandmark("", points[i].data());
    }
  }
  vtkNew<vtkPoints> line;
  line->SetDataTypeToDouble();
  for (const Vector3& place : measurement.Line())
  {
    line->InsertNextPoint(place.data());
  }
  const std::string value = ValueText(measurement, this->Unit);
  this->Shown->AddCurve((value.empty() ? measurement.Name : value).c_str(),
                        LabelPlaceOf(measurement).data(), line,
                        measurement.Kind == MeasurementKind::Plane);
}
} // namespace palpate
