#include "PathActivity.h"

#include "PlainLabel.h"

#include <QHBoxLayout>

namespace palpate
{
PathActivity::PathActivity(const TrialPlace& place, QWidget* strip)
    : TrialActivity(strip), Contents(place.Contents), Target(place.Target), Course(place.Target),
      Line(MakePlainLabel("task-line", this))
{
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(this->Line);
  this->Line->setText("Go to the path's start.");
}

PathActivity::~PathActivity()
{
  this->Contents.ShowTrial({});
}

void PathActivity::Begin()
{
  TrialMarks shown;
  for (const TaskPoint& point : this->Target.Points)
  {
    shown.Line.push_back(point.PointWorld);
  }
  shown.Points = {{"start", shown.Line.front()}, {"end", shown.Line.back()}};
  this->Contents.Crosshair()->SetPositionWorld(shown.Line.front().data());
  this->Contents.ShowTrial(shown);
}

void PathActivity::Take(const TouchState& newest, TaskWatch& watch)
{
  const Vector3 off = watch.TipWorld(newest) - this->Target.Points.front().PointWorld;
  if (this->Trace.empty() && watch.Trace().empty() && off.norm() <= this->Target.Tolerance)
  {
    watch.KeepTrace(true);
    this->Line->setText("Follow the path to its end.");
  }
  for (std::size_t n = this->Trace.size(); n < watch.Trace().size() && !this->IsDone(); ++n)
  {
    this->Trace.push_back(watch.Trace()[n]);
    this->Course.Take(this->Trace.back());
  }
}
} // namespace palpate
