#pragma once

#include "StepRow.h"
#include "StudyController.h"

#include <QWidget>

#include <map>

namespace palpate
{
/// The pipeline from files to touch: the status of each step.
class PipelinePanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the address.
  explicit PipelinePanel(StudyController& study, QWidget* parent = nullptr);

private:
  void Show();

  StudyController& Study;
  std::map<SceneStep, StepRow*> Rows;
};
} // namespace palpate
