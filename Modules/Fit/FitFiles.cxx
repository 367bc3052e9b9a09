#include "FitFiles.h"

#include "FitReport.h"
#include "FitSettingsText.h"
#include "ModelFile.h"
#include "OutputFolder.h"
#include "SurfaceFile.h"

#include <system_error>

namespace palpate
{
namespace
{
const std::vector<std::string> ResultFiles{"model.json", "model.csv", "model.vtp", "surface.vtp"};

ModelDocument Document(const FitResult& result, const std::string& program)
{
  ModelDocument document;
  document.Surface = result.Model;
  document.Provenance.Program = program;
  document.Provenance.Input = result.Input.filename().string();
  document.Provenance.Label =
      result.IsOfSurface ? std::string() : std::to_string(result.Structure.Label);
  document.Provenance.Settings = DescribeSettings(result.Settings);
  return document;
}
} // namespace

void WriteFitFiles(const FitResult& result, const Volume* volumeOrNull,
                   const std::filesystem::path& folder, const std::string& program)
{
  WriteOutputSet(
      folder,
      [&](const std::filesystem::path& stage)
      {
        if (result.State == FitResult::Outcome::Fitted)
        {
          const ModelDocument document = Document(result, program);
          WriteModel(stage / "model.json", document);
          WriteModel(stage / "model.csv", document);
          WriteSurface(stage / "model.vtp", result.ModelSurface);
        }
        if (result.Surface != nullptr && result.Surface->GetNumberOfPolys() > 0)
        {
          WriteSurface(stage / "surface.vtp", result.Surface);
        }
        WriteFitReport(result, volumeOrNull, stage / "report.html");
      },
      ResultFiles);
}

void WriteFitOverview(const ReportIndex& index, const std::filesystem::path& folder)
{
  std::error_code ignored;
  const bool hasEarlier = std::filesystem::is_regular_file(folder / "report.html", ignored);
  WriteOutputSet(
      folder, [&index](const std::filesystem::path& stage) { index.Write(stage / "report.html"); },
      hasEarlier ? ResultFiles : std::vector<std::string>());
}
} // namespace palpate
