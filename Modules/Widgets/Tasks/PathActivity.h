#pragma once

#include "PathCourse.h"
#include "TrialActivity.h"

#include <QLabel>

#include <cstddef>
#include <vector>

namespace palpate
{
/// A path is followed with the tool, whose places are kept from its start on. The trial ends where
/// the path does.
class PathActivity : public TrialActivity
{
  Q_OBJECT

public:
  PathActivity(const TrialPlace& place, QWidget* strip);
  ~PathActivity() override;

  void Begin() override;
  void Take(const TouchState& newest, TaskWatch& watch) override;
  bool HasAnswer() const override { return !this->Trace.empty(); }
  TaskAnswer Answer() const override { return {this->Trace}; }
  bool IsDone() const override { return this->Course.Share() == 1.0; }

private:
  ViewContents& Contents;
  const TaskTarget& Target;
  PathCourse Course;
  std::vector<Vector3> Trace; ///< of the tool, world, mm
  QLabel* Line;
};
} // namespace palpate
