#pragma once

#include "PalpateIOModule.h"

#include <clocale>
#include <filesystem>

namespace palpate
{
/// Gives the calling thread the numbers of the "C" locale while it lives, whatever locale the
/// process has: ITK, VTK and their format libraries read and write decimals with sscanf, strtod and
/// fprintf, which take "3.5" for 3 where the decimal point is a comma. Other threads and the rest
/// of the locale stay as they are, so that it suits programs which embed the readers.
class PALPATEIO_EXPORT CNumericLocale
{
public:
  /// Throws std::bad_alloc.
  CNumericLocale();
  CNumericLocale(const CNumericLocale&) = delete;
  CNumericLocale& operator=(const CNumericLocale&) = delete;
  ~CNumericLocale();

  /// MetaIO (MetaImage) and VTK's reader of VTP use C++ streams, whose locale belongs to the whole
  /// process. Throws InputError, naming `file`, where the process has made it one that writes other
  /// numbers than "C" (std::locale::global; setlocale and QApplication do not).
  static void RequireOfStreams(const std::filesystem::path& file);

private:
  locale_t Own;
  locale_t Previous;
};
} // namespace palpate
