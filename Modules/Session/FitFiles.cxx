#include "FitFiles.h"

#include "FitReport.h"
#include "FitSettingsText.h"
#include "InputError.h"
#include "ModelFile.h"
#include "OutputFolder.h"
#include "SurfaceFile.h"

#include <array>
#include <cctype>
#include <system_error>

namespace palpate
{
namespace
{
constexpr std::size_t LongestPart = 48;
constexpr std::size_t LongestName = 80;
constexpr std::array<const char*, 4> ResultFiles{
    {"model.json", "model.csv", "model.vtp", "surface.vtp"}};

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

void RemoveResults(const std::filesystem::path& folder)
{
  for (const char* name : ResultFiles)
  {
    const std::filesystem::path file = folder / name;
    std::error_code error;
    if (std::filesystem::is_directory(file, error))
    {
      continue; // none of ours
    }
    std::filesystem::remove(file, error);
    if (error)
    {
      throw InputError(file.string() + " of an earlier fit cannot be removed (" + error.message() +
                       "); choose another folder with --output");
    }
  }
}

// Letters outside ASCII become one mark for each of their bytes.
std::string InPlainLetters(std::string text)
{
  for (char& letter : text)
  {
    const bool plain = std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '-' ||
                       letter == '_' || letter == '.';
    letter = plain ? letter : '_';
  }
  return text;
}
} // namespace

void WriteFitFiles(const FitResult& result, const Volume* volumeOrNull,
                   const std::filesystem::path& folder, const std::string& program)
{
  MakeOutputFolder(folder);
  RemoveResults(folder);
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

void RemoveEarlierFit(const std::filesystem::path& folder)
{
  std::error_code ignored;
  if (std::filesystem::is_regular_file(folder / "report.html", ignored))
  {
    RemoveResults(folder);
  }
}

std::string PlainName(const std::string& text)
{
  return InPlainLetters(text).substr(0, LongestPart);
}

std::string CaseFolderName(const std::string& caseName, const Segment& structure)
{
  std::string name = PlainName(caseName) + "_" + std::to_string(structure.Label);
  if (!structure.Name.empty())
  {
    name += "_" + InPlainLetters(structure.Name);
  }
  return name.substr(0, LongestName);
}
} // namespace palpate
