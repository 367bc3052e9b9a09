#include "PlainLabel.h"

namespace palpate
{
QLabel* MakePlainLabel(const char* name, QWidget* parent)
{
  auto* label = new QLabel(parent);
  label->setObjectName(name);
  label->setTextFormat(Qt::PlainText);
  return label;
}
} // namespace palpate
