#pragma once

#include "FitResult.h"
#include "PalpateGroupModule.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// What became of one structure of one case, as cohort.csv keeps it.
struct CohortRow
{
  std::string Case;
  /// What of a fit the table holds: structure, outcome, sentence, volumes, distances to the mask,
  /// Dice, "total" seconds.
  FitResult Result;
  int Degree = 0;                        ///< of the model, whose coefficients are in its file
  Vector3 CenterWorld = Vector3::Zero(); ///< of the model, mm
  std::filesystem::path Model;           ///< relative to the table's folder; empty for none
  std::string Key;                       ///< of what it was made from, see CohortKey
};

/// Says all that a case's result follows from: its mask's and its volume's path, size and time, the
/// labels asked for, the settings, the program. 16 hexadecimal digits.
PALPATEGROUP_EXPORT std::string CohortKey(const std::filesystem::path& mask,
                                          const std::filesystem::path& volume,
                                          const std::vector<std::string>& labels,
                                          const FitSettings& settings, const std::string& program);

/// `cohort.csv`: a row a structure of a case. Numbers that are not known are empty.
class PALPATEGROUP_EXPORT CohortTable
{
public:
  /// An empty table where there is no such file. Throws InputError where the file is none of these.
  static CohortTable Read(const std::filesystem::path& file);
  /// All rows, under AtomicFile's rules: what was there stays until all of it is replaced. Throws
  /// InputError.
  void Write(const std::filesystem::path& file) const;

  const std::vector<CohortRow>& Rows() const { return this->Content; }
  /// The rows of a case, in their order.
  std::vector<CohortRow> RowsOf(const std::string& name) const;
  /// Puts rows at the end.
  void Add(const std::vector<CohortRow>& rows);

private:
  std::vector<CohortRow> Content;
};
} // namespace palpate
