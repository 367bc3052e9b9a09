#include "StartTile.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>

#include <utility>

namespace palpate
{
namespace
{
constexpr int TileMargin = 8; // pixels, round and beside the picture

QFont TitleFont(QFont font)
{
  font.setBold(true);
  return font;
}
} // namespace

StartTile::StartTile(const QString& title, const QString& text, int lines, const QSize& picture,
                     Drawing draw, QWidget* parent)
    : QAbstractButton(parent), Usual(text), Lines(lines), PictureSize(picture),
      Draw(std::move(draw))
{
  this->setText(title);
  this->setFocusPolicy(Qt::StrongFocus);
  this->setAttribute(Qt::WA_Hover); // painted again when the pointer comes and goes
  this->setCursor(Qt::PointingHandCursor);
  this->ShowText({});
}

void StartTile::ShowText(const QString& text)
{
  this->Shown = text.isEmpty() ? this->Usual : text;
  this->setAccessibleName(this->text());
  this->setAccessibleDescription(this->Shown);
  this->update();
}

QSize StartTile::sizeHint() const
{
  const int lines = this->Lines * this->fontMetrics().lineSpacing() + 6;
  return {this->PictureSize.width() + 200,
          std::max(this->PictureSize.height(), lines) + 2 * TileMargin};
}

void StartTile::PaintFrame(QPainter& painter) const
{
  const QPalette& colors = this->palette();
  const bool isReached = this->isEnabled() && (this->underMouse() || this->hasFocus());
  const double width = isReached ? 2.0 : 1.0;
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(colors.color(this->isDown() ? QPalette::Button : QPalette::Base));
  painter.setPen(QPen(colors.color(isReached ? QPalette::Highlight : QPalette::Mid), width));
  const double inset = 0.5 * width;
  painter.drawRoundedRect(QRectF(this->rect()).adjusted(inset, inset, -inset, -inset), 8, 8);
}

void StartTile::paintEvent(QPaintEvent* /*event*/)
{
  QPainter painter(this);
  this->PaintFrame(painter);
  const QSize pixels = this->PictureSize * this->devicePixelRatioF();
  if (this->Drawn.size() != pixels)
  {
    this->Drawn = this->Draw(pixels);
  }
  const QRect picture({TileMargin, (this->height() - this->PictureSize.height()) / 2},
                      this->PictureSize);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.setOpacity(this->isEnabled() ? 1.0 : 0.4);
  painter.drawImage(picture, this->Drawn);
  painter.setOpacity(1.0);
  const QRect words(picture.right() + 1 + TileMargin + 2, TileMargin,
                    this->width() - picture.right() - 2 * TileMargin - 3,
                    this->height() - 2 * TileMargin);
  this->PaintText(painter, words);
}

void StartTile::PaintText(QPainter& painter, const QRect& words) const
{
  constexpr int Wrapped = Qt::AlignLeft | Qt::TextWordWrap;
  const auto fit = [this, &painter, &words](const QString& text)
  {
    return this->Lines > 2 ? text
                           : painter.fontMetrics().elidedText(text, Qt::ElideMiddle, words.width());
  };
  const auto group = this->isEnabled() ? QPalette::Active : QPalette::Disabled;
  painter.setPen(this->palette().color(group, QPalette::Text));
  painter.setFont(TitleFont(this->font()));
  QRect title;
  painter.drawText(words, Wrapped, fit(this->text()), &title);
  painter.setFont(this->font());
  painter.setPen(this->palette().color(QPalette::Active, QPalette::Text));
  painter.setOpacity(0.85);
  painter.drawText(words.adjusted(0, title.height() + 1, 0, 0), Wrapped, fit(this->Shown));
}

void StartTile::keyPressEvent(QKeyEvent* event)
{
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
  {
    this->click();
    return;
  }
  QAbstractButton::keyPressEvent(event);
}
} // namespace palpate
