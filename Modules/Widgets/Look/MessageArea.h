#pragma once

#include <QFrame>
#include <QPlainTextEdit>

namespace palpate
{
/// Messages for the user, below the views: they stay until closed or removed, do not block, and can
/// be copied. Hidden while empty.
class MessageArea : public QFrame
{
  Q_OBJECT

public:
  explicit MessageArea(QWidget* parent = nullptr);

  void Add(const QString& message);
  /// The newest message of this text, if it is still there.
  void Remove(const QString& message);
  /// All messages, one per line.
  QString Text() const { return this->Messages->toPlainText(); }
  void Clear();

private:
  QPlainTextEdit* Messages;
};
} // namespace palpate
