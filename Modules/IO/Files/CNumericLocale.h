#pragma once

#include "PalpateIOModule.h"

#include <clocale>
#include <filesystem>

namespace palpate
{
/// Switches the calling thread to the number format of the "C" locale during its lifetime,
/// independently of the process's locale: ITK, VTK and their format libraries read and write
/// decimals with sscanf, strtod and fprintf, which read "3.5" as 3 if the decimal separator is a
/// comma. Other threads and the rest of the locale are unchanged, so programs can safely embed the
/// readers.
class PALPATEIO_EXPORT CNumericLocale
{
public:
  /// Throws std::bad_alloc.
  CNumericLocale();
  CNumericLocale(const CNumericLocale&) = delete;
  CNumericLocale& operator=(const CNumericLocale&) = delete;
  ~CNumericLocale();

  /// MetaIO (MetaImage) and VTK's reader of VTP use C++ streams, whose locale belongs to the whole
  /// process. Throws InputError, naming `file`, if the process has set one whose number format is
  /// not that of "C" (std::locale::global; setlocale and QApplication do not set it).
  static void RequireOfStreams(const std::filesystem::path& file);

private:
  locale_t Own;
  locale_t Previous;
};
} // namespace palpate
