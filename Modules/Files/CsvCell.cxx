#include "CsvCell.h"

#include "DecimalText.h"

namespace palpate
{
namespace
{
// "CSV Injection", owasp.org.
bool IsFormula(const std::string& text)
{
  const std::size_t first = text.find_first_not_of('\'');
  return first != std::string::npos &&
         std::string("=+-@\t\r").find(text[first]) != std::string::npos;
}
} // namespace

std::string InertCell(const std::string& text)
{
  return IsFormula(text) && !ParseNumber(text) ? "'" + text : text;
}

std::string TextOfCell(const std::string& cell)
{
  return cell.rfind('\'', 0) == 0 && IsFormula(cell) ? cell.substr(1) : cell;
}
} // namespace palpate
