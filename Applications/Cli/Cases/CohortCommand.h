#pragma once

#include "CohortAlignment.h"
#include "CohortAsymmetry.h"
#include "Command.h"
#include "CovariateModel.h"
#include "FitOptions.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace palpate::cli
{
/// `palpate cohort OUT...`: mean and variation of the cases that `fit` wrote. Separate from `fit`,
/// so that other axes or another structure need no new fit, and cases fitted on several machines
/// can be joined.
class CohortCommand : public Command
{
public:
  std::string Name() const override { return "cohort"; }
  std::string Summary() const override
  {
    return "Mean shape, principal modes and tables of fitted cases";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  void DeclareAlignment(CLI::App& app);
  void DeclareCovariates(CLI::App& app);
  /// The folder to write.
  std::filesystem::path Output() const
  {
    return this->OutputFolder.empty() ? this->Folders.front() : this->OutputFolder;
  }
  void CheckOutputs() const;
  int FitMasks(Console& console) const;
  /// Of --asymmetry by columns; right sides become their mirror images.
  std::vector<SidePair> PairSides(CohortGroup& group, std::vector<std::string>& notes) const;
  std::optional<CohortAlignment> Align(CohortGroup& group, const KernelProgress& progress) const;
  /// Exports, the synthesised shape, and the table of joined cohorts.
  void WriteOthers(const CohortGroup& group, const CohortTable& table, Console& console) const;
  void Print(const CohortGroup& group, const std::vector<std::string>& notes,
             const CovariateModel& model, const std::string& asymmetry, Console& console) const;

  std::vector<std::string> Folders;
  std::string Masks;
  std::vector<std::string> Exports;
  FitOptions Options;
  std::string OutputFolder;
  std::string Label;
  std::string Axes = "patient";
  bool ScalesShapes = false;
  bool MovesParameters = false;
  std::string Reference;
  bool ShowsNames = false;
  bool IsAnonymous = false;
  std::string Shape;
  std::string Prior;
  std::string Known;
  CovariateRequest Request;
  std::vector<std::string> Sides; ///< midline, or the columns of patient and side
};
} // namespace palpate::cli
