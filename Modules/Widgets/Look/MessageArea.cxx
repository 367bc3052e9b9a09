#include "MessageArea.h"

#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace palpate
{
namespace
{
constexpr int MostMessages = 200;
constexpr int Lines = 3;
} // namespace

MessageArea::MessageArea(QWidget* parent) : QFrame(parent), Messages(new QPlainTextEdit(this))
{
  this->setObjectName("messages");
  this->setFrameShape(QFrame::StyledPanel);
  this->Messages->setReadOnly(true);
  this->Messages->setMaximumBlockCount(MostMessages);
  this->Messages->setFixedHeight(Lines * this->fontMetrics().lineSpacing() + 12);
  auto* copy = new QPushButton("Copy", this);
  copy->setObjectName("copy");
  auto* close = new QPushButton("Close", this);
  close->setObjectName("close");
  auto* buttons = new QVBoxLayout;
  buttons->addWidget(copy);
  buttons->addWidget(close);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(4, 2, 4, 2);
  row->addWidget(this->Messages, 1);
  row->addLayout(buttons);
  connect(copy, &QPushButton::clicked, this,
          [this] { QApplication::clipboard()->setText(this->Text()); });
  connect(close, &QPushButton::clicked, this, &MessageArea::Clear);
  this->hide();
}

void MessageArea::Add(const QString& message)
{
  this->Messages->appendPlainText(message);
  this->show();
}

void MessageArea::Remove(const QString& message)
{
  QStringList messages = this->Text().split('\n');
  const int last = messages.lastIndexOf(message);
  if (last < 0)
  {
    return;
  }
  messages.removeAt(last);
  this->Messages->setPlainText(messages.join('\n'));
  this->setVisible(!messages.isEmpty());
}

void MessageArea::Clear()
{
  this->Messages->clear();
  this->hide();
}
} // namespace palpate
