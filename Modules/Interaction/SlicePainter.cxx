#include "SlicePainter.h"

#include "PlaneSampler.h"

#include "vtkImageData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
// No label has this number, since labels fit into an int.
constexpr float NoLabel = 1e20F;
// Turns truncation of a non-negative number into rounding.
constexpr float Half = 0.5F;

// Squares along the shorter side of the picture.
constexpr int Squares = 8;

// Parts that an opacity is rounded to: integers are mixed faster. A power of two, so that they are
// divided by shifting; no level changes by more than 1.
constexpr std::uint32_t WholeShare = 4096;

struct PaintedImage
{
  PlaneSampler Values;
  const ImageLayer& Layer;
};

struct PaintedLayer
{
  PlaneSampler Labels;
  const LabelLayer& Layer;
};

// Paints rows of one slice; those of a range share their buffers.
class RowPainter
{
public:
  RowPainter(const SliceContent& content, const PixelGrid& grid, std::uint8_t* pixels)
      : Content(content), Grid(grid), Pixels(pixels)
  {
    if (content.Image != nullptr)
    {
      this->Image.emplace_back(content.Image, grid);
    }
    if (content.Image != nullptr && content.Band && content.Band->Mask != nullptr)
    {
      this->Mask.emplace_back(content.Band->Mask, grid);
    }
    for (const ImageLayer& layer : content.Over)
    {
      if (layer.Image != nullptr)
      {
        this->Over.push_back({PlaneSampler(layer.Image, grid), layer});
      }
    }
    for (const LabelLayer& layer : content.Layers)
    {
      if (layer.Image != nullptr && !layer.Colors.empty())
      {
        this->Layers.push_back({PlaneSampler(layer.Image, grid), layer});
      }
    }
  }

  void operator()(vtkIdType begin, vtkIdType end) const
  {
    std::vector<float> values(static_cast<std::size_t>(this->Grid.Width));
    std::vector<float> others(this->Over.empty() ? 0 : values.size());
    for (auto row = static_cast<int>(begin); row < end; ++row)
    {
      std::uint8_t* pixels = this->Pixels + std::size_t{4} * row * this->Grid.Width;
      this->PaintGrey(row, values, pixels);
      for (const PaintedImage& image : this->Over)
      {
        this->PaintOver(image, row, others, pixels);
      }
      this->PaintBand(row, values, pixels);
      for (const PaintedLayer& layer : this->Layers)
      {
        layer.Labels.SampleNearest(row, NoLabel, values.data());
        this->BlendLabels(layer.Layer, values, pixels);
      }
    }
  }

private:
  void PaintGrey(int row, std::vector<float>& values, std::uint8_t* pixels) const
  {
    if (this->Image.empty())
    {
      std::fill_n(pixels, 4 * values.size(), std::uint8_t{0});
      return;
    }
    this->Sample(this->Image.front(), row, values);
    const auto low = static_cast<float>(this->Content.Window.Low);
    const auto scale =
        static_cast<float>(255.0 / (this->Content.Window.High - this->Content.Window.Low));
    for (const float value : values)
    {
      const bool isNumber = value == value;
      const float grey = isNumber ? std::clamp((value - low) * scale + Half, 0.0F, 255.0F) : 0.0F;
      const auto level = static_cast<std::uint8_t>(grey);
      *pixels++ = level;
      *pixels++ = level;
      *pixels++ = level;
      *pixels++ = isNumber ? 255 : 0;
    }
  }

  void Sample(const PlaneSampler& image, int row, std::vector<float>& values) const
  {
    if (this->Content.IsSmooth)
    {
      image.SampleLinear(row, values.data());
    }
    else
    {
      image.SampleNearest(row, std::numeric_limits<float>::quiet_NaN(), values.data());
    }
  }

  // The share of an image over the first one from `column` on, and the next column where it may
  // differ.
  std::pair<float, int> ShareAt(const ImageLayer& layer, int column, int row) const
  {
    const int width = this->Grid.Width;
    if (this->Content.Mixing == ImageMixing::Checkerboard)
    {
      const int side = std::max(1, std::min(width, this->Grid.Height) / Squares);
      const bool isOver = (column / side + row / side) % 2 != 0;
      return {isOver ? 1.0F : 0.0F, std::min(width, (column / side + 1) * side)};
    }
    if (this->Content.Mixing == ImageMixing::Curtain)
    {
      const int place = static_cast<int>(std::lround(this->Content.Curtain * width));
      return column < place ? std::pair(1.0F, std::min(place, width)) : std::pair(0.0F, width);
    }
    return {layer.Opacity, width};
  }

  void PaintOver(const PaintedImage& image, int row, std::vector<float>& values,
                 std::uint8_t* pixels) const
  {
    const ImageLayer& layer = image.Layer;
    const ColorTable& colors = TableOf(layer.Colors);
    const auto low = static_cast<float>(layer.Window.Low);
    const auto scale = static_cast<float>(255.0 / (layer.Window.High - layer.Window.Low));
    this->Sample(image.Values, row, values);
    for (int column = 0; column < this->Grid.Width;)
    {
      const auto [share, next] = this->ShareAt(layer, column, row);
      const auto parts = static_cast<std::uint32_t>(std::lround(share * WholeShare));
      for (; column < next; ++column)
      {
        const float value = values[static_cast<std::size_t>(column)];
        const bool isHidden = layer.HidesBelow && value <= low;
        // Neither where it is transparent nor where there is no number.
        if (parts > 0 && value == value && !isHidden)
        {
          const float place = std::clamp((value - low) * scale + Half, 0.0F, 255.0F);
          Mix(colors[static_cast<std::size_t>(place)], parts, pixels + std::size_t{4} * column);
        }
      }
    }
  }

  // Of WholeShare parts. Over a transparent pixel the colour is whole.
  static void Mix(const std::array<std::uint8_t, 3>& color, std::uint32_t parts,
                  std::uint8_t* pixel)
  {
    const std::uint32_t kept = pixel[3] == 0 ? 0 : WholeShare - parts;
    for (std::size_t c = 0; c < 3; ++c)
    {
      const std::uint32_t mixed = kept * pixel[c] + (WholeShare - kept) * color[c];
      pixel[c] = static_cast<std::uint8_t>((mixed + WholeShare / 2) / WholeShare);
    }
    pixel[3] = 255;
  }

  // `values` are those that PaintGrey left.
  void PaintBand(int row, std::vector<float>& values, std::uint8_t* pixels) const
  {
    if (this->Image.empty() || !this->Content.Band)
    {
      return;
    }
    const ValueBand& band = *this->Content.Band;
    constexpr float Nowhere = std::numeric_limits<float>::quiet_NaN();
    if (band.High < std::numeric_limits<double>::infinity())
    {
      this->Image.front().SampleNearest(row, Nowhere, values.data());
    }
    std::vector<float> labels;
    if (!this->Mask.empty())
    {
      labels.resize(values.size());
      this->Mask.front().SampleNearest(row, NoLabel, labels.data());
    }
    const auto label = static_cast<float>(band.MaskValue);
    for (std::size_t pixel = 0; pixel < values.size(); ++pixel)
    {
      const bool isIn = values[pixel] >= band.Low && values[pixel] <= band.High &&
                        (labels.empty() || labels[pixel] == label);
      if (isIn)
      {
        Blend(band.Color, pixels + 4 * pixel);
      }
    }
  }

  static void Blend(const LabelLayer::Color& color, std::uint8_t* pixel)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      const auto grey = static_cast<float>(pixel[c]);
      const float mixed = (1.0F - color[3]) * grey + color[3] * 255.0F * color[c];
      pixel[c] = static_cast<std::uint8_t>(mixed + Half);
    }
    pixel[3] = 255;
  }

  // Neighbours mostly have the same label, so its colour is looked up only on a change.
  void BlendLabels(const LabelLayer& layer, const std::vector<float>& labels,
                   std::uint8_t* pixels) const
  {
    float known = NoLabel;
    LabelLayer::Color color{};
    for (const float label : labels)
    {
      if (label != known)
      {
        const auto found =
            label == NoLabel ? layer.Colors.end() : layer.Colors.find(static_cast<int>(label));
        color = found == layer.Colors.end() ? LabelLayer::Color{} : found->second;
        color[3] *= this->Content.LabelOpacity;
        known = label;
      }
      if (color[3] > 0.0F)
      {
        Blend(color, pixels);
      }
      pixels += 4;
    }
  }

  const SliceContent& Content;
  const PixelGrid& Grid;
  std::uint8_t* Pixels;
  std::vector<PlaneSampler> Image; // one or none
  std::vector<PlaneSampler> Mask;  // of the band; one or none
  std::vector<PaintedImage> Over;
  std::vector<PaintedLayer> Layers;
};

void Allocate(vtkImageData* raster, const PixelGrid& grid)
{
  const int* size = raster->GetDimensions();
  if (raster->GetNumberOfScalarComponents() != 4 || size[0] != grid.Width ||
      size[1] != grid.Height || size[2] != 1)
  {
    raster->SetDimensions(grid.Width, grid.Height, 1);
    raster->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  }
}
} // namespace

void PaintSlice(const SliceContent& content, const PixelGrid& grid, vtkImageData* raster)
{
  constexpr vtkIdType RowsAtATime = 16;
  Allocate(raster, grid);
  const RowPainter painter(content, grid, static_cast<std::uint8_t*>(raster->GetScalarPointer()));
  vtkSMPTools::For(0, grid.Height, RowsAtATime, painter);
  raster->Modified();
}
} // namespace palpate
