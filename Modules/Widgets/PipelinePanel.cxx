#include "PipelinePanel.h"

#include <QGridLayout>

namespace palpate
{
PipelinePanel::PipelinePanel(StudyController& study, QWidget* parent)
    : QWidget(parent), Study(study)
{
  auto* table = new QGridLayout(this);
  table->setColumnStretch(2, 1);
  table->setVerticalSpacing(2);
  int row = 0;
  for (const SceneStep step :
       {SceneStep::Volume, SceneStep::Segmentation, SceneStep::Structures, SceneStep::Surface,
        SceneStep::Samples, SceneStep::Model, SceneStep::Elasticity, SceneStep::Field,
        SceneStep::Protection, SceneStep::Touch})
  {
    auto* line = new StepRow(step, table, row++, this);
    connect(line, &StepRow::CancelAsked, &study, &StudyController::CancelStep);
    connect(line, &StepRow::RepeatAsked, &study, &StudyController::ResumeStep);
    this->Rows[step] = line;
  }
  connect(&study, &StudyController::StepsChanged, this, &PipelinePanel::Show);
  this->Show();
}

void PipelinePanel::Show()
{
  for (const auto& [step, row] : this->Rows)
  {
    row->Show(this->Study.StateOf(step));
  }
}
} // namespace palpate
