#pragma once

#include "DrawingLink.h"
#include "FileQuestions.h"
#include "PanelJob.h"
#include "SentenceLabel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QWidget>

#include <vector>

namespace palpate
{
/// The organ that is drawn by touch: its prior, its touches in a table, what is known of its
/// surface or why it is refused, and what makes it a structure.
class DrawingPanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  DrawingPanel(StudyController& study, DrawingLink& link, const FileQuestions& questions,
               QWidget* parent = nullptr);

  void SetLengthUnit(LengthUnit unit);

Q_SIGNALS:
  /// The user chose a touch: show this point (world, mm).
  void Chosen(const Vector3& pointWorld);

private:
  QWidget* MakeButtons();
  QPushButton* MakeButton(const QString& text, const char* name, void (DrawingPanel::*act)());
  void MakeChoices();
  void MakeKnown();
  void MakeSoftened();
  void ShowState();
  void ShowTouches();
  void ShowPrior();
  void ShowKnown();
  QString Sentence() const;
  QString SentenceOfProblems() const;
  QString SentenceOfOrgan() const;
  void ChoosePrior();
  void SetPrior(const std::filesystem::path& file);
  void SetKnown(int row);
  void Change(const QString& message, const StudyDrawing& drawing, const QString& gesture = {});
  void Remove();
  void Clear();
  void Import();
  void Export();
  void Keep();

  StudyController& Study;
  DrawingLink& Link;
  const FileQuestions& Questions;
  LengthUnit Unit = LengthUnit::Millimeter;
  QTableWidget* Table;
  std::vector<std::size_t> Rows; ///< the first touch of each
  QComboBox* Next;
  QPushButton* Prior;
  QComboBox* Known;
  bool HadKnown = false;
  QDoubleSpinBox* Sigma; ///< mm
  QCheckBox* Touchable;
  QCheckBox* Softened;
  QCheckBox* Contacts;
  QPushButton* Keeping;
  SentenceLabel* Line;
  QLabel* KeptLine;
  PanelJob* Job;
};
} // namespace palpate
