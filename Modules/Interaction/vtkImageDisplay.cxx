#include "vtkImageDisplay.h"

#include "ImageAxes.h"
#include "SlicePainter.h"

#include "vtkImageData.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

using palpate::GreyWindow;
using palpate::LabelLayer;
using palpate::Vector3;

vtkStandardNewMacro(vtkImageDisplay);

namespace
{
constexpr double DefaultLabelOpacity = 0.4;
constexpr double SmallestWindowShare = 1e-3;
} // namespace

vtkImageDisplay::vtkImageDisplay() : Content(std::make_unique<palpate::SliceContent>())
{
  this->Content->LabelOpacity = DefaultLabelOpacity;
}

vtkImageDisplay::~vtkImageDisplay() = default;

void vtkImageDisplay::SetImage(vtkImageData* image)
{
  if (this->Content->Image != image)
  {
    this->Content->Image = image;
    this->Content->Band.reset();
    this->ResetWindowLevel();
    this->Modified();
  }
}

vtkImageData* vtkImageDisplay::GetImage()
{
  return this->Content->Image;
}

void vtkImageDisplay::ResetWindowLevel()
{
  if (this->Content->Image != nullptr)
  {
    const GreyWindow window = palpate::WindowOf(this->Content->Image);
    this->ChosenWindow = window.High - window.Low;
    this->SetWindowLevel(this->ChosenWindow, 0.5 * (window.Low + window.High));
  }
}

void vtkImageDisplay::SetWindowLevel(double window, double level)
{
  if (!std::isfinite(window) || !std::isfinite(level))
  {
    return;
  }
  const double width = std::max(window, SmallestWindowShare * this->ChosenWindow);
  GreyWindow& shown = this->Content->Window;
  const GreyWindow wanted{level - 0.5 * width, level + 0.5 * width};
  if (shown.Low != wanted.Low || shown.High != wanted.High)
  {
    shown = wanted;
    this->Modified();
  }
}

double vtkImageDisplay::GetWindow()
{
  return this->Content->Window.High - this->Content->Window.Low;
}

double vtkImageDisplay::GetLevel()
{
  return 0.5 * (this->Content->Window.Low + this->Content->Window.High);
}

void vtkImageDisplay::SetInterpolate(bool interpolate)
{
  if (this->Content->IsSmooth != interpolate)
  {
    this->Content->IsSmooth = interpolate;
    this->Modified();
  }
}

int vtkImageDisplay::AddOverlay(vtkImageData* image)
{
  palpate::ImageLayer overlay;
  overlay.Image = image;
  overlay.Window = palpate::WindowOf(image);
  this->Content->Over.push_back(overlay);
  this->Modified();
  return this->GetNumberOfOverlays() - 1;
}

int vtkImageDisplay::GetNumberOfOverlays()
{
  return static_cast<int>(this->Content->Over.size());
}

void vtkImageDisplay::RemoveAllOverlays()
{
  if (!this->Content->Over.empty())
  {
    this->Content->Over.clear();
    this->Modified();
  }
}

bool vtkImageDisplay::HasOverlay(int overlay)
{
  const bool isThere = overlay >= 0 && overlay < this->GetNumberOfOverlays();
  if (!isThere)
  {
    vtkErrorMacro(<< "There is no overlay " << overlay << ".");
  }
  return isThere;
}

void vtkImageDisplay::SetOverlayWindowLevel(int overlay, double window, double level)
{
  if (this->HasOverlay(overlay) && window > 0.0 && std::isfinite(window) && std::isfinite(level))
  {
    GreyWindow& shown = this->Content->Over[static_cast<std::size_t>(overlay)].Window;
    shown = {level - 0.5 * window, level + 0.5 * window};
    this->Modified();
  }
}

double vtkImageDisplay::GetOverlayWindow(int overlay)
{
  if (!this->HasOverlay(overlay))
  {
    return 0.0;
  }
  const GreyWindow& shown = this->Content->Over[static_cast<std::size_t>(overlay)].Window;
  return shown.High - shown.Low;
}

double vtkImageDisplay::GetOverlayLevel(int overlay)
{
  if (!this->HasOverlay(overlay))
  {
    return 0.0;
  }
  const GreyWindow& shown = this->Content->Over[static_cast<std::size_t>(overlay)].Window;
  return 0.5 * (shown.Low + shown.High);
}

void vtkImageDisplay::SetOverlayColors(int overlay, int colors)
{
  const bool isKnown = colors >= 0 && colors < static_cast<int>(palpate::AllVolumeColors.size());
  if (this->HasOverlay(overlay) && isKnown)
  {
    this->Content->Over[static_cast<std::size_t>(overlay)].Colors =
        palpate::AllVolumeColors[static_cast<std::size_t>(colors)];
    this->Modified();
  }
}

void vtkImageDisplay::SetOverlayOpacity(int overlay, double opacity)
{
  if (this->HasOverlay(overlay) && std::isfinite(opacity))
  {
    this->Content->Over[static_cast<std::size_t>(overlay)].Opacity =
        static_cast<float>(std::clamp(opacity, 0.0, 1.0));
    this->Modified();
  }
}

void vtkImageDisplay::SetOverlayHidesBelow(int overlay, bool hides)
{
  if (this->HasOverlay(overlay))
  {
    this->Content->Over[static_cast<std::size_t>(overlay)].HidesBelow = hides;
    this->Modified();
  }
}

void vtkImageDisplay::SetMixing(int mixing)
{
  const auto wanted = static_cast<palpate::ImageMixing>(std::clamp<int>(mixing, BLEND, CURTAIN));
  if (this->Content->Mixing != wanted)
  {
    this->Content->Mixing = wanted;
    this->Modified();
  }
}

int vtkImageDisplay::GetMixing()
{
  return static_cast<int>(this->Content->Mixing);
}

void vtkImageDisplay::SetCurtain(double place)
{
  if (std::isfinite(place) && this->Content->Curtain != std::clamp(place, 0.0, 1.0))
  {
    this->Content->Curtain = std::clamp(place, 0.0, 1.0);
    this->Modified();
  }
}

double vtkImageDisplay::GetCurtain()
{
  return this->Content->Curtain;
}

int vtkImageDisplay::AddLabels(vtkImageData* labels)
{
  this->Content->Layers.push_back({labels, {}});
  this->Modified();
  return this->GetNumberOfLayers() - 1;
}

int vtkImageDisplay::GetNumberOfLayers()
{
  return static_cast<int>(this->Content->Layers.size());
}

void vtkImageDisplay::RemoveAllLabels()
{
  if (!this->Content->Layers.empty())
  {
    this->Content->Layers.clear();
    this->Modified();
  }
}

void vtkImageDisplay::SetLabelColor(int layer, int label, double red, double green, double blue,
                                    double opacity)
{
  if (layer < 0 || layer >= this->GetNumberOfLayers())
  {
    vtkErrorMacro(<< "There is no layer " << layer << " of labels.");
    return;
  }
  LabelLayer::Color color{};
  const double parts[4] = {red, green, blue, opacity};
  std::transform(parts, parts + 4, color.begin(),
                 [](double part) { return static_cast<float>(std::clamp(part, 0.0, 1.0)); });
  this->Content->Layers[static_cast<std::size_t>(layer)].Colors[label] = color;
  this->Modified();
}

void vtkImageDisplay::SetLabelOpacity(double opacity)
{
  const auto wanted = static_cast<float>(std::clamp(opacity, 0.0, 1.0));
  if (this->Content->LabelOpacity != wanted)
  {
    this->Content->LabelOpacity = wanted;
    this->Modified();
  }
}

double vtkImageDisplay::GetLabelOpacity()
{
  return this->Content->LabelOpacity;
}

void vtkImageDisplay::MarkValues(double low, double high, vtkImageData* mask, int label)
{
  if (std::isnan(low) || std::isnan(high))
  {
    return;
  }
  palpate::ValueBand band;
  band.Low = low;
  band.High = high;
  band.Mask = mask;
  band.MaskValue = label;
  this->Content->Band = band;
  this->Modified();
}

void vtkImageDisplay::ClearMarkedValues()
{
  if (this->Content->Band)
  {
    this->Content->Band.reset();
    this->Modified();
  }
}

bool vtkImageDisplay::HasMarkedValues()
{
  return this->Content->Band.has_value();
}

bool vtkImageDisplay::GetCenterWorld(double center[3])
{
  if (this->Content->Image == nullptr)
  {
    return false;
  }
  const palpate::ImageAxes axes(this->Content->Image);
  const std::array<int, 6>& e = axes.Extent;
  const Vector3 middle = axes.ToWorld(0.5 * Vector3(e[0] + e[1], e[2] + e[3], e[4] + e[5]));
  std::copy_n(middle.data(), 3, center);
  return true;
}

vtkMTimeType vtkImageDisplay::GetMTime()
{
  vtkMTimeType time = this->Superclass::GetMTime();
  if (this->Content->Image != nullptr)
  {
    time = std::max(time, this->Content->Image->GetMTime());
  }
  for (const palpate::ImageLayer& overlay : this->Content->Over)
  {
    time = std::max(time, overlay.Image->GetMTime());
  }
  for (const LabelLayer& layer : this->Content->Layers)
  {
    time = layer.Image == nullptr ? time : std::max(time, layer.Image->GetMTime());
  }
  return time;
}

void vtkImageDisplay::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Image: " << this->Content->Image.Get() << '\n';
  os << indent << "Window: " << this->GetWindow() << '\n';
  os << indent << "Level: " << this->GetLevel() << '\n';
  os << indent << "Interpolate: " << this->Content->IsSmooth << '\n';
  os << indent << "Overlays: " << this->Content->Over.size() << '\n';
  os << indent << "Mixing: " << this->GetMixing() << '\n';
  os << indent << "Curtain: " << this->Content->Curtain << '\n';
  os << indent << "Layers: " << this->Content->Layers.size() << '\n';
  os << indent << "LabelOpacity: " << this->Content->LabelOpacity << '\n';
  os << indent << "HasMarkedValues: " << this->Content->Band.has_value() << '\n';
}
