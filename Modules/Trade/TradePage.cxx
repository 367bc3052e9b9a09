#include "TradePage.h"

#include "DecimalText.h"
#include "ReportPage.h"
#include "ReportTable.h"
#include "SvgChart.h"
#include "TradeText.h"
#include "Units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace palpate
{
namespace
{
constexpr double BytesPerMegabyte = 1e6;
// mm, JND: logarithmic axes cannot show 0, and errors below this do not matter.
constexpr double LeastDrawn = 1e-6;

// Number for readers: no exponent where digits suffice.
std::string NumberText(double number)
{
  if (!std::isfinite(number))
  {
    return {};
  }
  const double size = std::abs(number);
  return size >= 100.0 ? FixedText(number, 0) : SignificantText(number, size < 1.0 ? 2 : 3);
}

// The message with a capital first letter.
std::string CapitalOf(std::string message)
{
  if (!message.empty() && message.front() >= 'a' && message.front() <= 'z')
  {
    message.front() = static_cast<char>(message.front() - 'a' + 'A');
  }
  return message;
}

std::string StyleOf(const std::string& representation)
{
  return representation == TouchRepresentation::Harmonics ? "first"
         : representation == TouchRepresentation::Facets  ? "second"
                                                          : "third";
}

// The measured rows of a structure, sorted by time; a row's number in the page is its index here,
// from 1.
std::vector<const TradeRow*> FeltRows(const TradeStructureResult& structure)
{
  std::vector<const TradeRow*> rows;
  for (const TradeRow& row : structure.Rows)
  {
    if (row.IsFelt())
    {
      rows.push_back(&row);
    }
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const TradeRow* a, const TradeRow* b) { return a->TickMean < b->TickMean; });
  return rows;
}

struct Plot
{
  const char* Label;
  const char* Caption;
  double TradeRow::*Error;
  double Threshold; // 0 for none
  const char* ThresholdText;
};

const std::array<Plot, 3> Plots{{
    {"position error (99 %), mm", "Position error of the tool", &TradeRow::PositionRare, 0.0, ""},
    {"force error (99 %), JND", "Force error, in just noticeable differences of the ideal force",
     &TradeRow::NoticeableRare, 1.0, "noticeable"},
    {"direction error (99 %), degrees", "Direction error of the force", &TradeRow::DirectionRare,
     TradeThresholds::NoticeableDegrees, "noticeable"},
}};

std::vector<std::pair<double, double>> PlacesOf(const std::vector<const TradeRow*>& rows,
                                                double TradeRow::*error)
{
  std::vector<std::pair<double, double>> places;
  for (const TradeRow* row : rows)
  {
    // At least LeastDrawn, but NaN stays NaN.
    const double value = row->*error;
    places.emplace_back(MicrosecondsPerNanosecond * row->TickMean,
                        value < LeastDrawn ? LeastDrawn : value);
  }
  return places;
}

void AddPlot(ReportPage& page, const std::vector<const TradeRow*>& rows, const Plot& plot)
{
  const auto places = PlacesOf(rows, plot.Error);
  const std::vector<std::size_t> front = ParetoFront(places);
  std::vector<SvgChart::Dot> dots;
  std::vector<std::pair<double, double>> line;
  for (std::size_t r = 0; r < rows.size(); ++r)
  {
    const bool isOnFront = std::find(front.begin(), front.end(), r) != front.end();
    const auto& [time, error] = places[r];
    const std::string number = std::to_string(r + 1);
    dots.push_back(
        {time, error,
         StyleOf(rows[r]->Setting.Structure.Representation) + (isOnFront ? "" : " faint"),
         number + ": " + Describe(*rows[r]) + ", " + NumberText(time) + " \xC2\xB5s, " +
             NumberText(error),
         isOnFront ? number : std::string()});
  }
  std::transform(front.begin(), front.end(), std::back_inserter(line),
                 [&places](std::size_t r) { return places[r]; });
  SvgChart chart("mean time of a tick, \xC2\xB5s", plot.Label);
  chart.SetLogarithmic(true, true);
  chart.SetDots(std::move(dots));
  chart.SetStairs(std::move(line));
  if (plot.Threshold > 0.0)
  {
    chart.SetThreshold(plot.Threshold, plot.ThresholdText);
  }
  page.Chart(chart, plot.Caption);
}

bool Yields(const std::vector<const TradeRow*>& rows)
{
  return std::any_of(rows.begin(), rows.end(), [](const TradeRow* row) { return row->Yields; });
}

ReportRows LegendOf(bool yields)
{
  ReportRows lines{{"third", "elastic"}, {"first", "rigid"}};
  if (!yields)
  {
    lines = {{"first", "spherical harmonics"}, {"second", "facets"}, {"third", "sub-voxel field"}};
  }
  lines.emplace_back("",
                     "numbered: no other setting is both faster and more accurate; see the table");
  return lines;
}

struct Column
{
  const char* Head;
  double TradeRow::*Number;
  double Factor = 1.0;
};

std::vector<Column> ColumnsOf(bool yields)
{
  constexpr double Milli = 1e-3;
  constexpr double Kilo = 1e3;
  std::vector<Column> columns{{"Mean, \xC2\xB5s", &TradeRow::TickMean, MicrosecondsPerNanosecond},
                              {"Median", &TradeRow::TickMedian, MicrosecondsPerNanosecond},
                              {"99.9 %", &TradeRow::TickRare, MicrosecondsPerNanosecond},
                              {"Rate, kHz", &TradeRow::Rate, Milli}};
  const std::vector<Column> forces{{"Force, mN: mean", &TradeRow::ForceMean, Kilo},
                                   {"99 %", &TradeRow::ForceRare, Kilo}};
  const std::vector<Column> positions{{"Position, mm: mean", &TradeRow::PositionMean},
                                      {"99 %", &TradeRow::PositionRare},
                                      {"Beyond", &TradeRow::BeyondPositionRare}};
  const std::vector<Column> rest{{"Force, JND: mean", &TradeRow::NoticeableMean},
                                 {"99 %", &TradeRow::NoticeableRare},
                                 {"Beyond", &TradeRow::BeyondNoticeableRare},
                                 {"Direction, \xC2\xB0: mean", &TradeRow::DirectionMean},
                                 {"99 %", &TradeRow::DirectionRare},
                                 {"Beyond", &TradeRow::BeyondDirectionRare},
                                 {"Jump, mN: mean", &TradeRow::JumpMean, Kilo},
                                 {"Most", &TradeRow::JumpMost, Kilo},
                                 {"Most, ideal", &TradeRow::IdealJumpMost, Kilo},
                                 {"Seizures", &TradeRow::Seizures},
                                 {"Parted", &TradeRow::Parted},
                                 {"Build time, s", &TradeRow::BuildSeconds},
                                 {"Cost, s", &TradeRow::CostSeconds},
                                 {"Memory, MB", &TradeRow::Bytes, 1.0 / BytesPerMegabyte}};
  const std::vector<Column>& places = yields ? forces : positions;
  columns.insert(columns.end(), places.begin(), places.end());
  columns.insert(columns.end(), rest.begin(), rest.end());
  return columns;
}

ReportTable FeltTable(const std::vector<const TradeRow*>& rows, const TradeRow* chosen)
{
  const std::vector<Column> columns = ColumnsOf(Yields(rows));
  std::vector<std::string> heads{"", "Setting"};
  for (const Column& column : columns)
  {
    heads.emplace_back(column.Head);
  }
  ReportTable table(std::move(heads));
  for (std::size_t r = 0; r < rows.size(); ++r)
  {
    table.Value(std::to_string(r + 1));
    rows[r] == chosen ? table.Marked("good", Describe(*chosen)) : table.Text(Describe(*rows[r]));
    for (const Column& column : columns)
    {
      table.Value(NumberText(column.Factor * rows[r]->*column.Number));
    }
  }
  return table;
}

void AddStructure(ReportPage& page, const TradeStructureResult& structure)
{
  const std::vector<const TradeRow*> rows = FeltRows(structure);
  const TradeAdvice& advice = structure.Advice;
  const bool yields = Yields(rows);
  page.Section(structure.Name)
      .Verdict(advice.IsMet ? "good" : "poor", "", CapitalOf(advice.Message) + ".")
      .SoftText("Reference: " +
                (structure.Rows.empty() ? std::string() : structure.Rows.front().Truth) + ".");
  if (yields)
  {
    page.SoftText("The structure yields: errors are those of its force. Positions of the tool are "
                  "not compared.");
  }
  page.Legend(LegendOf(yields));
  for (const Plot& plot : Plots)
  {
    if (!yields || plot.Error != &TradeRow::PositionRare)
    {
      AddPlot(page, rows, plot);
    }
  }
  page.Table(FeltTable(rows, advice.Row ? &structure.Rows[*advice.Row] : nullptr));
  if (const std::vector<std::string> refusals = RefusalsOf(structure); !refusals.empty())
  {
    page.Subheading("Not measured").Notes(refusals);
  }
}

std::string HowItWasMeasured(const TradeResult& result)
{
  const TradePathSettings& path = result.Settings.Measurement.Path;
  return "Strokes of " + NumberText(path.Seconds) + " s together at 1 kHz (seed " +
         std::to_string(path.Seed) + "), up to " + NumberText(path.MostDepth) +
         " mm deep, from all sides, made from the reference; the same for every setting. A "
         "tick\xE2\x80\x99s time is the minimum over " +
         std::to_string(result.Settings.Measurement.Runs) +
         " runs; the rate is the one that 99.9 % of ticks permit. Errors are those of the shape "
         "alone, without friction and damping. A just noticeable difference (JND) of force is 7 % "
         "of it, but at least that of 0.5 N, since small forces are harder to discriminate; that "
         "of its direction is 18\xC2\xB0 to 33\xC2\xB0, evaluated from 0.02 N on. A seizure: the "
         "position error exceeds the uncertainty by 2 mm. Parted: strokes on which the hand, which "
         "follows the reference, pressed the tool more than twice as deep as the path; errors, "
         "jumps and seizures leave them out. Beyond: errors beyond the reference\xE2\x80\x99s "
         "uncertainty, by which settings are judged. Cost: CPU time to prepare, to fit, and to "
         "touch for ten minutes.";
}
} // namespace

std::string TradePage(const TradeResult& result)
{
  ReportPage page;
  page.Header("trade-off", "Speed against accuracy", result.Machine);
  for (const TradeStructureResult& structure : result.Structures)
  {
    AddStructure(page, structure);
  }
  page.Section("Method").Text(HowItWasMeasured(result));
  return page.Whole("Palpate trade-off", result.Machine);
}

std::vector<std::size_t> ParetoFront(const std::vector<std::pair<double, double>>& points)
{
  std::vector<std::size_t> order;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    if (std::isfinite(points[p].first) && std::isfinite(points[p].second))
    {
      order.push_back(p);
    }
  }
  std::stable_sort(order.begin(), order.end(),
                   [&points](std::size_t a, std::size_t b) { return points[a] < points[b]; });
  std::vector<std::size_t> front;
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t p : order)
  {
    // Equal points do not dominate each other.
    if (points[p].second < least || (!front.empty() && points[p] == points[front.back()]))
    {
      front.push_back(p);
      least = points[p].second;
    }
  }
  return front;
}
} // namespace palpate
