#pragma once

#include "FileQuestions.h"
#include "StudyController.h"
#include "TaskSettings.h"
#include "ViewContents.h"

#include <QMenu>

namespace palpate
{
class CohortWindow;

/// Opening, saving and recent files.
class FileMenu : public QMenu
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  FileMenu(StudyController& study, const FileQuestions& questions, const ViewContents& contents,
           QWidget* window);

  /// True if the study may be left: saved, discarded, or unchanged.
  bool MayLeave();
  /// Those for the toolbar.
  const QList<QAction*>& Tools() const { return this->ForTools; }
  /// Those that add structures.
  const QList<QAction*>& Adding() const { return this->ForAdding; }
  /// Asks for files of any kind, and opens them.
  void OpenFiles();
  /// Asks for a folder of DICOM slices, and opens it.
  void OpenFolder();
  /// Opens the dialog that adds a structure from image values.
  void AddFromValues() { this->AddFromValuesOf(0); }
  /// The same, from the values of a further volume; 0: the first one.
  void AddFromValuesOf(int volumeId);
  void OpenRecent(const QString& file);
  /// Shows the window of a cohort.
  CohortWindow* OpenCohort();
  /// Asks for each missing file of the study.
  void AskForMissing();

Q_SIGNALS:
  void PictureAsked();
  void TaskAsked();                            ///< of a file
  void ReadyTaskAsked(palpate::TaskKind kind); ///< to be made

private:
  void AddOpening();
  void AddTasks();
  void AddSaving();
  void Open(const QString& title, void (StudyController::*take)(const std::filesystem::path&));
  void OpenAny(const QString& title, const QString& filter);
#ifdef PALPATE_HAS_NETWORK
  void OpenLink();
#endif
  bool Save();
  bool SaveAs();
  void OpenSession(const QString& file);
  void ListRecent();

  StudyController& Study;
  const FileQuestions& Questions;
  const ViewContents& Contents;
  QWidget* Window;
  QMenu* Recent;
  QList<QAction*> ForTools;
  QList<QAction*> ForAdding;
};
} // namespace palpate
