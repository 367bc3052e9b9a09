#pragma once

#include "FileQuestions.h"
#include "StudyController.h"
#include "TouchPanel.h"

#include <QMenu>

namespace palpate
{
/// Touching, recording and replaying.
class TouchMenu : public QMenu
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  TouchMenu(StudyController& study, const FileQuestions& questions, QWidget* window);

  /// Asks for a file and begins recording, or ends the current recording.
  void ToggleRecording();
  /// Those for the toolbar.
  QList<QAction*> Tools() const { return {this->Touch, this->Record}; }
  /// Also used by a panel's buttons.
  QAction* AlarmSound() const { return this->Sound; }
  QAction* Hearing() const { return this->Hear; }
  QAction* PushAlongSight() const { return this->AlongSight; }
  QAction* MoveWorkspace() const { return this->Move; }
  void ToggleTouch();
  /// Opens the first use of a device.
  void TryDevice();
  /// Does what the panel's buttons ask for.
  void Serve(TouchPanel& panel);
  QAction* FitWorkspace() const { return this->Fit; }

Q_SIGNALS:
  /// There is nothing to touch yet but the values of an image.
  void ValuesAsked();
  void WorkspaceShown(bool isShown);
  void WorkspaceMoved(bool isMoved); ///< whether the mouse moves it

private:
  void AddWorkspace();
  void AddPush();
  void AddHearing();
  void AddRecording();
  void OpenRecording();
  void Export();
  void ShowTouch();
  void ShowRecording();

  StudyController& Study;
  const FileQuestions& Questions;
  QWidget* Window;
  QAction* Touch;
  QAction* StopForce;
  QAction* AllowForce;
  QAction* Sound;
  QAction* Hear = nullptr;
  QAction* AlongSight = nullptr;
  QAction* Move;
  QAction* Fit;
  QAction* Record;
  QAction* Play;
  QAction* Close;
  QAction* Table;
};
} // namespace palpate
