#pragma once

#include "MainWindow.h"
#include "ViewerOptions.h"

#include <QObject>

namespace palpate
{
/// Does what a command line asks for once a window is there: files, then touch, then the picture.
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

  StudyController& Study;
  MainWindow& Window;
  ViewerOptions Options;
  bool HasChosen = false;
  bool HasTouched = false;
};
} // namespace palpate
