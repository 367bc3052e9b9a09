#pragma once

#include "StudyFile.h"

#include <QString>
#include <QStringList>

#include <functional>

class QWidget;

namespace palpate
{
/// What a window asks its user about files. Tests answer by themselves.
struct FileQuestions
{
  enum class Answer
  {
    Save,
    Discard,
    Cancel
  };

  /// Nothing where the user thinks better of it.
  std::function<QStringList(QWidget* parent, const QString& title, const QString& filter)> ToOpen;
  std::function<QString(QWidget* parent, const QString& title, const QString& proposal,
                        const QString& filter)>
      ToSave;
  std::function<QString(QWidget* parent, const QString& title)> Folder;
  /// Which of a folder's series to open, from 0; -1 where the user thinks better of it.
  std::function<int(QWidget* parent, const QStringList& series)> Series;
  /// Where a file is that a session names and that is not there.
  std::function<QString(QWidget* parent, const StudyMissingFile& missing)> Missing;
  std::function<Answer(QWidget* parent)> WhetherToSave;
};

/// Asks by the system's dialogs.
FileQuestions AskByDialogs();
} // namespace palpate
