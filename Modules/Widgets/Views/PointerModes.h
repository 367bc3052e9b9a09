#pragma once

#include <QAction>
#include <QList>
#include <QObject>

namespace palpate
{
/// What the mouse does in the views instead of touching or moving the camera: one mode at a time.
class PointerModes : public QObject
{
  Q_OBJECT

public:
  using QObject::QObject;

  /// A checkable action, which switches the others off.
  void Add(QAction* mode);
  const QList<QAction*>& All() const { return this->Modes; }
  bool IsAny() const;
  void Leave();

Q_SIGNALS:
  void Changed();

private:
  void Take(QAction* mode, bool isOn);

  QList<QAction*> Modes;
};
} // namespace palpate
