#pragma once

#include "MaskChecks.h"
#include "PalpateComparisonModule.h"

#include <string>

namespace palpate
{
/// One object, as Documentation/JsonOutput.md lists its keys; `folder` is where files are written,
/// or empty.
PALPATECOMPARISON_EXPORT std::string CheckJson(const MaskChecks& checks, const std::string& folder);
/// CSV with a row for each structure; keys as in JSON.
std::string CheckTable(const MaskChecks& checks);
} // namespace palpate
