#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"
#include "ReportTable.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// One self-contained HTML page with a row for every case: verdict, key numbers, and a link to the
/// single report. A click on a column's header sorts by it. Results are not kept.
class PALPATEFIT_EXPORT ReportIndex
{
public:
  ReportIndex();

  /// `degree` is the model's (a cohort's rows keep no models); `report` is the case's own page,
  /// relative to the folder of the index; empty for none.
  void Add(const FitResult& result, int degree, const std::filesystem::path& report);

  /// Throws InputError if the file cannot be written.
  void Write(const std::filesystem::path& html) const;

private:
  int CaseCount = 0;
  int FittedCount = 0;
  ReportTable Table;
  std::vector<std::string> Messages; ///< of the cases that were not fitted
};
} // namespace palpate
