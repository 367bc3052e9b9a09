#include "ViewBanner.h"

#include <QEvent>

namespace palpate
{
ViewBanner::ViewBanner(QWidget* view) : QLabel(view)
{
  this->setObjectName("banner");
  this->setTextFormat(Qt::PlainText);
  this->setAlignment(Qt::AlignCenter);
  this->setWordWrap(true);
  this->setMargin(3);
  this->setAutoFillBackground(true);
  this->setAttribute(Qt::WA_TransparentForMouseEvents);
  QFont bold = this->font();
  bold.setBold(true);
  this->setFont(bold);
  view->installEventFilter(this);
  this->hide();
}

void ViewBanner::Show(const TouchNotice& notice)
{
  if (notice.Is != this->Kind)
  {
    this->Kind = notice.Is;
    const bool isAlarm = notice.Is == TouchNotice::Kind::Alarm;
    QPalette colors = this->palette();
    colors.setColor(QPalette::Window, QColor(isAlarm ? "#b00020" : "#f0e442"));
    colors.setColor(QPalette::WindowText, isAlarm ? Qt::white : Qt::black);
    this->setPalette(colors);
    this->setVisible(notice.Is != TouchNotice::Kind::None);
  }
  if (this->Whole != notice.Text)
  {
    this->Whole = notice.Text;
    this->setAccessibleName(notice.Text);
    this->Place();
  }
}

void ViewBanner::Place()
{
  constexpr int LargestShare = 5; // the notice's height in that of the view
  const int width = this->parentWidget()->width();
  this->setText(this->Whole);
  if (LargestShare * this->heightForWidth(width) > this->parentWidget()->height())
  {
    this->setText(this->Whole.section(". ", 0, 0));
  }
  this->setGeometry(0, 0, width, this->heightForWidth(width));
  this->raise();
}

bool ViewBanner::eventFilter(QObject* object, QEvent* event)
{
  if (event->type() == QEvent::Resize)
  {
    this->Place();
  }
  return QLabel::eventFilter(object, event);
}
} // namespace palpate
