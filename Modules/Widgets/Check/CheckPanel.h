#pragma once

#include "FileQuestions.h"
#include "PanelJob.h"
#include "StructureVerdicts.h"

#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

namespace palpate
{
/// Checks the masks of the open segmentation, as `palpate check` does: against a group of clean
/// cases, or by limits. Verdicts are for the structures' table; group and rate are remembered.
class CheckPanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  CheckPanel(StudyController& study, StructureVerdicts& verdicts, const FileQuestions& questions,
             QWidget* parent = nullptr);

  /// No effect while it checks.
  void Check();

private:
  QLayout* MakeGroup();
  void ChooseGroup();
  void SetGroup(const QString& file);
  void ShowGroup();
  void Take(const StructureVerdicts::Masks& masks, const MaskChecks& found, const QString& note);

  StructureVerdicts& Verdicts;
  const FileQuestions& Questions;
  QPushButton* Checking;
  QLabel* Group;
  QPushButton* NoGroup;
  QDoubleSpinBox* FalseAlarms; ///< percent of clean cases
  QLabel* Line;
  PanelJob* Job;
};
} // namespace palpate
