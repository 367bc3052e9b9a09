#include "TradeAdvice.h"

#include "DecimalText.h"
#include "InputError.h"
#include "LimitText.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <sstream>

namespace palpate
{
namespace
{
constexpr double Mega = 1e6;
constexpr double Micro = 1e-3; // us per ns

// A number that a row has and that is not to go beyond a bound.
struct Bound
{
  const char* Word;
  const char* Name; // in sentences
  const char* Unit;
  double (*Of)(const TradeRow&);
  std::optional<double> TradeNeeds::*Wanted;
  bool IsLeast = false; // else it is a most
};

const std::array<Bound, 5> Bounds{{
    {"rate", "rate", " Hz", [](const TradeRow& row) { return row.Rate; }, &TradeNeeds::Rate, true},
    {"error", "position error", " mm", [](const TradeRow& row) { return row.PositionRare; },
     &TradeNeeds::Error},
    {"force", "force error", " N", [](const TradeRow& row) { return row.ForceRare; },
     &TradeNeeds::Force},
    {"direction", "direction error", "\xC2\xB0",
     [](const TradeRow& row) { return row.DirectionRare; }, &TradeNeeds::Direction},
    {"memory", "memory", " MB", [](const TradeRow& row) { return row.Bytes / Mega; },
     &TradeNeeds::Memory},
}};

std::string Words()
{
  std::string words;
  for (const Bound& bound : Bounds)
  {
    words += (words.empty() ? "" : ", ") + std::string(bound.Word);
  }
  return words;
}

std::string RateText(double hertz)
{
  return hertz >= Mega  ? SignificantText(hertz / Mega, 2) + " MHz"
         : hertz >= 1e3 ? SignificantText(hertz / 1e3, 3) + " kHz"
                        : SignificantText(hertz, 3) + " Hz";
}

std::string Costs(const TradeRow& row)
{
  return SignificantText(Micro * row.TickMean, 2) + " \xC2\xB5s a tick (" + RateText(row.Rate) +
         " is in reach)";
}

// By what part a number misses its bound; 0 or less where it does not, and infinite where it is no
// number.
double MissOf(const TradeRow& row, const Bound& bound, double wanted)
{
  const double value = bound.Of(row);
  const double miss = bound.IsLeast ? wanted / value - 1.0 : value / wanted - 1.0;
  return std::isnan(miss) ? std::numeric_limits<double>::infinity() : miss;
}

double WorstMiss(const TradeRow& row, const TradeNeeds& needs)
{
  double worst = 0.0;
  for (const Bound& bound : Bounds)
  {
    if (needs.*bound.Wanted)
    {
      worst = std::max(worst, MissOf(row, bound, *(needs.*bound.Wanted)));
    }
  }
  return worst;
}

std::string MissesOf(const TradeRow& row, const TradeNeeds& needs)
{
  std::string text;
  for (const Bound& bound : Bounds)
  {
    if (needs.*bound.Wanted && MissOf(row, bound, *(needs.*bound.Wanted)) > 0.0)
    {
      const double value = bound.Of(row);
      const double wanted = *(needs.*bound.Wanted);
      text += (text.empty() ? "misses the " : " and the ") + std::string(bound.Name) + " by " +
              SignificantText(std::abs(value - wanted), 2) + bound.Unit + " (" +
              SignificantAgainstLimit(value, wanted, 3) + " instead of " +
              SignificantAgainstLimit(wanted, wanted, 3) + ")";
    }
  }
  return text;
}

std::string Wanted(const TradeNeeds& needs)
{
  std::string text;
  for (const Bound& bound : Bounds)
  {
    if (needs.*bound.Wanted)
    {
      const double wanted = *(needs.*bound.Wanted);
      text += (text.empty() ? "" : ", ") + std::string(bound.IsLeast ? "at least " : "at most ") +
              SignificantAgainstLimit(wanted, wanted, 4) + bound.Unit + " of " + bound.Name;
    }
  }
  return text;
}

using Places = std::vector<std::size_t>;

// "the cheapest of 7 settings", or "the only one of 20 settings".
std::string CheapestText(std::size_t meeting, std::size_t all)
{
  return meeting > 1 ? "the cheapest of " + std::to_string(meeting) + " settings"
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

TradeAdvice AdviseByNeeds(const std::vector<TradeRow>& rows, const Places& felt,
                          const TradeNeeds& needs)
{
  const Places meeting =
      Where(felt, [&](std::size_t r) { return WorstMiss(rows[r], needs) <= 0.0; });
  if (!meeting.empty())
  {
    const std::size_t best = CheapestOf(rows, meeting);
    return {best, true,
            "choose " + Describe(rows[best].Setting) + ": " + Costs(rows[best]) + ", " +
                CheapestText(meeting.size(), felt.size()) + " with " + Wanted(needs)};
  }
  const std::size_t nearest =
      *std::min_element(felt.begin(), felt.end(),
                        [&](std::size_t a, std::size_t b)
                        { return WorstMiss(rows[a], needs) < WorstMiss(rows[b], needs); });
  return {nearest, false,
          "none of " + std::to_string(felt.size()) + " settings has " + Wanted(needs) +
              "; the nearest is " + Describe(rows[nearest].Setting) + ", which " +
              MissesOf(rows[nearest], needs)};
}

std::string Errors(const TradeRow& row)
{
  return SignificantText(row.NoticeableRare, 2) + " just noticeable differences of force and " +
         SignificantText(row.DirectionRare, 2) + "\xC2\xB0 (99 %), " +
         SignificantText(row.PositionRare, 2) + " mm";
}

TradeAdvice AdviseByThresholds(const std::vector<TradeRow>& rows, const Places& felt,
                               double servoRate)
{
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
            "choose " + Describe(rows[best].Setting) + ": " + Costs(rows[best]) + ", " +
                CheapestText(good.size(), felt.size()) +
                " whose errors no hand notices: " + Errors(rows[best])};
  }
  if (fast.empty())
  {
    const std::size_t best = CheapestOf(rows, felt);
    return {best, false,
            "no setting keeps " + RateText(servoRate) + " on this machine; the cheapest is " +
                Describe(rows[best].Setting) + ": " + Costs(rows[best])};
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
  return {best, false,
          "choose " + Describe(rows[best].Setting) + ": " + Costs(rows[best]) +
              "; a hand may notice every setting's errors, and this is about the truest: " +
              Errors(rows[best])};
}
} // namespace

TradeNeeds ParseNeeds(const std::string& text)
{
  const auto require = [&text](bool isRight, const std::string& fact)
  {
    if (!isRight)
    {
      throw InputError("--require " + text + ": " + fact);
    }
  };
  TradeNeeds needs;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');)
  {
    const std::size_t sign = part.find('=');
    const std::string word = part.substr(0, sign);
    const auto* const bound = std::find_if(Bounds.begin(), Bounds.end(),
                                           [&word](const Bound& one) { return word == one.Word; });
    require(bound != Bounds.end(),
            "\"" + word + "\" is nothing that can be required; name any of " + Words());
    const auto number =
        sign == std::string::npos ? std::nullopt : ParseNumber(part.substr(sign + 1));
    require(number && *number > 0.0,
            word + " has no positive number; write for instance rate=1000");
    require(!(needs.*bound->Wanted), word + " is named twice; name it once");
    needs.*bound->Wanted = number;
  }
  require(!text.empty() && text.back() != ',', "it ends with nothing; name any of " + Words());
  return needs;
}

TradeAdvice AdviseOn(const std::vector<TradeRow>& rows, const std::optional<TradeNeeds>& needs,
                     double servoRate)
{
  Places felt;
  for (std::size_t r = 0; r < rows.size(); ++r)
  {
    // What is no number has not been measured.
    if (rows[r].IsFelt() && std::isfinite(rows[r].TickMean) && std::isfinite(rows[r].PositionRare))
    {
      felt.push_back(r);
    }
  }
  if (felt.empty())
  {
    return {std::nullopt, false, "nothing could be measured"};
  }
  return needs ? AdviseByNeeds(rows, felt, *needs) : AdviseByThresholds(rows, felt, servoRate);
}
} // namespace palpate
