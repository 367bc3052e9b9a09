#pragma once

#include "PalpateGroupModule.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// The row of each case in a table, by a column with ids. A row belongs to a case whose name is its
/// id, which has an id of `sub-` and its name (BIDS), or has its id as a whole part between
/// characters that are neither letters nor digits: 10005 to 10005_1000005; the longest one wins.
/// Of other cases, in this order and only where one row and cases of one number fit each other: a
/// row whose id is a file (masks/001.nii.gz to 001), and one whose id is the number of the first
/// part of digits of the name, as spreadsheets write numbers (1 or 1.0 to 001); notes say so.
class PALPATEGROUP_EXPORT MatchedRows
{
public:
  /// `source` names the table in messages, `column` its ids. Throws InputError if two rows fit a
  /// case equally.
  MatchedRows(std::vector<std::string> ids, const std::vector<std::string>& cases,
              std::string source, std::string column);

  /// One per case; none for a case without a row.
  const std::vector<std::optional<std::size_t>>& Rows() const { return this->Found; }
  const std::vector<std::string>& Notes() const { return this->Remarks; }

private:
  std::optional<std::size_t> RowOf(const std::string& name,
                                   const std::vector<std::string>& ids) const;
  void AddFiles(const std::vector<std::string>& cases);
  void AddNumbers(const std::vector<std::string>& cases);
  void AddNote(std::size_t count, const std::string& id, const std::string& name);

  std::vector<std::string> Ids;
  std::string Source;
  std::string Column;
  std::vector<std::optional<std::size_t>> Found;
  std::vector<std::string> Remarks;
};
} // namespace palpate
