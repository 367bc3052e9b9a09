#include "ModelFile.h"

#include "FileFormat.h"
#include "ModelCsv.h"
#include "ModelJson.h"
#include "Refusal.h"
#include "SpharmPdmCoefficients.h"
#include "WholeFile.h"

namespace palpate
{
namespace
{
// More than a model of the largest supported degree needs.
constexpr std::uintmax_t MaximumBytes = 256 * 1024 * 1024;

struct ModelFormat : FileFormat
{
  ModelDocument (*Read)(const std::string& text, const std::string& fileName); ///< may be null
  std::string (*Write)(const ModelDocument& document, const std::string& fileName);
  bool KeepsRadialModel;
};

ModelDocument FromCoefficients(const std::string& text, const std::string& fileName)
{
  return {SurfaceFromSpharmPdm(text, fileName), {}};
}

std::string ToCoefficients(const ModelDocument& document, const std::string& fileName)
{
  return SurfaceToSpharmPdm(document.Surface, fileName);
}

const FormatList<ModelFormat>& Formats()
{
  static const FormatList<ModelFormat> formats(
      {{{"Palpate's model", {".json"}, {".json"}}, &ModelFromJson, &ModelToJson, true},
       {{"table", {}, {".csv"}}, nullptr, &ModelToCsv, true},
       {{"SPHARM-PDM", {".coef"}, {".coef"}}, &FromCoefficients, &ToCoefficients, false}});
  return formats;
}

const ModelFormat& FormatOf(const std::filesystem::path& path)
{
  const ModelFormat* const format = Formats().Writer(path);
  if (format == nullptr)
  {
    Refuse(path, "does not have the ending of a model file",
           "use " + ListOfEndings(ReadableModelEndings()) + ", or .csv to write one");
  }
  return *format;
}
} // namespace

std::vector<std::string> ReadableModelEndings()
{
  return Formats().ReadEndings();
}

bool IsModelFile(const std::filesystem::path& path)
{
  return Formats().Writer(path) != nullptr;
}

bool KeepsRadialModel(const std::filesystem::path& path)
{
  return FormatOf(path).KeepsRadialModel;
}

ModelDocument ReadModel(const std::filesystem::path& path)
{
  const ModelFormat& format = FormatOf(path);
  if (format.Read == nullptr)
  {
    Refuse(path, "is a model table, which Palpate writes but does not read",
           "use the model.json that was written with it");
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
