#pragma once

#include "LengthText.h"
#include "StudyController.h"

#include <QLabel>
#include <QStatusBar>
#include <QToolButton>

namespace palpate
{
/// The place under the pointer, what is being written, and the state of touch. It never makes the
/// window wider.
class StatusLine : public QStatusBar
{
  Q_OBJECT

public:
  /// Keeps the address.
  StatusLine(StudyController& study, QWidget* parent);

  /// Position of the pointer (world, mm), and the text of ViewContents::TextAt for it.
  void ShowPoint(const Vector3& pointWorld, const std::string& text);
  void SetLengthUnit(LengthUnit unit) { this->Unit = unit; }
  void ClearPoint() { this->Point->clear(); }
  QString PointText() const { return this->Point->text(); }
  QString TouchText() const { return this->Touch->text(); }

private:
  void ShowJobs();
  void ShowTouch();

  StudyController& Study;
  LengthUnit Unit = LengthUnit::Millimeter;
  QLabel* Point;
  QLabel* Jobs;
  QToolButton* Cancel; ///< of files that are written
  QLabel* Touch;
};
} // namespace palpate
