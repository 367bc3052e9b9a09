#pragma once

#include <QLabel>
#include <QVBoxLayout>
#include <QWidget>

namespace palpate
{
/// What an empty window offers: to open files, sample data that is on this machine, and the files
/// that were opened last.
class StartPage : public QWidget
{
  Q_OBJECT

public:
  explicit StartPage(QWidget* parent);

  /// Lists files, the last one first.
  void ShowRecent(const QStringList& files);

Q_SIGNALS:
  void OpenAsked();   ///< files of any kind
  void FolderAsked(); ///< a folder of DICOM slices
  void FilesChosen(const QStringList& files);

private:
  QLabel* AddLinks(const char* name);
  void ShowSamples();

  QVBoxLayout* Column;
  QLabel* Recent;
  QLabel* Samples;
};
} // namespace palpate
