#include "ComparisonOverview.h"

#include "ComparisonFiles.h"
#include "ComparisonNames.h"
#include "DecimalText.h"
#include "ReportPage.h"
#include "ReportTable.h"
#include "ReportVerdict.h"
#include "SvgChart.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

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

ReportTable SummaryTable(const std::vector<PairComparison>& pairs)
{
  ReportTable table({"", "mean", "median", "least", "largest"});
  for (const SummarisedNumber& one : SummariseComparisons(pairs))
  {
    table.Text(one.Name + (one.Unit.empty() ? "" : ", " + one.Unit))
        .Number(one.Summary.Mean, one.Digits)
        .Number(one.Summary.Median, one.Digits)
        .Number(one.Summary.Least, one.Digits)
        .Number(one.Summary.Largest, one.Digits);
  }
  return table;
}

// Volumes, shifts and what turn and shift leave, over time.
void AddTimes(ReportPage& page, const std::vector<PairComparison>& pairs)
{
  std::map<int, std::array<SvgChart::Points, 3>> structures;
  for (const PairComparison& pair : pairs)
  {
    if (pair.IsCompared() && pair.Time && pair.Motion)
    {
      auto& [volumes, shifts, rests] = structures[pair.One.Structure.Label];
      volumes.emplace_back(*pair.Time, pair.One.Milliliters);
      shifts.emplace_back(*pair.Time, pair.Motion->Shift.norm());
      rests.emplace_back(*pair.Time, pair.Motion->Rest);
    }
  }
  const std::array<const char*, 3> axes{"volume, ml", "shift from the first, mm",
                                        "rest after turn and shift, mm"};
  for (const auto& [label, lines] : structures)
  {
    page.Section("Label " + std::to_string(label) + " over time");
    for (std::size_t k = 0; k < axes.size(); ++k)
    {
      SvgChart chart("time", axes[k]);
      chart.SetLine(lines[k]);
      page.Chart(chart, "");
    }
  }
}

ReportTable PairTable(const std::vector<PairComparison>& pairs)
{
  ReportTable table({"Case", "Label", "Dice", "Mean, mm", "95 % Hausdorff, mm", "Hausdorff, mm",
                     "Signed mean, mm", "Volume, ml", "Reference, ml"},
                    true);
  for (const PairComparison& pair : pairs)
  {
    if (pair.IsCompared())
    {
      const int label = pair.One.Structure.Label;
      table.Link(pair.Case, PairFolder(pair) / "report.html")
          .Value(label == 0 ? "" : std::to_string(label))
          .Number(DiceOf(pair), 4)
          .Number(pair.Numbers.Both.Mean, 3)
          .Number(pair.Numbers.Hausdorff95(), 3)
          .Number(pair.Numbers.Both.Largest, 3)
          .Number(pair.Numbers.OneToOther.SignedMean, 3)
          .Number(pair.One.Milliliters, 2)
          .Number(pair.Other.Milliliters, 2);
    }
  }
  return table;
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
  ReportPage page;
  page.Header("comparisons", CountText(static_cast<std::int64_t>(compared), "pair", "pairs"))
      .Section("Summary")
      .Table(SummaryTable(pairs));
  AddTimes(page, pairs);
  page.Section("Pairs").Table(PairTable(pairs));
  page.Section("Not compared").Notes(lost).Section("Without a partner").Notes(unpaired);
  return page.Whole("Palpate comparisons");
}
} // namespace palpate
