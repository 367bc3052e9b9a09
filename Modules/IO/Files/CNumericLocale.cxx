#include "CNumericLocale.h"

#include "Refusal.h"

#include <locale>
#include <new>

namespace palpate
{
namespace
{
locale_t WithCNumbers(locale_t locale)
{
  const locale_t copy = duplocale(locale);
  const locale_t changed = copy == nullptr ? nullptr : newlocale(LC_NUMERIC_MASK, "C", copy);
  if (changed == nullptr && copy != nullptr)
  {
    freelocale(copy);
  }
  if (changed == nullptr)
  {
    throw std::bad_alloc();
  }
  return changed;
}
} // namespace

CNumericLocale::CNumericLocale()
    : Own(WithCNumbers(uselocale(nullptr))), Previous(uselocale(this->Own))
{
}

CNumericLocale::~CNumericLocale()
{
  uselocale(this->Previous);
  freelocale(this->Own);
}

void CNumericLocale::RequireOfStreams(const std::filesystem::path& file)
{
  const auto& numbers = std::use_facet<std::numpunct<char>>(std::locale());
  if (numbers.decimal_point() != '.' || !numbers.grouping().empty())
  {
    Refuse(file,
           "cannot be read or written in its format while the program's C++ streams use the number "
           "format of the locale " +
               std::locale().name(),
           "set std::locale::global to the classic one, or use another format");
  }
}
} // namespace palpate
