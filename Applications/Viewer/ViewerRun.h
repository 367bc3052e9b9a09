#pragma once

#include "MainWindow.h"
#include "ViewerOptions.h"

#include <QObject>
#include <QTimer>

namespace palpate
{
/// Executes a command line once the window is open: files, then touch, then the screenshot. On an
/// interruption, ends the program as closing the window does, but without a question.
class ViewerRun : public QObject
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  ViewerRun(StudyController& study, MainWindow& window, const ViewerOptions& options);

private:
  void GoOn();
  void ChooseDemo();
  void TakeScreenshot();
  void EndIfAsked();

  StudyController& Study;
  MainWindow& Window;
  ViewerOptions Options;
  bool HasChosen = false;
  bool HasTouched = false;
  QTimer Looks; // polls for an interruption
};
} // namespace palpate
