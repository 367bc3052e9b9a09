#include "MarkPlacer.h"

#include "DisplayedSurface.h"
#include "FitResult.h"

#include <algorithm>

namespace palpate
{
namespace
{
// A preview may take a tenth of the time of the window's thread.
constexpr qint64 LeastPause = 100; // ms
constexpr qint64 PausePerPreview = 10;
} // namespace

MarkPlacer::MarkPlacer(StudyController& study, ViewContents& contents, QObject* parent)
    : QObject(parent), Study(study), Contents(contents)
{
  connect(&study, &StudyController::StateChanged, this, &MarkPlacer::PlaceWaiting);
  connect(&study, &StudyController::Touched, this, &MarkPlacer::FollowTouch);
  connect(&study, &StudyController::TouchChanged, this, &MarkPlacer::ClearPreview);
}

void MarkPlacer::Choose(std::optional<MeasurementKind> kind)
{
  this->Kind = kind;
  this->Waiting.clear();
  this->ClearPreview();
}

void MarkPlacer::TakeSurfaces()
{
  std::map<int, vtkPolyData*> shown;
  for (const auto& [id, surface] : this->Contents.Surfaces())
  {
    if (surface->GetSurface() != nullptr)
    {
      shown[id] = surface->GetSurface();
    }
  }
  MeasuredSurfaces::Models models;
  for (const SceneStructure& structure : this->Study.State().Structures)
  {
    const auto fit = this->Contents.Correction().IsOf(structure.Id)
                         ? nullptr
                         : ModelOf(this->Study.Current().Pipeline(), structure);
    if (fit != nullptr)
    {
      models[structure.Id] = {fit, &fit->Model};
    }
  }
  this->Surfaces.Show(shown, models);
}

void MarkPlacer::Place(const PlacedPoint& point)
{
  StudyState next = this->Study.State();
  if (!this->Kind)
  {
    const std::string name = "F-" + std::to_string(next.Landmarks.size() + 1);
    next.Landmarks.push_back({name, point.PointWorld});
    this->Study.Change("Add the landmark " + QString::fromStdString(name), next);
    return;
  }
  this->TakeSurfaces();
  const Status status = AddPoint(next, *this->Kind, point, this->Surfaces);
  if (!status.IsOk() && this->Surfaces.IsPreparing())
  {
    this->Waiting.push_back(point);
    this->ShowPreparing();
    return;
  }
  if (!status.IsOk())
  {
    this->Study.Report(status.Message());
    return;
  }
  const StudyMeasurement* open = OpenMeasurement(next);
  const QString name =
      QString::fromStdString(open != nullptr ? open->Name : next.Measurements.back().Name);
  this->Study.Change(open != nullptr
                         ? QString("Add point %1 of %2").arg(open->PointsWorld.size()).arg(name)
                         : QString("Measure %1").arg(name),
                     next);
}

// In their order, since the first of a measurement decides on its structure.
void MarkPlacer::PlaceWaiting()
{
  this->ClearPreview();
  if (this->Waiting.empty() || this->Surfaces.IsPreparing())
  {
    return;
  }
  std::vector<PlacedPoint> ready;
  ready.swap(this->Waiting);
  for (const PlacedPoint& point : ready)
  {
    this->Place(point);
  }
}

void MarkPlacer::ShowPreparing()
{
  Q_EMIT Previewed("Preparing the surface for measurements...");
}

PlacedPoint MarkPlacer::TouchedPoint()
{
  const StudyTouchReading& reading = this->Study.Reading();
  const PlainVector3& proxy = reading.Newest.ProxyWorld;
  PlacedPoint point{Vector3(proxy.X, proxy.Y, proxy.Z), reading.TouchedId};
  if (point.StructureId != 0)
  {
    // The proxy is the tool's centre.
    this->TakeSurfaces();
    const auto contact =
        this->Surfaces.Nearest(point.PointWorld, FarthestPlacing, point.StructureId);
    point.PointWorld = contact ? contact->PointWorld : point.PointWorld;
  }
  return point;
}

void MarkPlacer::PlaceWhereTouched()
{
  if (this->Study.IsTouching())
  {
    this->Place(this->TouchedPoint());
  }
  else
  {
    this->Study.Report("Touch is off: start touching to place landmarks at the tool's contact.");
  }
}

bool MarkPlacer::HasOpenCurve() const
{
  const StudyMeasurement* open = OpenMeasurement(this->Study.State());
  return open != nullptr && PointCountOf(open->Kind) == 0;
}

void MarkPlacer::End()
{
  StudyState next = this->Study.State();
  const StudyMeasurement* open = OpenMeasurement(next);
  const QString name = open != nullptr ? QString::fromStdString(open->Name) : QString();
  if (EndMeasurement(next))
  {
    this->Study.Change("End " + name, next);
  }
}

void MarkPlacer::Preview(const PlacedPoint& point)
{
  const StudyMeasurement* open = OpenMeasurement(this->Study.State());
  const bool continues = open != nullptr && this->Kind == open->Kind;
  const bool isDue = !this->SincePreview.isValid() || this->SincePreview.elapsed() >= this->Pause;
  // A thickness has its value at its first point.
  if (!isDue || (!continues && this->Kind != MeasurementKind::Thickness))
  {
    return;
  }
  QElapsedTimer duration;
  duration.start();
  StudyMeasurement next;
  next.Kind = *this->Kind;
  next.Name = NameOf(next.Kind);
  next = continues ? *open : next;
  this->TakeSurfaces();
  // On triangles, which is fast; where it is placed, a model's own length counts.
  if (AddPoint(next, point, this->Surfaces, MeasuredSurfaces::PathOn::Triangles).IsOk())
  {
    this->Contents.ShowPreview(next);
    Q_EMIT Previewed(QString::fromStdString(next.Name + ": " + ValueText(next, this->Unit)));
  }
  else
  {
    this->ClearPreview();
    if (this->Surfaces.IsPreparing())
    {
      this->ShowPreparing();
    }
  }
  this->Pause = std::max(LeastPause, PausePerPreview * duration.elapsed());
  this->SincePreview.start();
}

void MarkPlacer::ClearPreview()
{
  this->Contents.ShowPreview(std::nullopt);
  Q_EMIT Previewed({});
}

void MarkPlacer::FollowTouch()
{
  if (this->Kind && this->Study.IsTouching())
  {
    this->Preview(this->TouchedPoint());
  }
}
} // namespace palpate
