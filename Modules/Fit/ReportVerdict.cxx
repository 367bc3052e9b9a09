#include "ReportVerdict.h"

#include "DecimalText.h"

#include <cstring>

namespace palpate
{
namespace
{
// Messages about a structure do not name it, since the page does: "is not star-shaped: ...".
bool IsPredicate(const std::string& message, const FitResult& result)
{
  return !message.empty() && message.front() >= 'a' && message.front() <= 'z' &&
         message.rfind(result.Input.filename().string(), 0) != 0;
}
} // namespace

std::string StructureText(const FitResult& result)
{
  return result.Structure.Name.empty() ? "Label " + std::to_string(result.Structure.Label)
                                       : result.Structure.Name;
}

std::string SharedText(const std::filesystem::path& file, std::string message)
{
  const std::string folder = file.parent_path().string() + "/";
  std::size_t at = folder.size() > 1 ? message.find(folder) : std::string::npos;
  while (at != std::string::npos)
  {
    const bool isStart = at == 0 || std::strchr(" \"'(", message[at - 1]) != nullptr;
    if (isStart)
    {
      message.erase(at, folder.size());
    }
    at = message.find(folder, at + (isStart ? 0 : 1));
  }
  return message;
}

std::string VerdictText(const FitResult& result)
{
  std::string text;
  if (result.State == FitResult::Outcome::Fitted)
  {
    text = "A model of degree " + std::to_string(DegreeOf(result.Model)) + " (" +
           std::to_string(CoefficientCountOf(result.Model)) + " coefficients) follows the " +
           (result.IsOfSurface ? "surface" : "mask\xE2\x80\x99s boundary") +
           " with a mean distance of " + FixedText(result.ModelToInput().Mean, 2) +
           " mm; 95 % of the " + (result.IsOfSurface ? "surface" : "boundary") + " lies within " +
           FixedText(result.ModelToInput().Percentile95, 2) + " mm. ";
  }
  const std::string message = SharedText(result.Input, result.Message);
  return text + (IsPredicate(message, result) ? StructureText(result) + " " : "") + message;
}
} // namespace palpate
