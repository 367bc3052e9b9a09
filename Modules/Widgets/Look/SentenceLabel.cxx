#include "SentenceLabel.h"

#include "ScreenString.h"

#include <algorithm>

namespace palpate
{
SentenceLabel::SentenceLabel(const char* name, int longest, QWidget* parent)
    : QLabel(parent), Longest(longest)
{
  this->setObjectName(name);
  this->setTextFormat(Qt::PlainText);
  this->setWordWrap(true);
  this->setAlignment(Qt::AlignTop | Qt::AlignLeft);
}

void SentenceLabel::Say(const QString& sentence)
{
  if (sentence != this->text())
  {
    this->setText(sentence);
    this->setToolTip(PlainToolTip(sentence));
  }
}

void SentenceLabel::resizeEvent(QResizeEvent* event)
{
  constexpr int MostLines = 3;
  const int letters = std::max(1, this->width() / this->fontMetrics().averageCharWidth());
  const int lines = std::clamp((this->Longest + letters - 1) / letters, 1, MostLines);
  this->setFixedHeight(lines * this->fontMetrics().lineSpacing() + 2);
  QLabel::resizeEvent(event);
}
} // namespace palpate
