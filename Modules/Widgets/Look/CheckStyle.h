#pragma once

#include <QProxyStyle>

namespace palpate
{
/// The platform's style with outlines of check boxes that can be seen on dark backgrounds, too: its
/// own are darker than the window.
class CheckStyle : public QProxyStyle
{
  Q_OBJECT

public:
  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
};
} // namespace palpate
