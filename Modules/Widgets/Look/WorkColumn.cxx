#include "WorkColumn.h"

#include <QEvent>
#include <QScrollBar>
#include <QTimer>

namespace palpate
{
WorkColumn::WorkColumn(QWidget* parent) : QScrollArea(parent)
{
  this->setObjectName("column");
  this->setFrameShape(QFrame::NoFrame);
  this->setWidgetResizable(true);
  this->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* content = new QWidget(this);
  this->Column = new QVBoxLayout(content);
  this->Column->setContentsMargins(2, 2, 2, 2);
  this->Column->setSpacing(2);
  this->Column->addStretch(1);
  content->installEventFilter(this);
  this->setWidget(content);
}

Section* WorkColumn::Add(const QString& title, QWidget* content, bool isOpen)
{
  auto* section = new Section(title, content, isOpen, this->widget());
  this->Column->insertWidget(static_cast<int>(this->All.size()), section);
  this->All.push_back(section);
  return section;
}

void WorkColumn::GoTo(Section* section)
{
  section->Open(true);
  // Once it has its place.
  QTimer::singleShot(0, section,
                     [this, section] { this->verticalScrollBar()->setValue(section->y()); });
}

bool WorkColumn::eventFilter(QObject* object, QEvent* event)
{
  if (event->type() == QEvent::LayoutRequest)
  {
    this->setMinimumWidth(this->widget()->minimumSizeHint().width() +
                          this->verticalScrollBar()->sizeHint().width());
  }
  return QScrollArea::eventFilter(object, event);
}
} // namespace palpate
