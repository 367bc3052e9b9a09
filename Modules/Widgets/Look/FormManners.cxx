#include "FormManners.h"

#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScrollBar>
#include <QSlider>
#include <QTimer>
#include <QToolTip>

namespace palpate
{
namespace
{
// What a widget lies in that scrolls, or null.
QAbstractScrollArea* AreaAround(const QWidget* widget)
{
  for (QWidget* around = widget->parentWidget(); around != nullptr; around = around->parentWidget())
  {
    if (auto* area = qobject_cast<QAbstractScrollArea*>(around))
    {
      return area;
    }
  }
  return nullptr;
}

void ScrollAround(const QWidget* field, QEvent* wheel)
{
  if (const QAbstractScrollArea* area = AreaAround(field))
  {
    QApplication::sendEvent(area->verticalScrollBar(), wheel);
  }
  wheel->accept();
}

bool IsField(const QWidget* widget)
{
  if (qobject_cast<const QSlider*>(widget) != nullptr)
  {
    return AreaAround(widget) != nullptr; // unlike the slider of a slice
  }
  return qobject_cast<const QAbstractSpinBox*>(widget) != nullptr ||
         qobject_cast<const QComboBox*>(widget) != nullptr;
}

// The field that a widget is, or is the text of; or null.
QWidget* FieldOf(QObject* object)
{
  auto* widget = qobject_cast<QWidget*>(object);
  if (qobject_cast<QLineEdit*>(object) != nullptr)
  {
    widget = widget->parentWidget();
  }
  return widget != nullptr && IsField(widget) ? widget : nullptr;
}

// What a number box does with its text, rather than the program.
bool IsOfText(QKeyEvent* key)
{
  return key->matches(QKeySequence::Copy) || key->matches(QKeySequence::Cut) ||
         key->matches(QKeySequence::Paste) || key->matches(QKeySequence::SelectAll);
}

// Otherwise 9999 becomes 9 without a word.
void TellRange(QDoubleSpinBox* box, const QString& before)
{
  if (box->cleanText() == before)
  {
    QToolTip::showText(
        box->mapToGlobal(QPoint(0, box->height())),
        QString("Out of range: from %1 to %2")
            .arg(box->textFromValue(box->minimum()), box->textFromValue(box->maximum())),
        box);
  }
}
} // namespace

FormManners::FormManners(QObject* parent) : QObject(parent)
{
  QApplication::instance()->installEventFilter(this);
}

bool FormManners::eventFilter(QObject* object, QEvent* event)
{
  switch (event->type())
  {
  case QEvent::Polish:
    // Otherwise the wheel gives the focus, and then changes the value.
    if (QWidget* field = FieldOf(object);
        field != nullptr && field->focusPolicy() == Qt::WheelFocus)
    {
      field->setFocusPolicy(Qt::StrongFocus);
    }
    break;
  case QEvent::Wheel:
    if (const QWidget* field = FieldOf(object); field != nullptr && !field->hasFocus())
    {
      ScrollAround(field, event);
      return true;
    }
    break;
  case QEvent::KeyPress:
  {
    auto* box = qobject_cast<QDoubleSpinBox*>(object);
    const QString typed = static_cast<QKeyEvent*>(event)->text();
    if (box != nullptr && typed.size() == 1 && typed[0].isDigit())
    {
      const QString before = box->cleanText();
      QTimer::singleShot(0, box, [box, before] { TellRange(box, before); });
    }
    break;
  }
  case QEvent::ShortcutOverride:
  {
    auto* key = static_cast<QKeyEvent*>(event);
    const bool isCommand = (key->modifiers() & (Qt::ControlModifier | Qt::AltModifier)) != 0;
    if (isCommand && !IsOfText(key) && qobject_cast<QAbstractSpinBox*>(FieldOf(object)) != nullptr)
    {
      event->ignore();
      return true;
    }
    break;
  }
  default:
    break;
  }
  return QObject::eventFilter(object, event);
}
} // namespace palpate
