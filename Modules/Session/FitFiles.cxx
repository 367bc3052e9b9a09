#include "FitFiles.h"

#include "FitReport.h"
#include "FitSettingsText.h"
#include "InputError.h"
#include "ModelFile.h"
#include "SurfaceFile.h"

#include <cctype>
#include <system_error>

namespace palpate
{
namespace
{
void MakeFolder(const std::filesystem::path& folder)
{
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
  {
    throw InputError("the output folder " + folder.string() + " cannot be made (" +
                     error.message() + "); choose another with --output");
  }
}

ModelDocument Document(const FitResult& result, const std::string& program)
{
  ModelDocument document;
  document.Surface = result.Model;
  document.Provenance.Program = program;
  document.Provenance.Input = result.Input.filename().string();
  document.Provenance.Label = std::to_string(result.Structure.Label);
  document.Provenance.Settings = DescribeSettings(result.Settings);
  return document;
}
} // namespace

void WriteFitFiles(const FitResult& result, const Volume* volumeOrNull,
                   const std::filesystem::path& folder, const std::string& program)
{
  MakeFolder(folder);
  if (result.State == FitResult::Outcome::Fitted)
  {
    const ModelDocument document = Document(result, program);
    WriteModel(folder / "model.json", document);
    WriteModel(folder / "model.csv", document);
    WriteSurface(folder / "model.vtp", result.ModelSurface);
  }
  if (result.Surface != nullptr && result.Surface->GetNumberOfPolys() > 0)
  {
    WriteSurface(folder / "surface.vtp", result.Surface);
  }
  WriteFitReport(result, volumeOrNull, folder / "report.html");
}

std::string CaseFolderName(const FitResult& result)
{
  std::string name = result.CaseName + "_" + std::to_string(result.Structure.Label);
  if (!result.Structure.Name.empty())
  {
    name += "_" + result.Structure.Name;
  }
  for (char& letter : name)
  {
    const bool plain = std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '-' ||
                       letter == '_' || letter == '.';
    letter = plain ? letter : '_';
  }
  return name;
}
} // namespace palpate
