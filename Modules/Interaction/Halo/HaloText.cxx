#include "HaloText.h"

#include "Vector3.h"

#include "vtkCamera.h"
#include "vtkCoordinate.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkProperty2D.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
namespace
{
constexpr double RimPoints = 1.0;
constexpr int RimPercent = 70; // opacity: a solid rim would fill small letters

// The largest of the alphas within `radius` pixels along the rows, and then along the columns.
std::vector<std::uint8_t> Spread(const std::vector<std::uint8_t>& alpha, int width, int height,
                                 int radius)
{
  const auto largest = [&](const std::vector<std::uint8_t>& from, int dx, int dy)
  {
    std::vector<std::uint8_t> to(from.size());
    for (int y = 0; y < height; ++y)
    {
      for (int x = 0; x < width; ++x)
      {
        std::uint8_t& most = to[static_cast<std::size_t>(y * width + x)];
        for (int step = -radius; step <= radius; ++step)
        {
          const int column = std::clamp(x + step * dx, 0, width - 1);
          const int row = std::clamp(y + step * dy, 0, height - 1);
          most = std::max(most, from[static_cast<std::size_t>(row * width + column)]);
        }
      }
    }
    return to;
  };
  return largest(largest(alpha, 1, 0), 0, 1);
}

// Lays the letters over their spread alpha in the rim's grey.
void AddRim(std::uint8_t* rgba, int width, int height, int radius, int rim)
{
  std::vector<std::uint8_t> alpha(static_cast<std::size_t>(width) *
                                  static_cast<std::size_t>(height));
  for (std::size_t p = 0; p < alpha.size(); ++p)
  {
    alpha[p] = rgba[4 * p + 3];
  }
  const std::vector<std::uint8_t> spread = Spread(alpha, width, height, radius);
  for (std::size_t p = 0; p < alpha.size(); ++p)
  {
    if (spread[p] < 2) // nothing is left of it
    {
      continue;
    }
    const int letter = alpha[p];
    const int under = RimPercent * spread[p] * (255 - letter) / (100 * 255);
    for (std::size_t c = 0; c < 3; ++c)
    {
      const int mixed = (letter * rgba[4 * p + c] + under * rim) / (letter + under);
      rgba[4 * p + c] = static_cast<std::uint8_t>(mixed);
    }
    rgba[4 * p + 3] = static_cast<std::uint8_t>(letter + under);
  }
}
} // namespace

vtkStandardNewMacro(HaloText);

bool HaloText::RenderImage(vtkTextProperty* style, vtkViewport* viewport)
{
  if (!this->Superclass::RenderImage(style, viewport))
  {
    return false;
  }
  if (this->ImageData->GetScalarType() == VTK_UNSIGNED_CHAR &&
      this->ImageData->GetNumberOfScalarComponents() == 4)
  {
    constexpr double PointsPerInch = 72.0;
    constexpr double Bright = 0.35;
    const double* color = style->GetColor();
    const bool isLight = 0.3 * color[0] + 0.6 * color[1] + 0.1 * color[2] > Bright;
    const int dpi = viewport->GetVTKWindow()->GetDPI();
    const int* size = this->ImageData->GetDimensions();
    AddRim(static_cast<std::uint8_t*>(this->ImageData->GetScalarPointer()), size[0], size[1],
           std::max(1, static_cast<int>(std::lround(RimPoints * dpi / PointsPerInch))),
           isLight ? 0 : 255);
    this->ImageData->Modified();
  }
  return true;
}

// Reads the depths of the frame that is being drawn: texts come after everything else.
bool HaloText::IsHidden(vtkViewport* viewport)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  if (renderer == nullptr)
  {
    return false;
  }
  const Vector3 place(this->GetPositionCoordinate()->GetValue());
  const Vector3 sight(renderer->GetActiveCamera()->GetDirectionOfProjection());
  const Vector3 nearer = place - this->Reach * sight;
  renderer->SetWorldPoint(nearer.x(), nearer.y(), nearer.z(), 1.0);
  renderer->WorldToDisplay();
  const Vector3 pixel(renderer->GetDisplayPoint());
  const int* origin = renderer->GetOrigin();
  const int* size = renderer->GetSize();
  const int x = static_cast<int>(pixel.x());
  const int y = static_cast<int>(pixel.y());
  if (x < origin[0] || y < origin[1] || x >= origin[0] + size[0] || y >= origin[1] + size[1])
  {
    return false;
  }
  float depth = 1.0F;
  renderer->GetRenderWindow()->GetZbufferData(x, y, x, y, &depth);
  return depth < pixel.z();
}

int HaloText::RenderOverlay(vtkViewport* viewport)
{
  const bool isFaint = this->Reach >= 0.0 && this->IsHidden(viewport);
  this->GetProperty()->SetOpacity(isFaint ? FaintOpacity : 1.0);
  return this->Superclass::RenderOverlay(viewport);
}
} // namespace palpate
