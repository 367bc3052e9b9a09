#pragma once

#include <QFrame>
#include <QPlainTextEdit>

namespace palpate
{
/// Sentences for the user, below the views: they stay until they are closed, stop nothing, and can
/// be copied. Hidden while there is none.
class MessageArea : public QFrame
{
  Q_OBJECT

public:
  explicit MessageArea(QWidget* parent = nullptr);

  void Add(const QString& sentence);
  /// All sentences, a line each.
  QString Text() const { return this->Sentences->toPlainText(); }
  void Clear();

private:
  QPlainTextEdit* Sentences;
};
} // namespace palpate
