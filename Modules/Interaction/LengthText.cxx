#include "LengthText.h"

#include <iomanip>
#include <locale>
#include <sstream>

namespace palpate
{
std::string LengthText(double millimeters, int decimals)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::fixed << std::setprecision(decimals) << millimeters << " mm";
  return text.str();
}
} // namespace palpate
