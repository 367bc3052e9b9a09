#pragma once

#include "FitResult.h"
#include "PalpateGroupModule.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// Result of one structure of one case, as stored in cohort.csv.
struct CohortRow
{
  std::string Case;
  /// The part of a fit that the table holds: structure, outcome, message, volumes, distances to the
  /// mask, Dice, "total" seconds.
  FitResult Result;
  int Degree = 0;                        ///< of the model, whose coefficients are in its file
  Vector3 CenterWorld = Vector3::Zero(); ///< of the model, mm
  std::filesystem::path Model;           ///< relative to the table's folder; empty for none
  std::string Key;                       ///< of its inputs, see CohortKey
};

/// A row without a file of its model and without a key; meshes of a whole cohort would fill the
/// memory, and are dropped.
PALPATEGROUP_EXPORT CohortRow RowOf(const std::string& name, FitResult result);

/// Identifies everything that a case's result depends on: its mask's and its volume's path, size
/// and time, the requested labels, the settings, the program. 16 hexadecimal digits.
PALPATEGROUP_EXPORT std::string CohortKey(const std::filesystem::path& mask,
                                          const std::filesystem::path& volume,
                                          const std::vector<std::string>& labels,
                                          const FitSettings& settings, const std::string& program);

/// `cohort.csv`: one row per structure of a case. Unknown numbers are empty.
class PALPATEGROUP_EXPORT CohortTable
{
public:
  /// An empty table if there is no such file. Throws InputError if the file is not a cohort table.
  static CohortTable Read(const std::filesystem::path& file);
  /// Writes all rows, under AtomicFile's rules: the old file remains until it is replaced as a
  /// whole. Throws InputError.
  void Write(const std::filesystem::path& file) const;

  const std::vector<CohortRow>& Rows() const { return this->Content; }
  void Add(const std::vector<CohortRow>& rows);

private:
  std::vector<CohortRow> Content;
};
} // namespace palpate
