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
/// `cohort.csv`, which is replaced whole after every case: a killed run loses only its current
/// case, and the next one fits only missing and failed cases and those with another mask or other
/// settings. Concurrent runs into one folder keep each other's rows, as do the processes of one
/// run.
class CohortFit
{
public:
  /// `labels` are for cases whose manifest names none.
  CohortFit(const FitSettings& settings, const std::vector<std::string>& labels,
            const ImageOptions& images);
  void SetJson(bool json) { this->Json = json; }
  /// Cases at a time, each in a process of its own; 1: in this one.
  void SetJobs(unsigned jobs) { this->Jobs = jobs; }

  /// Adds every mask of the folders, and the files, as cases named after them, or those of a
  /// pattern (FindPatternCases). Throws InputError.
  void TakeMasks(const std::vector<std::string>& inputs);
  /// `inputs` is empty, or the one folder to which its paths are relative. Throws InputError.
  void TakeManifest(const std::string& manifest, const std::vector<std::string>& inputs);
  /// Selects these cases (empty: all); rows of others are not changed. Throws InputError for an
  /// unknown name.
  void ChooseCases(const std::vector<std::string>& names);

  /// Returns the exit code. Throws InputError if `output` cannot be written.
  int Run(const std::filesystem::path& output, Console& console);

private:
  void TakePattern(const std::vector<std::string>& inputs);
  void ListCases();
  /// Reads the rows of other runs, and of the cases that this one has not done.
  void TakeRowsOfOthers();
  void ReadEarlierRows(bool isAlone);
  void WriteTable();
  std::vector<std::string> LabelsOf(const CohortCase& one) const;
  std::string KeyOf(const CohortCase& one) const;
  bool IsDone(const CohortCase& one) const;
  void RunCases(Console& console);
  /// Fits a case and writes its rows into the table.
  void RunCase(std::size_t number, Console& console);
  /// Writes a row for a case whose process died.
  void RecordLost(const CohortCase& one, const std::string& reason, Console& console);
  /// Does not throw for errors of a case; throws Cancelled.
  std::vector<CohortRow> FitOne(std::size_t number, Console& console) const;
  CohortTable Table() const;
  void WriteOverview(const CohortTable& table, Console& console) const;
  int Conclude(Console& console);

  FitSettings Settings;
  std::vector<std::string> Labels;
  const ImageOptions& Images;
  bool Json = false;
  unsigned Jobs = 1;
  std::filesystem::path Output;
  std::vector<CohortCase> Cases;
  bool IsPart = false;             ///< only some of the listed cases
  std::vector<std::string> Listed; ///< all cases' names, also of a part
  std::vector<std::string> Order;  ///< of the table
  std::set<std::string> Mine;      ///< the cases that this run fitted or kept
  std::map<std::string, std::vector<CohortRow>> Rows;
};
} // namespace palpate::cli
