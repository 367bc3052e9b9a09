#include "ModelFile.h"

#include "FileEnding.h"
#include "ModelCsv.h"
#include "ModelJson.h"
#include "Refusal.h"
#include "SpharmPdmCoefficients.h"
#include "WholeFile.h"

#include <algorithm>
#include <array>

namespace palpate
{
namespace
{
// A model of the largest degree that is read fits, with room to spare.
constexpr std::uintmax_t MaximumBytes = 256 * 1024 * 1024;

struct ModelFormat
{
  const char* Ending;
  ModelDocument (*Read)(const std::string& text, const std::string& fileName); ///< may be null
  std::string (*Write)(const ModelDocument& document, const std::string& fileName);
  bool KeepsStarShape;
};

ModelDocument FromCoefficients(const std::string& text, const std::string& fileName)
{
  return {SurfaceFromSpharmPdm(text, fileName), {}};
}

std::string ToCoefficients(const ModelDocument& document, const std::string& fileName)
{
  return SurfaceToSpharmPdm(document.Surface, fileName);
}

constexpr std::array<ModelFormat, 3> Formats{
    {{".json", &ModelFromJson, &ModelToJson, true},
     {".csv", nullptr, &ModelToCsv, true},
     {".coef", &FromCoefficients, &ToCoefficients, false}}};

// Null for another ending.
const ModelFormat* Find(const std::filesystem::path& path)
{
  const std::string ending = FileEnding(path);
  const auto* const found = std::find_if(
      Formats.begin(), Formats.end(), [&](const auto& format) { return ending == format.Ending; });
  return found == Formats.end() ? nullptr : found;
}

const ModelFormat& FormatOf(const std::filesystem::path& path)
{
  const ModelFormat* const format = Find(path);
  if (format == nullptr)
  {
    Refuse(path, "does not end as a model file does", "use .json or .coef, or .csv to write one");
  }
  return *format;
}
} // namespace

bool IsModelFile(const std::filesystem::path& path)
{
  return Find(path) != nullptr;
}

bool KeepsStarShape(const std::filesystem::path& path)
{
  return FormatOf(path).KeepsStarShape;
}

ModelDocument ReadModel(const std::filesystem::path& path)
{
  const ModelFormat& format = FormatOf(path);
  if (format.Read == nullptr)
  {
    Refuse(path, "is a model's table, which is written and not read",
           "give the model.json that was written with it");
  }
  return format.Read(ReadWholeFile(path, MaximumBytes), path.string());
}

void WriteModel(const std::filesystem::path& path, const ModelDocument& document)
{
  const ModelFormat& format = FormatOf(path);
  ModelDocument named = document;
  named.Provenance.Input = std::filesystem::path(document.Provenance.Input).filename().string();
  WriteWholeFile(path, format.Write(named, path.string()));
}
} // namespace palpate
