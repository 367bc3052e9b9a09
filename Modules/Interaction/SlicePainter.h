#pragma once

#include "GreyWindow.h"
#include "PalpateInteractionModule.h"
#include "PixelGrid.h"
#include "VolumeColors.h"

#include "vtkSmartPointer.h"

#include <array>
#include <limits>
#include <optional>
#include <unordered_map>
#include <vector>

class vtkImageData;

namespace palpate
{
/// A further image over the first one.
struct ImageLayer
{
  vtkSmartPointer<vtkImageData> Image;
  GreyWindow Window;
  VolumeColors Colors = VolumeColors::Grey;
  float Opacity = 0.5F;    ///< of a blend, 0 to 1
  bool HidesBelow = false; ///< values up to the window's low end are transparent
};

/// Where further images cover the first one.
enum class ImageMixing
{
  Blend,        ///< everywhere, with their opacities
  Checkerboard, ///< in every other square
  Curtain       ///< to the left of the curtain
};

/// Labels painted over an image: those with a colour (red, green, blue, opacity; 0 to 1).
struct LabelLayer
{
  using Color = std::array<float, 4>;

  vtkSmartPointer<vtkImageData> Image;
  std::unordered_map<int, Color> Colors;
};

/// A range of values that is painted over an image in one colour, such as that of a structure that
/// is about to be made.
struct ValueBand
{
  double Low = 0.0;
  /// Without an upper limit, interpolated values are painted, up to the iso-surface; with one,
  /// whole voxels, since a range of voxels is not a range of interpolated values.
  double High = std::numeric_limits<double>::infinity();
  vtkSmartPointer<vtkImageData> Mask; ///< a label map that limits it; null: none
  int MaskValue = 0;
  std::array<float, 4> Color{{1.0F, 0.55F, 0.0F, 0.5F}}; ///< red, green, blue, opacity; 0 to 1
};

/// The content of a slice.
struct SliceContent
{
  vtkSmartPointer<vtkImageData> Image; ///< null: labels only
  GreyWindow Window;
  bool IsSmooth = true; ///< linear interpolation instead of nearest voxels
  std::vector<ImageLayer> Over;
  ImageMixing Mixing = ImageMixing::Blend;
  double Curtain = 0.5; ///< its place as a fraction of the picture's width
  std::vector<LabelLayer> Layers;
  float LabelOpacity = 1.0F;     ///< multiplied by that of each label
  std::optional<ValueBand> Band; ///< over the image, under the labels
};

/// Paints the pixels of a plane: grey values of an image, further images over it in their order, a
/// band of the first one's values, labels over them in the order of their layers. A pixel with
/// neither is transparent. Rows are painted by vtkSMPTools; the result does not depend on the
/// number of threads. `picture` becomes red, green, blue and opacity (0 to 255), its first row at
/// the grid's first one.
PALPATEINTERACTION_EXPORT void PaintSlice(const SliceContent& content, const PixelGrid& grid,
                                          vtkImageData* raster);
} // namespace palpate
