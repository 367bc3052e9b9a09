#pragma once

#include "FitPanel.h"
#include "StepRow.h"
#include "StudyController.h"

#include <QWidget>

#include <map>

namespace palpate
{
/// From files to touch: how each step stands, and what decides what it makes.
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
