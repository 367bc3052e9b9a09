#pragma once

#include "FitPanel.h"
#include "StepRow.h"
#include "StudyController.h"

#include <QWidget>

#include <map>

namespace palpate
{
/// The pipeline from files to touch: status of each step, and the options of the fit.
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
