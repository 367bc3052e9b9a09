#include "CheckStyle.h"

#include <QPainter>
#include <QStyleOption>

namespace palpate
{
void CheckStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                               QPainter* painter, const QWidget* widget) const
{
  this->QProxyStyle::drawPrimitive(element, option, painter, widget);
  if (element != PE_IndicatorCheckBox && element != PE_IndicatorItemViewItemCheck)
  {
    return;
  }
  const bool isEnabled = option->state.testFlag(State_Enabled);
  painter->save();
  painter->setBrush(Qt::NoBrush);
  painter->setPen(option->palette.color(isEnabled ? QPalette::Active : QPalette::Disabled,
                                        QPalette::PlaceholderText));
  painter->drawRect(option->rect.adjusted(0, 0, -1, -1));
  painter->restore();
}
} // namespace palpate
