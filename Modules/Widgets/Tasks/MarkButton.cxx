#include "MarkButton.h"

#include <QShortcut>

namespace palpate
{
MarkButton::MarkButton(QWidget* parent) : QPushButton("Mark (Space)", parent)
{
  this->setObjectName("task-mark");
  this->setFocusPolicy(Qt::NoFocus);
  this->setToolTip("Marks where the tool touches, or where it is; also the device's first button");
  // A button's own key would press it for a tenth of a second first.
  auto* key = new QShortcut(Qt::Key_Space, this);
  connect(key, &QShortcut::activated, this, &QPushButton::click);
  connect(this, &QPushButton::clicked, this,
          [this]
          {
            if (this->HasTip)
            {
              Q_EMIT Marked(this->Tip);
            }
          });
}

void MarkButton::Take(const TouchState& newest, const TaskWatch& watch)
{
  if (!newest.HasSample)
  {
    return;
  }
  this->Tip = watch.TipWorld(newest);
  this->HasTip = true;
  const bool isHeld = (newest.Sample.Buttons & 1U) != 0;
  if (isHeld && !this->IsHeld && this->isEnabled())
  {
    Q_EMIT Marked(this->Tip);
  }
  this->IsHeld = isHeld;
}
} // namespace palpate
