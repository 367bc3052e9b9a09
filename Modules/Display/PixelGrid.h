#pragma once

#include "Vector3.h"

namespace palpate
{
/// The pixels of a plane in space, row by row; patient LPS, mm.
struct PixelGrid
{
  Vector3 FirstWorld = Vector3::Zero();   ///< centre of the first pixel
  Vector3 ColumnWorld = Vector3::UnitX(); ///< the step from a pixel to the next one of its row
  Vector3 RowWorld = Vector3::UnitY();    ///< the step from a row to the next one
  int Width = 0;
  int Height = 0;

  Vector3 PixelWorld(double column, double row) const
  {
    return this->FirstWorld + column * this->ColumnWorld + row * this->RowWorld;
  }
  bool operator==(const PixelGrid& other) const
  {
    return this->FirstWorld == other.FirstWorld && this->ColumnWorld == other.ColumnWorld &&
           this->RowWorld == other.RowWorld && this->Width == other.Width &&
           this->Height == other.Height;
  }
  bool operator!=(const PixelGrid& other) const { return !(*this == other); }
};
} // namespace palpate
