#include "ActivityRow.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QShortcut>

namespace palpate
{
ActivityRow::ActivityRow(QWidget& activity, const QString& text) : Activity(activity)
{
  auto* label = new QLabel(text, &activity);
  label->setWordWrap(true);
  auto* row = new QHBoxLayout(&activity);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(label, 1);
}

QPushButton* ActivityRow::AddButton(const QString& text, const char* name, int key)
{
  auto* button = new QPushButton(text, &this->Activity);
  button->setObjectName(name);
  button->setFocusPolicy(Qt::NoFocus);
  this->Activity.layout()->addWidget(button);
  if (key != 0)
  {
    // A button's own key would press it for a tenth of a second first.
    auto* shortcut = new QShortcut(key, button);
    QObject::connect(shortcut, &QShortcut::activated, button, &QPushButton::click);
  }
  return button;
}
} // namespace palpate
