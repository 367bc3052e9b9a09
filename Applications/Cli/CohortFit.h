#pragma once

#include "CohortManifest.h"
#include "CohortTable.h"
#include "ImageOptions.h"

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace palpate::cli
{
class Console;

/// Fits the cases of a folder or a manifest, each into a folder `CASE/LABEL_NAME`, and keeps
/// `cohort.csv`, which is replaced whole after every case: a run that is killed loses the case at
/// work, and the next one does only what is missing, what failed, and what was made from another
/// mask or by other settings. Runs into one folder at the same time keep each other's rows.
class CohortFit
{
public:
  /// `labels` are for cases whose manifest names none.
  CohortFit(const FitSettings& settings, const std::vector<std::string>& labels,
            const ImageOptions& images);
  void SetJson(bool json) { this->Json = json; }

  /// Every mask of the folders, and the files, as cases of their names. Throws InputError.
  void TakeMasks(const std::vector<std::string>& inputs);
  /// `inputs` is empty, or the one folder from which its paths go. Throws InputError.
  void TakeManifest(const std::string& manifest, const std::vector<std::string>& inputs);
  /// Only these, all for none; rows of others stay as they are. Throws InputError for a name that
  /// is none's.
  void ChooseCases(const std::vector<std::string>& names);

  /// Returns the exit code. Throws InputError where `output` cannot be written.
  int Run(const std::filesystem::path& output, Console& console);

private:
  /// Of what other runs have written, and of what this one has not done.
  void TakeRowsOfOthers();
  void ReadEarlierRows(bool isAlone);
  void WriteTable();
  std::vector<std::string> LabelsOf(const CohortCase& one) const;
  std::string KeyOf(const CohortCase& one) const;
  bool IsDone(const CohortCase& one) const;
  void RunCases(Console& console);
  /// Never throws for what is wrong with a case; throws Cancelled.
  std::vector<CohortRow> FitOne(std::size_t number, Console& console) const;
  CohortTable Table() const;
  void WriteOverview(const CohortTable& table, Console& console) const;
  int Conclude(Console& console);

  FitSettings Settings;
  std::vector<std::string> Labels;
  const ImageOptions& Images;
  bool Json = false;
  std::filesystem::path Output;
  std::vector<CohortCase> Cases;
  bool IsPart = false;             ///< of what is listed, only some
  std::vector<std::string> Listed; ///< the cases' names, of a part those of the whole
  std::vector<std::string> Order;  ///< of the table
  std::set<std::string> Mine;      ///< the cases that this run did or kept
  std::map<std::string, std::vector<CohortRow>> Rows;
};
} // namespace palpate::cli
