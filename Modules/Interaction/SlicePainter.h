#pragma once

#include "GreyWindow.h"
#include "PalpateInteractionModule.h"
#include "PixelGrid.h"

#include "vtkSmartPointer.h"

#include <array>
#include <unordered_map>
#include <vector>

class vtkImageData;

namespace palpate
{
/// Labels painted over an image: those with a colour (red, green, blue, opacity; 0 to 1).
struct LabelLayer
{
  using Color = std::array<float, 4>;

  vtkSmartPointer<vtkImageData> Image;
  std::unordered_map<int, Color> Colors;
};

/// The content of a slice.
struct SliceContent
{
  vtkSmartPointer<vtkImageData> Image; ///< null: labels only
  GreyWindow Window;
  bool IsSmooth = true; ///< linear interpolation instead of nearest voxels
  std::vector<LabelLayer> Layers;
  float LabelOpacity = 1.0F; ///< multiplied by that of each label
};

/// Paints the pixels of a plane: grey values of an image, labels over them in the order of their
/// layers. A pixel with neither is transparent. Rows are painted by vtkSMPTools; the result does
/// not depend on the number of threads. `picture` becomes red, green, blue and opacity (0 to 255),
/// its first row at the grid's first one.
PALPATEINTERACTION_EXPORT void PaintSlice(const SliceContent& content, const PixelGrid& grid,
                                          vtkImageData* raster);
} // namespace palpate
