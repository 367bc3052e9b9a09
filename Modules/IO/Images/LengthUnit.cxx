#include "LengthUnit.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace palpate
{
namespace
{
struct Unit
{
  const char* Name;
  double Millimeters;
};

// A micro sign in Latin-1, and the micro sign and the letter mu in UTF-8.
constexpr std::array<Unit, 27> Units{
    {{"mm", 1.0},           {"millimeter", 1.0},  {"millimeters", 1.0},  {"millimetre", 1.0},
     {"millimetres", 1.0},  {"um", 1e-3},         {"\xB5m", 1e-3},       {"\xC2\xB5m", 1e-3},
     {"\xCE\xBCm", 1e-3},   {"micron", 1e-3},     {"microns", 1e-3},     {"micrometer", 1e-3},
     {"micrometers", 1e-3}, {"micrometre", 1e-3}, {"micrometres", 1e-3}, {"nm", 1e-6},
     {"nanometer", 1e-6},   {"nanometers", 1e-6}, {"cm", 10.0},          {"centimeter", 10.0},
     {"centimeters", 10.0}, {"centimetre", 10.0}, {"m", 1000.0},         {"meter", 1000.0},
     {"meters", 1000.0},    {"metre", 1000.0},    {"in", 25.4}}};
} // namespace

std::optional<double> MillimetersPer(const std::string& unit)
{
  std::string name;
  for (const char letter : unit)
  {
    const auto byte = static_cast<unsigned char>(letter);
    if (letter != ' ' && letter != '\t')
    {
      // Only ASCII: the bytes of a micro sign have no other case.
      name += byte < 128 ? static_cast<char>(std::tolower(byte)) : letter;
    }
  }
  const auto* const found = std::find_if(Units.begin(), Units.end(),
                                         [&name](const Unit& known) { return name == known.Name; });
  return found == Units.end() ? std::nullopt : std::optional<double>(found->Millimeters);
}

std::vector<std::string> ListedUnits(const std::string& text)
{
  std::vector<std::string> units;
  for (std::size_t place = text.find_first_not_of(" \t"); place != std::string::npos;
       place = text.find_first_not_of(" \t", place))
  {
    const bool isQuoted = text[place] == '"';
    const std::size_t start = place + (isQuoted ? 1 : 0);
    const std::size_t end =
        std::min(isQuoted ? text.find('"', start) : text.find_first_of(" \t", start), text.size());
    units.push_back(text.substr(start, end - start));
    place = std::min(end + (isQuoted ? 1 : 0), text.size());
  }
  return units;
}
} // namespace palpate
