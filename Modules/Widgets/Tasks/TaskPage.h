#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

namespace palpate
{
/// What a participant sees between trials, in place of the views: the instructions at reading size,
/// what comes next, and what can be done.
class TaskPage : public QWidget
{
  Q_OBJECT

public:
  explicit TaskPage(QWidget* parent);

  /// What the page has. An empty text of a button hides it.
  struct Content
  {
    QString Title;
    QString Progress; ///< "Trial 3 of 12"
    QString Text;
    QString Start; ///< the button that goes on
    bool CanPause = false;
    QString Folder; ///< text of the button that opens the folder of the results
    QString Stop;
  };
  void Show(const Content& content);
  /// A line below, and whether the participant can go on.
  void ShowState(const QString& text, bool canStart);

Q_SIGNALS:
  void StartAsked();
  void PauseAsked();
  void FolderAsked();
  void StopAsked();

private:
  QPushButton* AddButton(const char* name, void (TaskPage::*asked)());

  QLabel* Title;
  QLabel* Progress;
  QLabel* Text;
  QLabel* State;
  QWidget* Buttons;
  QPushButton* Start;
  QPushButton* Pause;
  QPushButton* Folder;
  QPushButton* Stop;
};
} // namespace palpate
