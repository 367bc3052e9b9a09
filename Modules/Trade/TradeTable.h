#pragma once

#include "PalpateTradeModule.h"
#include "TradeRow.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// A number of a row and how files call it; the name ends with the unit.
struct TradeColumn
{
  const char* Name;
  double TradeRow::*Number;
};

/// Every number of a row, in the order of files.
PALPATETRADE_EXPORT const std::vector<TradeColumn>& TradeColumns();

/// `tradeoff.csv`: a row a setting of a structure. Numbers that were not measured are empty.
class PALPATETRADE_EXPORT TradeTable
{
public:
  /// An empty table where there is no such file. Throws InputError where the file is none of these.
  static TradeTable Read(const std::filesystem::path& file);
  /// All rows, under AtomicFile's rules: what was there stays until all of it is replaced. Throws
  /// InputError.
  void Write(const std::filesystem::path& file) const;

  const std::vector<TradeRow>& Rows() const { return this->Content; }
  /// The row that follows from the same; null where there is none.
  const TradeRow* Find(const std::string& key) const;
  void Add(TradeRow row) { this->Content.push_back(std::move(row)); }

private:
  std::vector<TradeRow> Content;
};
} // namespace palpate
