#include "QuietWindow.h"

#include <QDockWidget>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolBar>

namespace palpate
{
void QuietWindow::Set(bool isQuiet)
{
  if (isQuiet == this->IsOn)
  {
    return;
  }
  this->IsOn = isQuiet;
  this->Window.setAcceptDrops(!isQuiet);
  this->Window.menuBar()->setEnabled(!isQuiet);
  if (!isQuiet)
  {
    for (const QPointer<QWidget>& widget : this->Hidden)
    {
      if (widget != nullptr)
      {
        widget->show();
      }
    }
    this->Hidden.clear();
    return;
  }
  QList<QWidget*> widgets{this->Window.statusBar()};
  for (auto* dock : this->Window.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly))
  {
    widgets += dock;
  }
  for (auto* tools : this->Window.findChildren<QToolBar*>(QString(), Qt::FindDirectChildrenOnly))
  {
    widgets += tools;
  }
  for (QWidget* widget : widgets)
  {
    if (!widget->isHidden())
    {
      this->Hidden += QPointer<QWidget>(widget);
      widget->hide();
    }
  }
}
} // namespace palpate
