#pragma once

#include "PalpateReportModule.h"

#include <string>

namespace palpate
{
/// A table's bytes as UTF-8. Spreadsheets also write UTF-16 (with a byte-order mark) and
/// Windows-1252, the superset of Latin-1; `encoding` says which one it was, and is empty for UTF-8.
/// Throws InputError, naming `file`, if the bytes are none of these or hold control characters,
/// which neither XML nor a terminal takes.
PALPATEREPORT_EXPORT std::string TableAsUtf8(std::string bytes, const std::string& file,
                                             std::string& encoding);
} // namespace palpate
