#include "Section.h"

#include <QSettings>
#include <QVBoxLayout>

namespace palpate
{
Section::Section(const QString& title, QWidget* content, bool isOpen, QWidget* parent)
    : QWidget(parent), Header(new QToolButton(this))
{
  const QString key = "sections/" + title;
  this->setObjectName("section-" + title.toLower());
  this->Header->setObjectName("fold-" + title.toLower());
  this->Header->setText(title);
  this->Header->setCheckable(true);
  this->Header->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  this->Header->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  QFont bold = this->Header->font();
  bold.setBold(true);
  this->Header->setFont(bold);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(this->Header);
  column->addWidget(content);
  connect(this->Header, &QToolButton::toggled, this,
          [this, content, key](bool isShown)
          {
            content->setVisible(isShown);
            this->Header->setArrowType(isShown ? Qt::DownArrow : Qt::RightArrow);
            QSettings().setValue(key, isShown);
            Q_EMIT Opened(isShown);
          });
  const bool starts = QSettings().value(key, isOpen).toBool();
  this->Header->setArrowType(starts ? Qt::DownArrow : Qt::RightArrow);
  content->setVisible(starts);
  this->Header->setChecked(starts);
}
} // namespace palpate
