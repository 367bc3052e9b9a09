#pragma once

#include "FileQuestions.h"
#include "MatchingLink.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include <utility>
#include <vector>

namespace palpate
{
/// Which organ is held and brought onto which, how well it fits, and what makes a transform of it.
class MatchingPanel : public QWidget
{
  Q_OBJECT

public:
  /// Keeps the addresses.
  MatchingPanel(StudyController& study, const ViewContents& contents, MatchingLink& link,
                const FileQuestions& questions, QWidget* parent = nullptr);

private:
  QPushButton* MakeButton(const QString& text, const char* name, const QString& tip);
  QComboBox* MakeChoice(const char* name, const QString& tip);
  void MakeRows();
  void Show();
  void ShowChoices();
  void Offer(QComboBox* box, const std::vector<std::pair<int, QString>>& offered, int chosen);
  void TakeChoice();
  void Propose();
  QString Sentence() const;
  QString SentenceOfMatch() const;
  void Keep();

  StudyController& Study;
  const ViewContents& Contents;
  MatchingLink& Link;
  const FileQuestions& Questions;
  QLabel* Line;
  QComboBox* Moving;
  QComboBox* Fixed;
  QComboBox* With;
  QCheckBox* Size;
  QPushButton* Mode;
  QPushButton* Tool;
  QPushButton* Back;
  QPushButton* Keeping;
};
} // namespace palpate
