#pragma once

#include <QToolButton>
#include <QWidget>

namespace palpate
{
/// A part of a column that folds up under its title. It stays as the user left it, also in the next
/// run of the program.
class Section : public QWidget
{
  Q_OBJECT

public:
  /// Takes the content over. `isOpen`: at the first time.
  Section(const QString& title, QWidget* content, bool isOpen, QWidget* parent);

  QString Title() const { return this->Header->text(); }
  bool IsOpen() const { return this->Header->isChecked(); }
  void Open(bool isOpen) { this->Header->setChecked(isOpen); }

Q_SIGNALS:
  void Opened(bool isOpen);

private:
  QToolButton* Header;
};
} // namespace palpate
