#pragma once

#include <QAbstractButton>
#include <QImage>

#include <functional>

class QPainter;

namespace palpate
{
/// A button with a picture at its left, a title, and a text below it; also pressed by Return.
class StartTile : public QAbstractButton
{
  Q_OBJECT

public:
  /// Draws the picture in a size in device pixels.
  using Drawing = std::function<QImage(const QSize& size)>;

  /// Room for so many lines of title and text; of two, each is cut to one line. `picture` is its
  /// size in Qt's pixels.
  StartTile(const QString& title, const QString& text, int lines, const QSize& picture,
            Drawing draw, QWidget* parent);

  /// A plain text in place of the first one, which an empty one brings back.
  void ShowText(const QString& text);
  const QString& ShownText() const { return this->Shown; }
  QSize sizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  void PaintFrame(QPainter& painter) const;
  void PaintText(QPainter& painter, const QRect& words) const;

  QString Usual;
  QString Shown;
  int Lines;
  QSize PictureSize;
  Drawing Draw;
  QImage Drawn;
};
} // namespace palpate
