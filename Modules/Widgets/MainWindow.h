#pragma once

#include "CorrectionPanel.h"
#include "DrawingPanel.h"
#include "FileMenu.h"
#include "FileQuestions.h"
#include "KeyBindings.h"
#include "LandmarksPanel.h"
#include "MatchingPanel.h"
#include "MessageArea.h"
#include "PointerModes.h"
#include "Preferences.h"
#include "QuietWindow.h"
#include "RecoveryLink.h"
#include "StartPage.h"
#include "StatusLine.h"
#include "StudyController.h"
#include "TaskLink.h"
#include "TouchLink.h"
#include "TouchMenu.h"
#include "ViewContents.h"
#include "ViewGrid.h"
#include "ViewMenu.h"
#include "WorkColumn.h"

#include <QDockWidget>
#include <QMainWindow>

#include <array>
#include <memory>

namespace palpate
{
/// The window: tools above, the parts of the work in a column on the left, views in the centre,
/// plots and landmarks below once they are used. It only shows and asks; the study does the work.
class MainWindow : public QMainWindow
{
  Q_OBJECT

public:
  /// Keeps the address of the study, which outlives it.
  explicit MainWindow(StudyController& study, FileQuestions questions = AskByDialogs());
  ~MainWindow() override;

  ViewGrid* Views() const { return this->Grid; }
  MessageArea* Messages() const { return this->Area; }
  const ViewContents& Contents() const { return this->Shown; }
  /// Text about the point under the pointer.
  QString PointText() const { return this->Status->PointText(); }
  /// Keeps what is not saved in a folder of its own below this one, and offers what is left there.
  RecoveryLink* KeepRecovery(const std::filesystem::path& root);
  /// Saves the window as a PNG file. Returns false, with a message, if it cannot be written.
  bool SaveScreenshot(const QString& file);

protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

private:
  void EndEditing();
  void MakeCentre();
  void MakeStart();
  void MakeMenus();
  void MakePanels();
  void ConnectViews();
  void MakeColumn();
  void AddSection(const QString& title, QWidget* content, bool isOpen);
  QDockWidget* AddPanel(const QString& title, QWidget* panel);
  QDockWidget* MakeCheck();
  QDockWidget* MakeDrawing();
  QDockWidget* MakeCorrection();
  QDockWidget* MakeMatching();
  QDockWidget* AddMode(QAction* mode, QDockWidget* dock);
  void MakeTasks(TouchLink& touch);
  void FollowModes();
  void ShowState();
  void ShowTitle();
  void ShowChange();
  void TakeView();
  void TakePointer(const Vector3& pointWorld);
  void TakeClick(const Vector3& pointWorld);
  void TakeFile(const QString& file);
  void ShowCentre();
  void LookAtPlace(const Vector3& place);
  void AskForPicture();
  void AskForPreferences();
  void Follow(const Preferences& preferences);

  StudyController& Study;
  FileQuestions Questions;
  ViewContents Shown;
  ViewGrid* Grid = nullptr;
  StartPage* Start = nullptr;
  MessageArea* Area = nullptr;
  StatusLine* Status = nullptr;
  WorkColumn* Column = nullptr;
  FileMenu* Files = nullptr;
  ViewMenu* Viewing = nullptr;
  TouchMenu* Touching = nullptr;
  LandmarksPanel* Marks = nullptr;
  DrawingLink* Drawing = nullptr;
  DrawingPanel* Drawn = nullptr;
  MatchingLink* Matching = nullptr;
  CorrectionLink* Correcting = nullptr;
  BrushLink* Brushing = nullptr;
  TaskLink* Tasks = nullptr;
  QuietWindow Quiet{*this}; ///< while a task is open
  PointerModes Modes;
  QMenu* Panels = nullptr;
  QAction* Undo = nullptr;
  QAction* Redo = nullptr;
  Preferences Habits;
  std::unique_ptr<KeyBindings> Keys;
  bool IsShowing =
      false; ///< while showing the study's view, which is then not taken for the user's
};
} // namespace palpate
