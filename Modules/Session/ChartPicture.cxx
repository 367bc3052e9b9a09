#include "ChartPicture.h"

#include "vtkFreeTypeTools.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkStdString.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
using Color = std::array<double, 3>; // 0..255
using Point = std::pair<double, double>;

constexpr Color Ink{28.0, 33.0, 39.0};
constexpr double LineWidth = 1.0; // in the marks' units
constexpr double CurveWidth = 1.6;
constexpr int TextHeight = 11;

// As the page's style sheet has them, on white.
Color ColorOf(const std::string& style)
{
  return style == "grid"     ? Color{221.0, 225.0, 230.0}
         : style == "axis"   ? Color{92.0, 102.0, 112.0}
         : style == "marker" ? Color{217.0, 95.0, 2.0}
                             : Color{51.0, 112.0, 159.0};
}

class ChartPainter
{
public:
  ChartPainter(double width, double height, double scale)
      : Paper(static_cast<int>(std::lround(width * scale)),
              static_cast<int>(std::lround(height * scale))),
        Scale(scale)
  {
    std::fill(this->Paper.Rgba.begin(), this->Paper.Rgba.end(), std::uint8_t{255});
  }

  void Draw(const ChartMark& mark)
  {
    switch (mark.What)
    {
    case ChartMark::Kind::Line:
    case ChartMark::Kind::Curve:
      return this->DrawCurve(mark, mark.What == ChartMark::Kind::Curve ? CurveWidth : LineWidth);
    case ChartMark::Kind::Bar:
      return this->DrawBar(mark);
    case ChartMark::Kind::Dot:
      return this->DrawStroke(mark.Points.front(), mark.Points.front(), 2.0 * ChartDotRadius,
                              ColorOf(mark.Style));
    case ChartMark::Kind::Text:
    case ChartMark::Kind::UprightText:
      return this->DrawText(mark);
    }
  }
  const Picture& Drawn() const { return this->Paper; }

private:
  void Blend(int column, int row, const Color& color, double share)
  {
    const bool isOn =
        column >= 0 && row >= 0 && column < this->Paper.Width && row < this->Paper.Height;
    for (std::size_t c = 0; isOn && c < 3; ++c)
    {
      std::uint8_t& value = this->Paper.Pixel(column, row)[c];
      value = static_cast<std::uint8_t>(std::lround((1.0 - share) * value + share * color[c]));
    }
  }

  void DrawCurve(const ChartMark& mark, double width)
  {
    for (std::size_t p = 0; p + 1 < mark.Points.size(); ++p)
    {
      this->DrawStroke(mark.Points[p], mark.Points[p + 1], width, ColorOf(mark.Style));
    }
  }

  // With round ends; a pixel has the share of it that the stroke's border leaves inside.
  void DrawStroke(const Point& from, const Point& to, double width, const Color& color)
  {
    const double radius = 0.5 * width * this->Scale;
    const double x = from.first * this->Scale;
    const double y = from.second * this->Scale;
    const double alongX = to.first * this->Scale - x;
    const double alongY = to.second * this->Scale - y;
    const double length = alongX * alongX + alongY * alongY;
    const auto low = [&](double start, double along)
    { return static_cast<int>(std::floor(std::min(start, start + along) - radius - 1.0)); };
    const auto high = [&](double start, double along)
    { return static_cast<int>(std::ceil(std::max(start, start + along) + radius + 1.0)); };
    for (int row = low(y, alongY); row <= high(y, alongY); ++row)
    {
      for (int column = low(x, alongX); column <= high(x, alongX); ++column)
      {
        const double dx = column + 0.5 - x;
        const double dy = row + 0.5 - y;
        const double part =
            length > 0.0 ? std::clamp((dx * alongX + dy * alongY) / length, 0.0, 1.0) : 0.0;
        const double distance = std::hypot(dx - part * alongX, dy - part * alongY);
        const double share = std::clamp(radius + 0.5 - distance, 0.0, 1.0);
        if (share > 0.0)
        {
          this->Blend(column, row, color, share);
        }
      }
    }
  }

  void DrawBar(const ChartMark& mark)
  {
    const auto pixel = [this](double place)
    { return static_cast<int>(std::lround(place * this->Scale)); };
    for (int row = pixel(mark.Points[0].second); row < pixel(mark.Points[1].second); ++row)
    {
      for (int column = pixel(mark.Points[0].first); column < pixel(mark.Points[1].first); ++column)
      {
        this->Blend(column, row, ColorOf(mark.Style), 1.0);
      }
    }
  }

  void DrawText(const ChartMark& mark)
  {
    constexpr int Dpi = 72; // so that a point is a pixel
    vtkNew<vtkTextProperty> style;
    style->SetFontSize(static_cast<int>(std::lround(TextHeight * this->Scale)));
    style->SetJustification(static_cast<int>(mark.Anchor)); // left, centred, right
    style->SetVerticalJustificationToBottom();
    style->SetOrientation(mark.What == ChartMark::Kind::UprightText ? 90.0 : 0.0);
    vtkNew<vtkImageData> image;
    int size[2] = {0, 0};
    if (mark.Text.empty() || !vtkFreeTypeTools::GetInstance()->RenderString(
                                 style.Get(), vtkStdString(mark.Text), Dpi, image.Get(), size))
    {
      return;
    }
    const int* extent = image->GetExtent(); // from the point, upwards
    const auto [x, y] = mark.Points.front();
    const int column = static_cast<int>(std::lround(x * this->Scale));
    const int row = static_cast<int>(std::lround(y * this->Scale));
    for (int up = extent[2]; up <= extent[3]; ++up)
    {
      for (int right = extent[0]; right <= extent[1]; ++right)
      {
        const auto* rgba = static_cast<const unsigned char*>(image->GetScalarPointer(right, up, 0));
        this->Blend(column + right, row - up, Ink, rgba[3] / 255.0);
      }
    }
  }

  Picture Paper;
  double Scale;
};
} // namespace

Picture DrawChart(const std::vector<ChartMark>& marks, double width, double height, double scale)
{
  ChartPainter painter(width, height, scale);
  for (const ChartMark& mark : marks)
  {
    painter.Draw(mark);
  }
  return painter.Drawn();
}
} // namespace palpate
