#include "StartCard.h"

#include <QPainter>
#include <QPainterPath>

#include <cmath>

namespace palpate
{
namespace
{
constexpr double Width = 96.0; // of the square that is drawn in
constexpr double Height = 72.0;

const QColor Ground("#1d232b");
const QColor Gland("#e0966a");
const QColor Tool("#4f9fe6");
const QColor Bone("#efe0bd");
const QColor Nerve("#f2c230");
const QColor Nodule("#c8382f");
const QColor Vein("#3b66c4");

// A surface that is lit from the top left.
QBrush Lit(const QColor& color, const QPointF& center, double radius)
{
  QRadialGradient light(center, 1.3 * radius, center - QPointF(0.45 * radius, 0.5 * radius));
  light.setColorAt(0.0, color.lighter(140));
  light.setColorAt(0.55, color);
  light.setColorAt(1.0, color.darker(220));
  return light;
}

void DrawSphere(QPainter& painter, const QColor& color, const QPointF& center, double radius)
{
  painter.setBrush(Lit(color, center, radius));
  painter.drawEllipse(center, radius, radius);
}

// Wider above than below, flat behind.
QPainterPath GlandPath(const QPointF& center, double scale)
{
  QPainterPath path;
  const auto at = [&](double x, double y) { return center + scale * QPointF(x, y); };
  path.moveTo(at(0, -20));
  path.cubicTo(at(16, -24), at(30, -14), at(28, 2));
  path.cubicTo(at(26, 16), at(12, 22), at(0, 19));
  path.cubicTo(at(-12, 22), at(-26, 16), at(-28, 2));
  path.cubicTo(at(-30, -14), at(-16, -24), at(0, -20));
  return path;
}

void DrawGland(QPainter& painter, const QPointF& center, double scale, const QColor& color)
{
  painter.setBrush(Lit(color, center, 28.0 * scale));
  painter.drawPath(GlandPath(center, scale));
}

void DrawArrow(QPainter& painter, const QPointF& from, const QPointF& to)
{
  const QPointF along = (to - from) / std::hypot(to.x() - from.x(), to.y() - from.y());
  const QPointF across(-along.y(), along.x());
  painter.setPen(QPen(Qt::white, 2.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(from, to);
  painter.drawLine(to, to - 5.0 * along + 4.0 * across);
  painter.drawLine(to, to - 5.0 * along - 4.0 * across);
  painter.setPen(Qt::NoPen);
}

void DrawProstate(QPainter& painter)
{
  DrawGland(painter, {42, 40}, 1.1, Gland);
  DrawSphere(painter, Tool, {70, 20}, 8.0);
  DrawArrow(painter, {84, 8}, {76, 15});
}

void DrawLesion(QPainter& painter)
{
  DrawGland(painter, {46, 34}, 1.1, Gland.darker(115));
  painter.setOpacity(0.35);
  painter.setBrush(Nodule);
  painter.drawEllipse(QPointF(48, 44), 15, 12);
  painter.setOpacity(1.0);
  DrawSphere(painter, Nodule, {48, 44}, 8.0);
  DrawSphere(painter, Tool, {48, 62}, 7.0);
}

void DrawMastoid(QPainter& painter)
{
  painter.setBrush(Lit(Bone, {44, 50}, 46));
  painter.drawEllipse(QPointF(44, 58), 46, 44);
  painter.setBrush(Bone.darker(230));
  painter.drawEllipse(QPointF(52, 42), 22, 17);
  painter.setBrush(QColor("#5d4a33"));
  for (const QPointF& cell : {QPointF(40, 40), QPointF(47, 50), QPointF(48, 34), QPointF(58, 52)})
  {
    painter.drawEllipse(cell, 4.0, 3.2);
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(Nerve, 3.5, Qt::SolidLine, Qt::RoundCap));
  QPainterPath nerve(QPointF(60, 29));
  nerve.cubicTo({66, 38}, {60, 46}, {66, 53});
  painter.drawPath(nerve);
  painter.setPen(QPen(QColor("#b9c2cc"), 4.0, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(QPointF(53, 38), QPointF(84, 4));
  painter.setPen(Qt::NoPen);
  DrawSphere(painter, QColor("#d5dde6"), {52, 39}, 6.5);
}

void DrawHead(QPainter& painter)
{
  painter.setBrush(Lit(QColor("#8d949c"), {48, 36}, 34));
  painter.drawEllipse(QPointF(48, 36), 28, 33);
  painter.setBrush(QColor("#5c636b"));
  painter.drawEllipse(QPointF(48, 36), 24, 29);
  const QColor colors[] = {"#e0966a", "#6bbf59", "#4f9fe6", "#f2c230"};
  const QPointF places[] = {{7, -4}, {12, 8}, {7, 17}, {14, -14}};
  const QPointF sizes[] = {{6, 8}, {4, 6}, {5, 4}, {5, 6}};
  for (int n = 0; n < 4; ++n)
  {
    for (const double side : {-1.0, 1.0})
    {
      const QPointF center(48 + side * places[n].x(), 36 + places[n].y());
      painter.setBrush(Lit(colors[n], center, sizes[n].y()));
      painter.drawEllipse(center, sizes[n].x(), sizes[n].y());
    }
  }
}

void DrawComparison(QPainter& painter)
{
  const QPainterPath first = GlandPath({43, 38}, 1.05);
  const QPainterPath second = GlandPath({54, 34}, 1.05);
  painter.setBrush(QColor(79, 159, 230, 70));
  painter.drawPath(first);
  painter.setBrush(QColor(242, 194, 48, 70));
  painter.drawPath(second);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(Tool, 2.5));
  painter.drawPath(first);
  painter.setPen(QPen(Nerve, 2.5, Qt::DashLine));
  painter.drawPath(second);
  painter.setPen(Qt::NoPen);
}

void DrawCohort(QPainter& painter)
{
  for (int n = 0; n < 6; ++n)
  {
    const QPointF center(17.0 + 21.0 * (n % 3), 22.0 + 28.0 * (n / 3));
    DrawGland(painter, center, 0.30 + 0.03 * ((5 * n) % 4), QColor("#7d8894"));
  }
  DrawGland(painter, {78, 36}, 0.5, Gland);
}
} // namespace

const std::vector<StartCard>& StartCard::All()
{
  static const std::vector<StartCard> all{
      {Kind::Prostate, "prostate", "Feel a prostate",
       "A phantom with its MR volume: press and stroke the gland. Ready in 3 s."},
      {Kind::Lesion, "lesion", "Feel a lesion",
       "A soft gland with a hard nodule under its back. Ready in 10 s."},
      {Kind::Mastoid, "mastoid", "Drill a mastoid",
       "Open the bone without touching nerve and sinus. Ready in 3 s."},
      {Kind::Head, "head", "Head with 116 structures",
       "The Colin 27 brain, eight deep structures to touch. Ready in 7 s."},
      {Kind::Compare, "compare", "Compare two masks",
       "Two segmentations of yours over each other, within seconds."},
      {Kind::Cohort, "cohort", "Cohort from a folder of masks",
       "Fits each mask, then shows mean and modes. Some seconds a mask."}};
  return all;
}

QImage DrawCard(StartCard::Kind kind, const QSize& size)
{
  QImage image(size, QImage::Format_ARGB32_Premultiplied);
  image.fill(Qt::transparent);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(size.width() / Width, size.height() / Height);
  QPainterPath frame;
  frame.addRoundedRect(0, 0, Width, Height, 6, 6);
  painter.setClipPath(frame);
  painter.fillPath(frame, Ground);
  painter.setPen(Qt::NoPen);
  switch (kind)
  {
  case StartCard::Kind::Prostate:
    DrawProstate(painter);
    break;
  case StartCard::Kind::Lesion:
    DrawLesion(painter);
    break;
  case StartCard::Kind::Mastoid:
    DrawMastoid(painter);
    break;
  case StartCard::Kind::Head:
    DrawHead(painter);
    break;
  case StartCard::Kind::Compare:
    DrawComparison(painter);
    break;
  case StartCard::Kind::Cohort:
    DrawCohort(painter);
    break;
  }
  return image;
}
} // namespace palpate
