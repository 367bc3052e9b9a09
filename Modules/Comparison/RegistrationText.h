#pragma once

#include "FileRegistration.h"
#include "PalpateComparisonModule.h"

#include <string>

namespace palpate
{
/// The result for people, with line ends.
PALPATECOMPARISON_EXPORT std::string RegistrationText(const FileRegistration& found);
/// One JSON object (Documentation/JsonOutput.md). `transform` is the written file; may be empty.
PALPATECOMPARISON_EXPORT std::string RegistrationJson(const FileRegistration& found,
                                                      const RegisteredSide& moving,
                                                      const RegisteredSide& fixed,
                                                      const std::string& transform);
} // namespace palpate
