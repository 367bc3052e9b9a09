#include "ModeSlider.h"

#include "DecimalText.h"

#include <cmath>

namespace palpate
{
namespace
{
constexpr int StepsToASide = 4;

// "mean - 1.5 sd"
std::string StepCaption(double deviations)
{
  return deviations == 0.0 ? "mean"
                           : std::string("mean ") + (deviations < 0.0 ? "\xE2\x88\x92 " : "+ ") +
                                 SignificantText(std::abs(deviations), 2) + " sd";
}
} // namespace

std::string ModeSlider(const CohortGroup& group, int mode, double deviations,
                       const ShapeFigures& figures)
{
  const OrganModel mean = ShapeOf(group, -1, 0.0);
  std::string images;
  for (int step = -StepsToASide; step <= StepsToASide; ++step)
  {
    const double moved = deviations * step / StepsToASide;
    const ReportFigure figure = figures.Figure(DrawOffsets(ShapeOf(group, mode, moved), mean),
                                               ViewSide::Anterior, StepCaption(moved));
    images += "<div data-step=\"" + std::to_string(step) + "\"" +
              (step == 0 ? "" : " hidden=\"hidden\"") + ">" + figure.Html() + "</div>";
  }
  const std::string end = std::to_string(StepsToASide);
  return "<div>" + images + "<input style=\"width:100%\" type=\"range\" min=\"-" + end +
         "\" max=\"" + end + "\" value=\"0\" aria-label=\"Mode " + std::to_string(mode + 1) +
         "\" oninput=\"for (const one of this.parentNode.querySelectorAll('[data-step]')) "
         "one.hidden = one.dataset.step "
         "!== this.value\"/></div>\n";
}
} // namespace palpate
