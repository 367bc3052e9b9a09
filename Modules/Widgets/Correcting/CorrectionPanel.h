#pragma once

#include "BrushLink.h"
#include "CorrectionLink.h"
#include "FileQuestions.h"
#include "PanelJob.h"
#include "SentenceLabel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include <vector>

namespace palpate
{
/// The structure that is being corrected: which one, how wide the next pull or the brush is, what a
/// neighbour does to it, the edits of masks, how much has changed, and what keeps the result.
class CorrectionPanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  CorrectionPanel(StudyController& study, CorrectionLink& link, BrushLink& brush,
                  const FileQuestions& questions, const ViewContents& contents,
                  QWidget* parent = nullptr);

private:
  QWidget* MakeButtons();
  QPushButton* MakeButton(const QString& text, const char* name, const QString& tip,
                          std::function<void()> act);
  void MakeChoices();
  void MakeTools();
  void MakeNeighbors();
  void MakeCuts();
  void ShowState();
  void ShowStructures();
  void ShowWidth();
  bool IsPulling() const { return this->Brush.Tool() == CorrectionTool::Pull; }
  QString Sentence() const;
  void CutBeyond(const Vector3& normal);
  void TakeLastBack();
  void Keep();

  StudyController& Study;
  CorrectionLink& Link;
  BrushLink& Brush;
  const FileQuestions& Questions;
  const ViewContents& Contents;
  QComboBox* Structure;
  std::vector<int> Ids; ///< of the structures that can be chosen; 0 first: none
  QComboBox* Tool;
  QDoubleSpinBox* Width; ///< of a pull, or the radius of the brush; mm
  QCheckBox* TwoWidths;
  QCheckBox* Edges; ///< of the brush, instead
  QComboBox* Neighbors;
  std::vector<QPushButton*> Edits; ///< of masks
  QPushButton* Back;
  QPushButton* Cut;
  QPushButton* Slices;
  QPushButton* Keeping;
  SentenceLabel* Line;
  QLabel* KeptLine;
  PanelJob* Job;
};
} // namespace palpate
