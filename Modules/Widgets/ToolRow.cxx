#include "ToolRow.h"

#include "ForceButton.h"

#include <QHBoxLayout>
#include <QToolButton>

namespace palpate
{
ToolRow::ToolRow(StudyController& study, QWidget* window)
    : QToolBar("Tools", window), Buttons(new QToolBar(this))
{
  this->setObjectName("tools");
  this->setMovable(false);
  this->toggleViewAction()->setEnabled(false); // stopping force needs it
  this->setContextMenuPolicy(Qt::PreventContextMenu);
  auto* row = new QWidget(this);
  auto* line = new QHBoxLayout(row);
  line->setContentsMargins(0, 0, 4, 0);
  // It folds what does not fit into a menu.
  this->Buttons->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  line->addWidget(this->Buttons, 1);
  line->addWidget(new ForceButton(study, row));
  this->addWidget(row);
}

void ToolRow::Add(const QList<QAction*>& actions)
{
  if (!this->Buttons->actions().isEmpty())
  {
    this->Buttons->addSeparator();
  }
  this->Buttons->addActions(actions);
  for (QAction* action : actions)
  {
    auto* button = qobject_cast<QToolButton*>(this->Buttons->widgetForAction(action));
    button->setPopupMode(QToolButton::InstantPopup);
    button->setAccessibleName(action->text().remove('&'));
    if (action->priority() == QAction::HighPriority)
    {
      button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    }
  }
}
} // namespace palpate
