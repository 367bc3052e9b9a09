#include "SixViews.h"

#include "AnatomicalView.h"
#include "ArrayColors.h"
#include "DecimalText.h"
#include "HtmlText.h"
#include "RasterImage.h"
#include "ReportPage.h"

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

ReportFigure ViewFigure(const SoftwareRenderer& renderer, ViewSide side)
{
  const ViewFrame frame = FrameOf(side);
  const std::string size = std::to_string(ViewSize);
  const std::string svg =
      "<svg class=\"view\" role=\"img\" viewBox=\"0 0 " + size + " " + size + "\" aria-label=\"" +
      NameOf(side) + " view\"><image width=\"" + size + "\" height=\"" + size + "\" href=\"" +
      PngDataUri(renderer.Render(side, ViewSize)) + "\"/>" +
      SideLetters(ViewSize, ViewSize, frame.RightWorld, -frame.UpWorld) + "</svg>";
  return {svg, NameOf(side)};
}
} // namespace

std::string SideLetters(double width, double height, const Vector3& rightWorld,
                        const Vector3& downWorld)
{
  const auto letter = [](double x, double y, const char* anchor, const Vector3& direction)
  {
    return "<text x=\"" + FixedText(x, 1) + "\" y=\"" + FixedText(y, 1) + "\" text-anchor=\"" +
           anchor + "\">" + OrientationLetters(direction) + "</text>";
  };
  const double middleY = 0.5 * height + 5.0;
  return letter(5.0, middleY, "start", -rightWorld) +
         letter(width - 5.0, middleY, "end", rightWorld) +
         letter(0.5 * width, 17.0, "middle", -downWorld) +
         letter(0.5 * width, height - 6.0, "middle", downWorld);
}

void AddSixViews(ReportPage& page, const SoftwareRenderer& renderer)
{
  std::array<ReportFigure, AllViewSides.size()> figures;
  vtkSMPTools::Transform(AllViewSides.begin(), AllViewSides.end(), figures.begin(),
                         [&](ViewSide side) { return ViewFigure(renderer, side); });
  for (const ReportFigure& figure : figures)
  {
    page.Figure("views", figure);
  }
}

void AddColorBar(ReportPage& page, vtkLookupTable* colors, const std::string& low,
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
  page.Put({}, svg + "<text x=\"20\" y=\"12\">" + EscapeHtml(low) +
                   "</text><text x=\"380\" y=\"12\" " + "text-anchor=\"end\">" + EscapeHtml(high) +
                   "</text><text x=\"200\" y=\"12\" " + "text-anchor=\"middle\">" +
                   EscapeHtml(unit) + "</text></svg>\n");
}
} // namespace palpate
