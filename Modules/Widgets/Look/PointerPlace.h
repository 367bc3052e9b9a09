#pragma once

#include <QMouseEvent>

namespace palpate
{
/// Where the pointer is in the widget, to a fraction of a pixel; Qt 5 and 6 name it differently.
inline QPointF PointerPlace(const QMouseEvent& event)
{
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
  return event.position();
#else
  return event.localPos();
#endif
}
} // namespace palpate
