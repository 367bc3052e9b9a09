#include "SixViews.h"

#include "AnatomicalView.h"
#include "ArrayColors.h"
#include "DecimalText.h"
#include "HtmlText.h"
#include "RasterImage.h"
#include "ReportPage.h"
#include "SoftwareRenderer.h"

#include "vtkSMPTools.h"

#include <array>
#include <cstdio>

namespace palpate
{
namespace
{
constexpr int ViewSize = 300; // pixels

std::string CssColor(const std::array<std::uint8_t, 3>& color)
{
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", color[0], color[1], color[2]);
  return text.data();
}

std::string ViewFigure(const SoftwareRenderer& renderer, ViewSide side)
{
  const ViewFrame frame = FrameOf(side);
  const std::string size = std::to_string(ViewSize);
  const auto letter = [](double x, double y, const char* anchor, const Vector3& direction)
  {
    return "<text x=\"" + FixedText(x, 0) + "\" y=\"" + FixedText(y, 0) + "\" text-anchor=\"" +
           anchor + "\">" + OrientationLetters(direction) + "</text>";
  };
  const std::string svg =
      "<svg class=\"view\" role=\"img\" viewBox=\"0 0 " + size + " " + size + "\" aria-label=\"" +
      NameOf(side) + " view\"><image width=\"" + size + "\" height=\"" + size + "\" href=\"" +
      PngDataUri(renderer.Render(side, ViewSize)) + "\"/>" +
      letter(6.0, 0.5 * ViewSize + 5.0, "start", -frame.RightWorld) +
      letter(ViewSize - 6.0, 0.5 * ViewSize + 5.0, "end", frame.RightWorld) +
      letter(0.5 * ViewSize, 16.0, "middle", frame.UpWorld) +
      letter(0.5 * ViewSize, ViewSize - 6.0, "middle", -frame.UpWorld) + "</svg>";
  return ReportFigure(svg, NameOf(side));
}
} // namespace

std::string SixViews(const SoftwareRenderer& renderer)
{
  std::array<std::string, AllViewSides.size()> figures;
  vtkSMPTools::Transform(AllViewSides.begin(), AllViewSides.end(), figures.begin(),
                         [&](ViewSide side) { return ViewFigure(renderer, side); });
  std::string html = "<div class=\"views\">\n";
  for (const std::string& figure : figures)
  {
    html += figure;
  }
  return html + "</div>\n";
}

std::string DivergingColorBar(vtkLookupTable* colors, const std::string& low,
                              const std::string& unit, const std::string& high)
{
  const double limit = colors->GetRange()[1];
  constexpr int Stops = 16;
  constexpr double Left = 20.0;
  constexpr double Width = 360.0;
  std::string svg = "<svg class=\"colorbar\" viewBox=\"0 0 400 62\" role=\"img\" "
                    "aria-label=\"colour bar\"><defs><linearGradient id=\"distance\">";
  for (int stop = 0; stop <= Stops; ++stop)
  {
    const double share = static_cast<double>(stop) / Stops;
    svg += "<stop offset=\"" + SignificantText(share, 4) + "\" stop-color=\"" +
           CssColor(ColorOf(colors, (2.0 * share - 1.0) * limit)) + "\"/>";
  }
  svg += "</linearGradient></defs><rect x=\"20\" y=\"18\" width=\"360\" height=\"14\" rx=\"2\" "
         "fill=\"url(#distance)\"/>";
  for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0})
  {
    const double x = Left + 0.5 * (share + 1.0) * Width;
    const std::string sign = share > 0.0 ? "+" : "";
    svg += "<text text-anchor=\"middle\" x=\"" + FixedText(x, 1) + "\" y=\"48\">" + sign +
           SignificantText(share * limit, 3) + "</text>";
  }
  return svg + "<text x=\"20\" y=\"12\">" + EscapeHtml(low) + "</text><text x=\"380\" y=\"12\" " +
         "text-anchor=\"end\">" + EscapeHtml(high) + "</text><text x=\"200\" y=\"12\" " +
         "text-anchor=\"middle\">" + EscapeHtml(unit) + "</text></svg>\n";
}
} // namespace palpate
