#include "OutlineActivity.h"

#include "ActivityRow.h"
#include "SurfaceCut.h"

namespace palpate
{
namespace
{
Vector3 OutlineCenter(const std::vector<TaskPoint>& points)
{
  Vector3 sum = Vector3::Zero();
  for (const TaskPoint& point : points)
  {
    sum += point.PointWorld;
  }
  return sum / static_cast<double>(points.size());
}

// Newell's; the task's file has only flat outlines.
Vector3 OutlineNormal(const std::vector<TaskPoint>& points)
{
  Vector3 normal = Vector3::Zero();
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    normal += points[i].PointWorld.cross(points[(i + 1) % points.size()].PointWorld);
  }
  return normal.normalized();
}
} // namespace

OutlineActivity::OutlineActivity(const TrialPlace& place, QWidget* strip)
    : TrialActivity(strip), Study(place.Study), Contents(place.Contents), Drawing(place.Drawing),
      Target(place.Target)
{
  this->Back = ActivityRow(*this, "Drag along the edge in the slice, click on it, or touch it with "
                                  "the tool: the yellow line is your outline.")
                   .AddButton("Undo", "task-undo");
  connect(this->Back, &QPushButton::clicked, &place.Study, &StudyController::Undo);
}

OutlineActivity::~OutlineActivity()
{
  this->Drawing.Mode()->setChecked(false);
}

void OutlineActivity::Begin()
{
  this->Contents.Crosshair()->SetPositionWorld(OutlineCenter(this->Target.Points).data());
  this->Drawing.Choose(DrawingLink::Next::Surface);
  this->Drawing.Mode()->setChecked(true);
}

void OutlineActivity::Take(const TouchState&, TaskWatch&)
{
  this->Back->setEnabled(!this->Study.State().Drawing.Touches.empty());
}

TaskAnswer OutlineActivity::Answer() const
{
  TaskAnswer answer;
  vtkPolyData* surface = this->Study.Current().Drawn().Organ().Surface();
  if (surface == nullptr)
  {
    return answer;
  }
  for (const SurfaceCurve& curve :
       CutSurface(surface, OutlineCenter(this->Target.Points), OutlineNormal(this->Target.Points)))
  {
    if (curve.IsClosed && curve.Points.size() > answer.PointsWorld.size())
    {
      answer.PointsWorld = curve.Points;
    }
  }
  return answer;
}
} // namespace palpate
