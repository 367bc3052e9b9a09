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

using Places = std::vector<std::size_t>;

template <typename Condition>
Places Where(const Places& places, const Condition& condition)
{
  Places chosen;
  std::copy_if(places.begin(), places.end(), std::back_inserter(chosen), condition);
  return chosen;
}

// The place of the least number; NaN counts as infinity.
template <typename Number>
std::size_t LeastOf(const Places& places, const Number& number)
{
  const auto size = [&number](std::size_t r)
  {
    const double value = number(r);
    return std::isnan(value) ? std::numeric_limits<double>::infinity() : value;
  };
  return *std::min_element(places.begin(), places.end(),
                           [&size](std::size_t a, std::size_t b) { return size(a) < size(b); });
}

// The advice on the rows of one structure.
class Judgement
{
public:
  Judgement(const std::vector<TradeRow>& rows, double servoRate) : Rows(rows), Rate(servoRate)
  {
    for (std::size_t r = 0; r < rows.size(); ++r)
    {
      // NaN: not measured.
      const double error =
          rows[r].Yields ? rows[r].BeyondNoticeableRare : rows[r].BeyondPositionRare;
      if (rows[r].IsFelt() && std::isfinite(rows[r].TickMean) && std::isfinite(error))
      {
        this->Felt.push_back(r);
      }
    }
  }

  TradeAdvice Advise() const
  {
    if (this->Felt.empty())
    {
      return {std::nullopt, false, "no setting could be measured"};
    }
    const Places fast =
        Where(this->Felt, [this](std::size_t r) { return this->Rows[r].Rate >= this->Rate; });
    if (fast.empty())
    {
      const std::size_t best =
          LeastOf(this->Felt, [this](std::size_t r) { return this->Rows[r].TickMean; });
      return {best, false,
              "no setting keeps " + RateText(this->Rate) + " on this machine; the fastest is " +
                  this->Costs(best)};
    }
    const Places good = Where(fast, [this](std::size_t r) { return this->IsGood(r); });
    return good.empty() ? this->AdviseOnPoor(fast) : this->AdviseOnGood(fast);
  }

private:
  bool IsSteady(std::size_t r) const
  {
    const TradeRow& row = this->Rows[r];
    return row.BeyondDirectionRare < TradeThresholds::NoticeableDegrees && row.Seizures == 0.0;
  }
  bool IsGood(std::size_t r) const
  {
    return this->IsSteady(r) && this->Rows[r].BeyondNoticeableRare < 1.0;
  }
  // Whether the errors of two, beyond twice the standard deviation, differ by less than one; false
  // if there is no uncertainty.
  bool IsLike(std::size_t r, std::size_t truest) const
  {
    return this->Rows[r].BeyondPositionRare - this->Rows[truest].BeyondPositionRare <
           0.5 * this->Rows[truest].UncertaintyMean;
  }

  TradeAdvice AdviseOnGood(const Places& fast) const
  {
    const std::size_t truest =
        LeastOf(fast, [this](std::size_t r) { return this->Rows[r].BeyondPositionRare; });
    const Places equal =
        Where(fast,
              [&](std::size_t r)
              {
                return this->IsGood(r) ||
                       (this->IsGood(truest) && this->IsSteady(r) && this->IsLike(r, truest));
              });
    const std::size_t best = this->CheapestOfSmooth(equal);
    const std::string why =
        equal.size() > 1
            ? "the errors of " + std::to_string(equal.size()) + " of " +
                  std::to_string(this->Felt.size()) +
                  " settings are not noticeable, or differ by less than the uncertainty, and "
                  "count as equal; " +
                  this->Reason(equal, best)
            : "the only one of " + std::to_string(this->Felt.size()) +
                  " settings whose errors are not noticeable";
    return {best, true, "choose " + this->Costs(best) + "; " + why + ": " + this->Errors(best)};
  }

  TradeAdvice AdviseOnPoor(const Places& fast) const
  {
    constexpr double About = 1.1;
    const auto error = [this](std::size_t r) { return this->Rows[r].BeyondNoticeableRare; };
    const std::size_t truest = LeastOf(fast, error);
    const Places equal = Where(
        fast, [&](std::size_t r)
        { return r == truest || error(r) <= About * error(truest) || this->IsLike(r, truest); });
    const std::size_t best = this->CheapestOfSmooth(equal);
    const std::string those = fast.size() == this->Felt.size()
                                  ? "every setting"
                                  : "every setting that keeps " + RateText(this->Rate);
    const std::string why = equal.size() > 1 ? std::to_string(equal.size()) +
                                                   " are the most accurate and count as equal; " +
                                                   this->Reason(equal, best)
                                             : "this one is the most accurate of them";
    return {best, false,
            "choose " + this->Costs(best) + "; the errors of " + those +
                " may be noticeable, and " + why + ": " + this->Errors(best)};
  }

  // Times vary by as much from run to run.
  static constexpr double AboutAsCheap = 1.25;

  // N, by which the force jumps more than that of the reference.
  double Jump(std::size_t r) const
  {
    const TradeRow& row = this->Rows[r];
    return std::max(0.0, row.JumpMost - row.IdealJumpMost);
  }
  double Cost(std::size_t r) const { return this->Rows[r].CostSeconds; }

  Places SmoothOf(const Places& equal) const
  {
    const double least =
        this->Jump(LeastOf(equal, [this](std::size_t r) { return this->Jump(r); }));
    return Where(equal, [&](std::size_t r)
                 { return this->Jump(r) - least <= TradeThresholds::JustNoticeable(0.0); });
  }
  std::size_t CheapestOfSmooth(const Places& equal) const
  {
    const Places smooth = this->SmoothOf(equal);
    const auto cost = [this](std::size_t r) { return this->Cost(r); };
    const std::size_t cheapest = LeastOf(smooth, cost);
    const Places cheap =
        Where(smooth, [&](std::size_t r)
              { return r == cheapest || cost(r) <= AboutAsCheap * cost(cheapest); });
    return LeastOf(cheap, [this](std::size_t r) { return this->Rows[r].BeyondNoticeableRare; });
  }
  // What decided between settings with equal errors.
  std::string Reason(const Places& equal, std::size_t best) const
  {
    const std::size_t smooth = this->SmoothOf(equal).size();
    const std::string left = smooth < equal.size()
                                 ? "of the " + std::to_string(smooth) + " whose force jumps least, "
                                 : "their forces jump equally, and ";
    return smooth == 1 ? "the force of this one jumps least"
                       : left + "this one costs least, " + SignificantText(this->Cost(best), 2) +
                             " s to prepare and to touch for ten minutes";
  }
  std::string Costs(std::size_t r) const
  {
    const TradeRow& row = this->Rows[r];
    return Describe(row) + ": " + SignificantText(MicrosecondsPerNanosecond * row.TickMean, 2) +
           " \xC2\xB5s per tick (up to " + RateText(row.Rate) + ")";
  }

  std::string Errors(std::size_t r) const
  {
    const TradeRow& row = this->Rows[r];
    return SignificantText(row.BeyondNoticeableRare, 2) +
           " just noticeable differences of force and " +
           SignificantText(row.BeyondDirectionRare, 2) + "\xC2\xB0 (99 %)" +
           (row.Yields ? std::string()
                       : ", " + SignificantText(row.BeyondPositionRare, 2) + " mm") +
           (row.UncertaintyMean > 0.0 ? " beyond the reference's uncertainty of " +
                                            SignificantText(row.UncertaintyMean, 2) + " mm"
                                      : std::string());
  }

  const std::vector<TradeRow>& Rows;
  double Rate; // Hz
  Places Felt;
};
} // namespace

TradeAdvice AdviseOn(const std::vector<TradeRow>& rows, double servoRate)
{
  return Judgement(rows, servoRate).Advise();
}
} // namespace palpate
