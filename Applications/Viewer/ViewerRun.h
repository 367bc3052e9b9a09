#pragma once

#include "MainWindow.h"
#include "ViewerOptions.h"

#include <QObject>
#include <QTimer>

namespace palpate
{
/// Does what a command line asks for once a window is there: files, then touch, then the picture.
/// Ends the program as closing the window does, but without a question, where it is interrupted.
class ViewerRun : public QObject
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  ViewerRun(StudyController& study, MainWindow& window, const ViewerOptions& options);

private:
  void GoOn();
  void ChooseDemo();
  void TakePicture();
  void EndIfAsked();

  StudyController& Study;
  MainWindow& Window;
  ViewerOptions Options;
  bool HasChosen = false;
  bool HasTouched = false;
  QTimer Looks; // whether somebody interrupts
};
} // namespace palpate
