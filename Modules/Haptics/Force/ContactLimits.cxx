#include "ContactLimits.h"

#include <locale>
#include <sstream>
#include <string>

namespace palpate
{
namespace
{
Status Within(const std::string& what, const std::string& unit, double number, double most)
{
  if (number >= 0.0 && number <= most)
  {
    return Status::Success();
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "a structure's " << what << " is from 0 to " << most << unit << ", not " << number
       << "; check its unit";
  return Status::Failure(text.str());
}
} // namespace

Status ContactLimits::Check(const ContactLaw& law, const SurfaceFriction& friction)
{
  for (const Status& status : {Within("stiffness", " N/mm", law.Stiffness, Stiffness),
                               Within("damping", " N s/mm", law.Damping, Damping),
                               Within("static friction", "", friction.Static, Friction),
                               Within("sliding friction", "", friction.Dynamic, Friction)})
  {
    if (!status.IsOk())
    {
      return status;
    }
  }
  return friction.Dynamic <= friction.Static
             ? Status::Success()
             : Status::Failure("a structure's sliding friction is not above its static friction");
}
} // namespace palpate
