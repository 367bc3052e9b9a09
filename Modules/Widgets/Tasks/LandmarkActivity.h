#pragma once

#include "MarkButton.h"
#include "TrialActivity.h"

#include <QLabel>

#include <cstddef>
#include <vector>

namespace palpate
{
/// Landmarks are displayed one after the other, and marked with the tool.
class LandmarkActivity : public TrialActivity
{
  Q_OBJECT

public:
  LandmarkActivity(const TrialPlace& place, QWidget* strip);
  ~LandmarkActivity() override;

  void Begin() override;
  void Take(const TouchState& newest, TaskWatch& watch) override;
  bool HasAnswer() const override;
  TaskAnswer Answer() const override { return {this->Marks}; }

private:
  void Show();
  void GoTo(std::size_t number);

  ViewContents& Contents;
  const TaskTarget& Target;
  std::vector<Vector3> Marks; ///< one for each landmark, NaN: none
  std::size_t Next = 0;       ///< the landmark to be marked
  QLabel* Line;
  MarkButton* Mark;
  QPushButton* Back;
  QPushButton* Skip;
};
} // namespace palpate
