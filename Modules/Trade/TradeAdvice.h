#pragma once

#include "PalpateTradeModule.h"
#include "TradeRow.h"

#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// What somebody needs of a setting; what is not given is not needed.
struct TradeNeeds
{
  std::optional<double> Rate;      ///< Hz, at least
  std::optional<double> Error;     ///< mm of position, 99 % at most
  std::optional<double> Force;     ///< N of force error, 99 % at most
  std::optional<double> Direction; ///< degrees, 99 % at most
  std::optional<double> Memory;    ///< MB (a million bytes), at most
};

/// Reads "rate=1000,error=0.2,force=0.1,direction=18,memory=10", any of them. Throws InputError.
PALPATETRADE_EXPORT TradeNeeds ParseNeeds(const std::string& text);

/// What to choose of one structure's rows.
struct TradeAdvice
{
  std::optional<std::size_t> Row; ///< none where no setting was measured
  bool IsMet = false;             ///< whether it has all that is needed
  std::string Sentence;           ///< what to choose, and why; or what misses and by how much
};

/// The cheapest setting, by its mean tick, that meets `needs`; else the one that misses by the
/// least part. Without needs: of those whose model is asked in every tick, the cheapest that
/// reaches `servoRate` (Hz), whose 99 % force error is below one just noticeable difference and 99
/// % direction error below 18 degrees, without seizures; else the cheapest of those that are about
/// the truest.
PALPATETRADE_EXPORT TradeAdvice AdviseOn(const std::vector<TradeRow>& rows,
                                         const std::optional<TradeNeeds>& needs, double servoRate);
} // namespace palpate
