#include "FileQuestions.h"

#include "ScreenString.h"
#include "SeriesDialog.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>

namespace palpate
{
namespace
{
QString AskForMissing(QWidget* parent, const StudyMissingFile& missing)
{
  const QString path = QString::fromStdString(missing.Path.string());
  const QString name = QFileInfo(path).fileName();
  QMessageBox box(QMessageBox::Question, "A file is missing",
                  QString("The study's %1, %2, was not found. Where is it?")
                      .arg(ScreenString(missing.Role), ScreenString(missing.Path.string())),
                  QMessageBox::NoButton, parent);
  box.setTextFormat(Qt::PlainText);
  const QAbstractButton* find = box.addButton("Find it...", QMessageBox::AcceptRole);
  box.addButton("Continue without it", QMessageBox::RejectRole);
  box.exec();
  return box.clickedButton() == find
             ? QFileDialog::getOpenFileName(parent, "Find " + name, QFileInfo(path).path())
             : QString();
}

int AskForSeries(QWidget* parent, const std::vector<DicomSeriesChoice>& series)
{
  SeriesDialog dialog(series, parent);
  return dialog.exec() == QDialog::Accepted ? dialog.Chosen() : -1;
}

FileQuestions::Answer AskWhetherToSave(QWidget* parent)
{
  const auto button =
      QMessageBox::question(parent, "Palpate", "Save the changes to this study?",
                            QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  return button == QMessageBox::Save      ? FileQuestions::Answer::Save
         : button == QMessageBox::Discard ? FileQuestions::Answer::Discard
                                          : FileQuestions::Answer::Cancel;
}

bool AskWhetherToDelete(QWidget* parent, const QString& title)
{
  const auto button =
      QMessageBox::question(parent, "Palpate", title + "\n\nDelete what was kept of it?",
                            QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Cancel);
  return button == QMessageBox::Discard;
}
} // namespace

FileQuestions AskByDialogs()
{
  FileQuestions questions;
  questions.ToOpen = [](QWidget* parent, const QString& title, const QString& filter)
  { return QFileDialog::getOpenFileNames(parent, title, {}, filter); };
  questions.ToSave =
      [](QWidget* parent, const QString& title, const QString& proposal, const QString& filter)
  { return QFileDialog::getSaveFileName(parent, title, proposal, filter); };
  questions.Folder = [](QWidget* parent, const QString& title)
  { return QFileDialog::getExistingDirectory(parent, title); };
  questions.Series = AskForSeries;
  questions.Missing = AskForMissing;
  questions.WhetherToSave = AskWhetherToSave;
  questions.WhetherToDelete = AskWhetherToDelete;
  return questions;
}
} // namespace palpate
