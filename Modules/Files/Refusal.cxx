#include "Refusal.h"

#include "InputError.h"

#include <locale>
#include <sstream>

namespace palpate
{
void Refuse(const std::filesystem::path& file, const std::string& fact, const std::string& remedy)
{
  throw InputError(file.string() + " " + fact + "; " + remedy + ".");
}

void RequireInput(const Status& status, const std::string& about)
{
  if (!status.IsOk())
  {
    throw InputError((about.empty() ? about : about + ": ") + status.Message());
  }
}
} // namespace palpate
