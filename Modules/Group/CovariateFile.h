#pragma once

#include "Covariates.h"
#include "PalpateGroupModule.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// Reads a table of covariates (with a header; separated by commas, semicolons or tabs; with
/// semicolons, numbers may have decimal commas) and finds the row of each case, by the column `id`
/// or, if that is empty, by the first column named case, id, patient_id, participant_id, subject or
/// subject_id, else by the first column (MatchedRows). Text that is not UTF-8 is read by
/// TableAsUtf8, with a note; blanks at the ends of cells are dropped. Cases without a row have
/// missing values; a note says which. Throws InputError if the file is not such a table, two rows
/// fit a case equally, or no row fits any case.
PALPATEGROUP_EXPORT CovariateTable ReadCovariates(const std::filesystem::path& file,
                                                  const std::string& id,
                                                  const std::vector<std::string>& cases,
                                                  std::vector<std::string>& notes);
} // namespace palpate
