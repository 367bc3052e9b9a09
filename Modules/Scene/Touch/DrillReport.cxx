#include "DrillReport.h"

#include "DecimalText.h"
#include "HtmlText.h"
#include "ReportPage.h"
#include "SvgChart.h"

#include <utility>
#include <vector>

namespace palpate
{
namespace
{
std::string RemovedText(double volume)
{
  return SignificantText(volume, 4) + " mm\u00b3 removed";
}

std::string ApproachText(const DrillApproach& one)
{
  std::string text = "smallest distance " + FixedText(one.Least, 2) + " mm at " +
                     FixedText(one.LeastTime, 2) + " s";
  if (one.AlarmSeconds > 0.0)
  {
    text += "; within " + FixedText(one.AlarmDistance, 2) + " mm for " +
            FixedText(one.AlarmSeconds, 2) + " s";
  }
  return text;
}
} // namespace

nlohmann::ordered_json DrillSummary(const PreparedTouch& touch, const TouchResult& result)
{
  nlohmann::ordered_json summary{{"orders", result.DrillOrders}, {"problem", result.DrillProblem}};
  for (std::size_t site = 0; site < result.RemovedVolumes.size(); ++site)
  {
    summary["removed"].push_back(
        {{"name", touch.Drill->Sites()[site].Name}, {"mm3", result.RemovedVolumes[site]}});
  }
  for (const DrillApproach& one : result.Approaches)
  {
    summary["forbidden"].push_back({{"name", one.Name},
                                    {"least_mm", one.Least},
                                    {"least_at_s", one.LeastTime},
                                    {"alarm_mm", one.AlarmDistance},
                                    {"alarm_s", one.AlarmSeconds}});
  }
  return summary;
}

std::vector<std::string> DrillLines(const PreparedTouch& touch, const TouchResult& result)
{
  std::vector<std::string> lines;
  for (std::size_t site = 0; site < result.RemovedVolumes.size(); ++site)
  {
    lines.push_back(touch.Drill->Sites()[site].Name + ": " +
                    RemovedText(result.RemovedVolumes[site]));
  }
  for (const DrillApproach& one : result.Approaches)
  {
    lines.push_back(one.Name + ": " + ApproachText(one));
  }
  if (!result.DrillProblem.empty())
  {
    lines.push_back(result.DrillProblem);
  }
  return lines;
}

std::string DrillSection(const PreparedTouch& touch, const TouchResult& result)
{
  std::string charts;
  HtmlRows rows;
  for (std::size_t site = 0; site < result.RemovedVolumes.size(); ++site)
  {
    const std::string& name = touch.Drill->Sites()[site].Name;
    rows.emplace_back(name, RemovedText(result.RemovedVolumes[site]));
    SvgChart chart("time, s", "removed, mm\u00b3");
    std::vector<std::pair<double, double>> points;
    for (const DrillMoment& moment : result.Removal)
    {
      points.emplace_back(moment.Time, moment.Volumes[site]);
    }
    chart.SetLine(std::move(points));
    charts += ReportFigure(chart.Svg(), EscapeHtml(name));
  }
  for (const DrillApproach& one : result.Approaches)
  {
    rows.emplace_back(one.Name, ApproachText(one));
  }
  if (!result.DrillProblem.empty())
  {
    rows.emplace_back("problem", result.DrillProblem);
  }
  return ReportSection("Drilled",
                       "<div class=\"charts\">\n" + charts + "</div>\n<div class=\"tables\">\n" +
                           HtmlTable("Removed volume and protected structures", rows) + "</div>\n");
}
} // namespace palpate
