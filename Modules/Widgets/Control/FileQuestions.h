#pragma once

#include "DicomFolders.h"
#include "StudyFile.h"

#include <QString>
#include <QStringList>

#include <functional>
#include <vector>

class QWidget;

namespace palpate
{
/// Questions of a window to its user about files. Tests provide the answers.
struct FileQuestions
{
  enum class Answer
  {
    Save,
    Discard,
    Cancel
  };

  /// Empty if the user cancels.
  std::function<QStringList(QWidget* parent, const QString& title, const QString& filter)> ToOpen;
  std::function<QString(QWidget* parent, const QString& title, const QString& proposal,
                        const QString& filter)>
      ToSave;
  std::function<QString(QWidget* parent, const QString& title)> Folder;
  /// Which of a folder's series to open, from 0; -1 if the user cancels.
  std::function<int(QWidget* parent, const std::vector<DicomSeriesChoice>& series)> Series;
  /// New path of a missing file of a session.
  std::function<QString(QWidget* parent, const StudyMissingFile& missing)> Missing;
  std::function<Answer(QWidget* parent)> WhetherToSave;
  /// Whether to delete what was kept of a study of this title.
  std::function<bool(QWidget* parent, const QString& title)> WhetherToDelete;
};

/// Asks with the system's dialogs.
FileQuestions AskByDialogs();
} // namespace palpate
