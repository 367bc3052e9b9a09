#include "TradeAdvice.h"

#include "DecimalText.h"
#include "Units.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr double HertzPerMegahertz = 1e6;

std::string RateText(double hertz)
{
  return hertz >= HertzPerMegahertz ? SignificantText(hertz / HertzPerMegahertz, 2) + " MHz"
         : hertz >= 1e3             ? SignificantText(hertz / 1e3, 3) + " kHz"
                                    : SignificantText(hertz, 3) + " Hz";
}

std::string Costs(const TradeRow& row)
{
  return SignificantText(MicrosecondsPerNanosecond * row.TickMean, 2) +
         " \xC2\xB5s per tick (up to " + RateText(row.Rate) + ")";
}

using Places = std::vector<std::size_t>;

// "the fastest of 7 settings", or "the only one of 20 settings".
std::string CheapestText(std::size_t meeting, std::size_t all)
{
  return meeting > 1 ? "the fastest of " + std::to_string(meeting) + " settings"
                     : "the only one of " + std::to_string(all) + " settings";
}

std::size_t CheapestOf(const std::vector<TradeRow>& rows, const Places& places)
{
  return *std::min_element(places.begin(), places.end(),
                           [&rows](std::size_t a, std::size_t b)
                           { return rows[a].TickMean < rows[b].TickMean; });
}

template <typename Condition>
Places Where(const Places& places, const Condition& condition)
{
  Places chosen;
  std::copy_if(places.begin(), places.end(), std::back_inserter(chosen), condition);
  return chosen;
}

std::string Errors(const TradeRow& row)
{
  return SignificantText(row.NoticeableRare, 2) + " just noticeable differences of force and " +
         SignificantText(row.DirectionRare, 2) + "\xC2\xB0 (99 %)" +
         (row.Yields ? std::string() : ", " + SignificantText(row.PositionRare, 2) + " mm");
}
} // namespace

TradeAdvice AdviseOn(const std::vector<TradeRow>& rows, double servoRate)
{
  Places felt;
  for (std::size_t r = 0; r < rows.size(); ++r)
  {
    // NaN: not measured.
    const double error = rows[r].Yields ? rows[r].NoticeableRare : rows[r].PositionRare;
    if (rows[r].IsFelt() && std::isfinite(rows[r].TickMean) && std::isfinite(error))
    {
      felt.push_back(r);
    }
  }
  if (felt.empty())
  {
    return {std::nullopt, false, "no setting could be measured"};
  }
  const auto isFast = [&](std::size_t r) { return rows[r].Rate >= servoRate; };
  const auto isTrue = [&](std::size_t r)
  {
    return rows[r].NoticeableRare < 1.0 &&
           rows[r].DirectionRare < TradeThresholds::NoticeableDegrees && rows[r].Seizures == 0.0;
  };
  const Places fast = Where(felt, isFast);
  const Places good = Where(fast, isTrue);
  if (!good.empty())
  {
    const std::size_t best = CheapestOf(rows, good);
    return {best, true,
            "choose " + Describe(rows[best]) + ": " + Costs(rows[best]) + ", " +
                CheapestText(good.size(), felt.size()) +
                " whose errors are not noticeable: " + Errors(rows[best])};
  }
  if (fast.empty())
  {
    const std::size_t best = CheapestOf(rows, felt);
    return {best, false,
            "no setting keeps " + RateText(servoRate) + " on this machine; the fastest is " +
                Describe(rows[best]) + ": " + Costs(rows[best])};
  }
  constexpr double About = 1.1;
  const auto error = [&](std::size_t r)
  {
    const double noticeable = rows[r].NoticeableRare;
    return std::isnan(noticeable) ? std::numeric_limits<double>::infinity() : noticeable;
  };
  const std::size_t truest = *std::min_element(
      fast.begin(), fast.end(), [&](std::size_t a, std::size_t b) { return error(a) < error(b); });
  const std::size_t best = CheapestOf(
      rows, Where(fast, [&](std::size_t r) { return error(r) <= About * error(truest); }));
  const std::string those = fast.size() == felt.size()
                                ? "every setting"
                                : "every setting that keeps " + RateText(servoRate);
  return {best, false,
          "choose " + Describe(rows[best]) + ": " + Costs(rows[best]) + "; the errors of " + those +
              " may be noticeable, and this one is among the most accurate of them: " +
              Errors(rows[best])};
}
} // namespace palpate
