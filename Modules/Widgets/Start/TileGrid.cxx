#include "TileGrid.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr int TileGap = 8; // pixels
} // namespace

TileGrid::TileGrid(int least, int mostColumns, QWidget* parent)
    : QWidget(parent), Least(least), MostColumns(mostColumns)
{
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
  policy.setHeightForWidth(true);
  this->setSizePolicy(policy);
}

void TileGrid::Add(QWidget* tile)
{
  tile->setParent(this);
  tile->show();
  this->All.push_back(tile);
  this->Arrange();
  this->updateGeometry();
}

void TileGrid::Clear()
{
  for (QWidget* tile : this->All)
  {
    tile->hide();
    tile->deleteLater(); // it may be what was clicked
  }
  this->All.clear();
  this->updateGeometry();
}

int TileGrid::ColumnsIn(int width) const
{
  return std::clamp((width + TileGap) / (this->Least + TileGap), 1, this->MostColumns);
}

int TileGrid::RowHeight() const
{
  int height = 0;
  for (const QWidget* tile : this->All)
  {
    height = std::max(height, tile->sizeHint().height());
  }
  return height;
}

int TileGrid::heightForWidth(int width) const
{
  const int columns = this->ColumnsIn(width);
  const int rows = (static_cast<int>(this->All.size()) + columns - 1) / columns;
  return std::max(0, rows * (this->RowHeight() + TileGap) - TileGap);
}

QSize TileGrid::sizeHint() const
{
  const int width = this->MostColumns * (this->Least + TileGap) - TileGap;
  return {width, this->heightForWidth(width)};
}

void TileGrid::resizeEvent(QResizeEvent* /*event*/)
{
  this->Arrange();
}

void TileGrid::Arrange()
{
  const int columns = this->ColumnsIn(this->width());
  const int width = (this->width() + TileGap) / columns - TileGap;
  const int height = this->RowHeight();
  for (std::size_t n = 0; n < this->All.size(); ++n)
  {
    const int column = static_cast<int>(n) % columns;
    const int row = static_cast<int>(n) / columns;
    this->All[n]->setGeometry(column * (width + TileGap), row * (height + TileGap), width, height);
  }
}
} // namespace palpate
