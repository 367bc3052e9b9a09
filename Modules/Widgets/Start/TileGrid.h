#pragma once

#include <QWidget>

#include <vector>

namespace palpate
{
/// Tiles in as many columns as fit, all of one size.
class TileGrid : public QWidget
{
public:
  /// `least` is a tile's smallest width, pixels.
  TileGrid(int least, int mostColumns, QWidget* parent);

  /// Takes over the tile.
  void Add(QWidget* tile);
  void Clear();
  const std::vector<QWidget*>& Tiles() const { return this->All; }

  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override { return {this->Least, 0}; }

protected:
  void resizeEvent(QResizeEvent* event) override;

private:
  int ColumnsIn(int width) const;
  int RowHeight() const;
  void Arrange();

  int Least;
  int MostColumns;
  std::vector<QWidget*> All;
};
} // namespace palpate
