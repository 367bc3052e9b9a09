#include "ToolIcon.h"

#include <QApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>

namespace palpate
{
namespace
{
constexpr double Side = 24.0; // of the square that the signs are drawn in

QPainterPath OpenPath()
{
  QPainterPath path(QPointF(3, 19));
  for (const QPointF& corner : {QPointF(3, 5), QPointF(9, 5), QPointF(11, 8), QPointF(19, 8),
                                QPointF(19, 11), QPointF(7, 11), QPointF(3, 19)})
  {
    path.lineTo(corner);
  }
  for (const QPointF& corner : {QPointF(18, 19), QPointF(22, 11), QPointF(19, 11)})
  {
    path.lineTo(corner);
  }
  return path;
}

QPainterPath SavePath()
{
  QPainterPath path;
  path.addRect(4, 4, 16, 16);
  path.addRect(8, 4, 8, 5);
  path.addRect(7, 13, 10, 7);
  return path;
}

QPainterPath LayoutPath()
{
  QPainterPath path;
  path.addRect(3, 4, 18, 16);
  path.moveTo(12, 4);
  path.lineTo(12, 20);
  path.moveTo(3, 12);
  path.lineTo(21, 12);
  return path;
}

QPainterPath FitPath()
{
  QPainterPath path;
  for (const double x : {4.0, 20.0})
  {
    for (const double y : {4.0, 20.0})
    {
      const double inX = x < 12.0 ? 5.0 : -5.0;
      const double inY = y < 12.0 ? 5.0 : -5.0;
      path.moveTo(x + inX, y);
      path.lineTo(x, y);
      path.lineTo(x, y + inY);
    }
  }
  path.addRect(9, 9, 6, 6);
  return path;
}

QPainterPath LandmarkPath()
{
  QPainterPath path(QPointF(6, 21));
  path.lineTo(6, 4);
  path.lineTo(19, 8);
  path.lineTo(6, 12);
  return path;
}

QPainterPath ScreenshotPath()
{
  QPainterPath path;
  path.addRoundedRect(3, 7, 18, 13, 2, 2);
  path.addEllipse(QPointF(12, 13.5), 4, 4);
  path.moveTo(8, 7);
  path.lineTo(10, 4);
  path.lineTo(14, 4);
  path.lineTo(16, 7);
  return path;
}

// A ball on a surface.
QPainterPath TouchPath()
{
  QPainterPath path(QPointF(2, 17));
  path.cubicTo(QPointF(7, 17), QPointF(8, 20), QPointF(12, 20));
  path.cubicTo(QPointF(16, 20), QPointF(17, 17), QPointF(22, 17));
  path.addEllipse(QPointF(12, 12), 6, 6);
  path.moveTo(12, 1);
  path.lineTo(12, 6);
  return path;
}

QPainterPath EyePath()
{
  QPainterPath path(QPointF(2, 12));
  path.quadTo(12, 2, 22, 12);
  path.quadTo(12, 22, 2, 12);
  path.addEllipse(QPointF(12, 12), 3, 3);
  return path;
}

// A ball on the outline of an organ.
QPainterPath DrawPath()
{
  QPainterPath path(QPointF(19, 13));
  path.cubicTo(QPointF(21, 19), QPointF(15, 22), QPointF(10, 21));
  path.cubicTo(QPointF(4, 20), QPointF(2, 15), QPointF(4, 10));
  path.cubicTo(QPointF(5, 7), QPointF(8, 5), QPointF(12, 5));
  path.addEllipse(QPointF(18, 7), 4, 4);
  return path;
}

// A surface that an arrow pulls.
QPainterPath PullPath()
{
  QPainterPath path(QPointF(2, 19));
  path.cubicTo(QPointF(9, 19), QPointF(8, 12), QPointF(12, 12));
  path.cubicTo(QPointF(16, 12), QPointF(15, 19), QPointF(22, 19));
  path.moveTo(12, 9);
  path.lineTo(12, 2);
  path.moveTo(9, 5);
  path.lineTo(12, 2);
  path.lineTo(15, 5);
  return path;
}

// Two bodies, one nearly on the other.
QPainterPath MatchPath()
{
  QPainterPath path;
  path.addEllipse(QPointF(9, 14), 6.5, 6.5);
  path.addEllipse(QPointF(15, 10), 6.5, 6.5);
  return path;
}

void Draw(ToolSign sign, QPainter& painter)
{
  switch (sign)
  {
  case ToolSign::Open:
    return painter.drawPath(OpenPath());
  case ToolSign::Save:
    return painter.drawPath(SavePath());
  case ToolSign::Layout:
    return painter.drawPath(LayoutPath());
  case ToolSign::WindowLevel:
    painter.drawEllipse(QPointF(12, 12), 9, 9);
    painter.setBrush(painter.pen().color());
    return painter.drawChord(QRectF(3, 3, 18, 18), 90 * 16, 180 * 16);
  case ToolSign::Fit:
    return painter.drawPath(FitPath());
  case ToolSign::Landmark:
    return painter.drawPath(LandmarkPath());
  case ToolSign::Draw:
    return painter.drawPath(DrawPath());
  case ToolSign::Pull:
    return painter.drawPath(PullPath());
  case ToolSign::Match:
    return painter.drawPath(MatchPath());
  case ToolSign::Screenshot:
    return painter.drawPath(ScreenshotPath());
  case ToolSign::Touch:
    return painter.drawPath(TouchPath());
  case ToolSign::Eye:
    return painter.drawPath(EyePath());
  case ToolSign::Record:
  case ToolSign::Recording:
    painter.setBrush(painter.pen().color());
    return painter.drawEllipse(QPointF(12, 12), 6, 6);
  }
}

class Engine : public QIconEngine
{
public:
  explicit Engine(ToolSign sign) : Sign(sign) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode,
             QIcon::State /*state*/) override
  {
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    const QColor color = this->Sign == ToolSign::Recording
                             ? QColor(0xd6, 0x27, 0x28)
                             : QApplication::palette().color(group, QPalette::ButtonText);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->translate(rect.topLeft());
    painter->scale(rect.width() / Side, rect.height() / Side);
    painter->setPen(QPen(color, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    Draw(this->Sign, *painter);
    painter->restore();
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
  {
    QPixmap image(size);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    this->paint(&painter, QRect(QPoint(), size), mode, state);
    return image;
  }
  QIconEngine* clone() const override { return new Engine(this->Sign); }

private:
  ToolSign Sign;
};
} // namespace

QIcon ToolIcon(ToolSign sign)
{
  return QIcon(new Engine(sign));
}
} // namespace palpate
