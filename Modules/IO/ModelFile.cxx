#include "ModelFile.h"

#include "FileEnding.h"
#include "ModelCsv.h"
#include "ModelJson.h"
#include "Refusal.h"
#include "SpharmPdmCoefficients.h"
#include "WholeFile.h"

namespace palpate
{
namespace
{
// A model of the largest degree that is read fits, with room to spare.
constexpr std::uintmax_t MaximumBytes = 256 * 1024 * 1024;

[[noreturn]] void RefuseEnding(const std::filesystem::path& path)
{
  Refuse(path, "does not end as a model file does", "use .json, .csv or .coef");
}
} // namespace

bool IsModelFile(const std::filesystem::path& path)
{
  const std::string ending = FileEnding(path);
  return ending == ".json" || ending == ".csv" || ending == ".coef";
}

ModelDocument ReadModel(const std::filesystem::path& path)
{
  if (!IsModelFile(path))
  {
    RefuseEnding(path);
  }
  const std::string text = ReadWholeFile(path, MaximumBytes);
  const std::string ending = FileEnding(path);
  if (ending == ".json")
  {
    return ModelFromJson(text, path.string());
  }
  if (ending == ".csv")
  {
    return ModelFromCsv(text, path.string());
  }
  return {SurfaceFromSpharmPdm(text, path.string()), {}};
}

void WriteModel(const std::filesystem::path& path, const ModelDocument& document)
{
  ModelDocument named = document;
  named.Provenance.Input = std::filesystem::path(document.Provenance.Input).filename().string();
  const std::string ending = FileEnding(path);
  if (ending == ".json")
  {
    WriteWholeFile(path, ModelToJson(named, path.string()));
  }
  else if (ending == ".csv")
  {
    WriteWholeFile(path, ModelToCsv(named, path.string()));
  }
  else if (ending == ".coef")
  {
    WriteWholeFile(path, SurfaceToSpharmPdm(named.Surface, path.string()));
  }
  else
  {
    RefuseEnding(path);
  }
}
} // namespace palpate
