#include "ComparisonOverview.h"

#include "ComparisonFiles.h"
#include "ComparisonNames.h"
#include "DecimalText.h"
#include "HtmlText.h"
#include "ReportPage.h"
#include "ReportVerdict.h"
#include "SortableTable.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
std::vector<double> Of(const std::vector<PairComparison>& pairs,
                       double (*number)(const PairComparison&))
{
  std::vector<double> numbers;
  for (const PairComparison& pair : pairs)
  {
    if (pair.IsCompared())
    {
      numbers.push_back(number(pair));
    }
  }
  return numbers;
}

double DiceOf(const PairComparison& pair)
{
  return pair.Numbers.Overlap ? pair.Numbers.Overlap->Dice()
                              : std::numeric_limits<double>::quiet_NaN();
}

std::string SummaryTable(const std::vector<PairComparison>& pairs)
{
  std::string rows;
  for (const SummarisedNumber& one : SummariseComparisons(pairs))
  {
    rows += "<tr><th scope=\"row\">" +
            EscapeHtml(one.Name + (one.Unit.empty() ? "" : ", " + one.Unit)) + "</th>";
    for (const double number :
         {one.Summary.Mean, one.Summary.Median, one.Summary.Least, one.Summary.Largest})
    {
      rows += "<td>" + FixedText(number, one.Digits) + "</td>";
    }
    rows += "</tr>\n";
  }
  return "<div class=\"tables\"><table><thead><tr><th></th><th>mean</th><th>median</th>"
         "<th>least</th><th>largest</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>\n";
}

std::string PairTable(const std::vector<PairComparison>& pairs)
{
  SortableTable table({{"Case", "text"},
                       {"Label", "number"},
                       {"Dice", "number"},
                       {"Mean, mm", "number"},
                       {"95 % Hausdorff, mm", "number"},
                       {"Hausdorff, mm", "number"},
                       {"Signed mean, mm", "number"},
                       {"Volume, ml", "number"},
                       {"Reference, ml", "number"}});
  for (const PairComparison& pair : pairs)
  {
    if (!pair.IsCompared())
    {
      continue;
    }
    table.AddLink(pair.Case, PairFolder(pair) / "report.html");
    table.AddText(pair.One.Structure.Label == 0 ? "" : std::to_string(pair.One.Structure.Label));
    table.AddNumber(DiceOf(pair), 4);
    table.AddNumber(pair.Numbers.Both.Mean, 3);
    table.AddNumber(pair.Numbers.Hausdorff95(), 3);
    table.AddNumber(pair.Numbers.Both.Largest, 3);
    table.AddNumber(pair.Numbers.OneToOther.SignedMean, 3);
    table.AddNumber(pair.One.Milliliters, 2);
    table.AddNumber(pair.Other.Milliliters, 2);
  }
  return table.Html();
}
} // namespace

NumberSummary NumberSummary::Of(std::vector<double> numbers)
{
  constexpr double None = std::numeric_limits<double>::quiet_NaN();
  numbers.erase(std::remove_if(numbers.begin(), numbers.end(),
                               [](double number) { return !std::isfinite(number); }),
                numbers.end());
  if (numbers.empty())
  {
    return {0, None, None, None, None};
  }
  std::sort(numbers.begin(), numbers.end());
  NumberSummary summary;
  summary.Count = numbers.size();
  for (const double number : numbers)
  {
    summary.Mean += number / static_cast<double>(numbers.size());
  }
  summary.Median = 0.5 * (numbers[(numbers.size() - 1) / 2] + numbers[numbers.size() / 2]);
  summary.Least = numbers.front();
  summary.Largest = numbers.back();
  return summary;
}

std::vector<SummarisedNumber> SummariseComparisons(const std::vector<PairComparison>& pairs)
{
  const auto summary = [&](double (*number)(const PairComparison&))
  { return NumberSummary::Of(Of(pairs, number)); };
  std::vector<SummarisedNumber> all{
      {"Dice", "", 4, summary(DiceOf)},
      {"mean distance", "mm", 3,
       summary([](const PairComparison& pair) { return pair.Numbers.Both.Mean; })},
      {"95 % Hausdorff distance", "mm", 3,
       summary([](const PairComparison& pair) { return pair.Numbers.Hausdorff95(); })},
      {"signed mean distance", "mm", 3,
       summary([](const PairComparison& pair) { return pair.Numbers.OneToOther.SignedMean; })},
      {"volume difference", "%", 2,
       summary([](const PairComparison& pair) { return pair.VolumeDifferencePercent(); })}};
  const auto compared = std::find_if(pairs.begin(), pairs.end(),
                                     [](const PairComparison& pair) { return pair.IsCompared(); });
  const std::size_t tolerances = compared != pairs.end() ? compared->Numbers.Tolerances.size() : 0;
  for (std::size_t t = 0; t < tolerances; ++t)
  {
    std::vector<double> numbers;
    for (const PairComparison& pair : pairs)
    {
      if (pair.IsCompared())
      {
        numbers.push_back(pair.Numbers.Tolerances[t].SurfaceDice);
      }
    }
    all.push_back(
        {"surface Dice at " + ToleranceText(compared->Numbers.Tolerances[t].Millimeters) + " mm",
         "", 4, NumberSummary::Of(std::move(numbers))});
  }
  return all;
}

std::string ComparisonOverview(const std::vector<PairComparison>& pairs,
                               const std::vector<std::string>& unpaired)
{
  std::vector<std::string> lost;
  for (const PairComparison& pair : pairs)
  {
    if (!pair.IsCompared())
    {
      lost.push_back(pair.Case + ": " +
                     SharedText(pair.Other.File, SharedText(pair.One.File, pair.Message)));
    }
  }
  const std::size_t compared = pairs.size() - lost.size();
  return ReportPage("Palpate comparisons",
                    "<header>\n<div class=\"kicker\">Palpate \xC2\xB7 comparisons</div>\n<h1>" +
                        CountText(static_cast<std::int64_t>(compared), "pair", "pairs") +
                        "</h1>\n</header>\n" + ReportSection("Summary", SummaryTable(pairs)) +
                        ReportSection("Pairs", PairTable(pairs)) +
                        ReportSection("Not compared", ReportNotes(lost)) +
                        ReportSection("Without a partner", ReportNotes(unpaired)) + ReportFooter());
}
} // namespace palpate
