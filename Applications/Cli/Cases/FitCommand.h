#pragma once

#include "CaseNames.h"
#include "CaseTally.h"
#include "Command.h"
#include "FitOptions.h"
#include "FitResult.h"
#include "ImageOptions.h"
#include "MaskFolder.h"
#include "ReportIndex.h"

#include <optional>
#include <string>
#include <vector>

namespace palpate::cli
{
/// `palpate fit MASK...`: a model, its quality and a report for every structure asked for. A case
/// that fails does not stop the others. CohortFit runs folders and manifests.
class FitCommand : public Command
{
public:
  std::string Name() const override { return "fit"; }
  std::string Summary() const override
  {
    return "Turn structures of segmentations into spherical-harmonic models";
  }
  std::string Examples() const override;
  void DeclareOptions(CLI::App& app) override;
  int Run(Console& console) override;

private:
  /// Whether the input is a folder or a manifest: its cases are kept in a table, which a later run
  /// resumes.
  bool IsCohort() const;
  bool MayBeStructures() const;
  void ReadFolder(Console& console);
  void TellTaken(Console& console) const;
  int RunCohort(Console& console) const;
  /// Does not throw for errors of one file.
  void FitFile(std::size_t file, const Volume* volume, Console& console);
  bool WriteIndex(Console& console) const;
  int Conclude(Console& console) const;

  std::vector<std::string> Inputs;
  std::string Manifest;
  std::vector<std::string> Cases;
  std::string As;
  FitOptions Options;
  std::string VolumePath;
  ImageOptions Images;
  std::string OutputFolder;
  bool Json = false;
  unsigned Jobs = 0; ///< 0: one a processor

  FitSettings Settings;
  CaseNames Names;
  CaseTally Tally;
  std::vector<std::string> Messages; ///< errors, printed at the end
  ReportIndex Index;
  std::optional<MaskFolder> Folder; ///< of structures
  std::string Taken;                ///< what a folder was judged to be; empty if it was not
};
} // namespace palpate::cli
