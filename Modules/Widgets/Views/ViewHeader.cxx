#include "ViewHeader.h"

#include <QHBoxLayout>
#include <QSignalBlocker>

namespace palpate
{
ViewHeader::ViewHeader(const QString& name, const QColor& color, QWidget* parent)
    : QWidget(parent), Number(new QLabel(this)), Slider(new QSlider(Qt::Horizontal, this))
{
  this->setContextMenuPolicy(Qt::ActionsContextMenu);
  auto* title = new QLabel(name, this);
  title->setStyleSheet(QString("background: %1; color: black; font-weight: bold; padding: 1px 6px;")
                           .arg(color.name()));
  auto* maximize = new QToolButton(this);
  maximize->setText("\u25A1"); // an icon would not follow light and dark
  maximize->setAutoRaise(true);
  maximize->setToolTip("Show this view alone, or all again (double click)");
  this->Slider->setObjectName("slice");
  this->Slider->setVisible(false);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  row->addWidget(title);
  row->addWidget(this->Slider, 1);
  row->addWidget(this->Number);
  row->addStretch(0);
  row->addWidget(maximize);
  connect(this->Slider, &QSlider::valueChanged, this, &ViewHeader::SliceChosen);
  connect(maximize, &QToolButton::clicked, this, &ViewHeader::MaximizeAsked);
}

void ViewHeader::ShowSlice(int number, int count)
{
  const QSignalBlocker quiet(this->Slider);
  this->Slider->setVisible(count > 0);
  this->Slider->setRange(1, count);
  this->Slider->setValue(number);
  const QString text = count > 0 ? QString("%1 / %2").arg(number).arg(count) : QString();
  if (this->Number->text() != text)
  {
    this->Number->setText(text);
  }
}
} // namespace palpate
