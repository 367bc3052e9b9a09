#pragma once

#include "FitResult.h"

#include <string>

namespace palpate::cli
{
/// One result as a JSON object on one line. `folder` holds its files; empty if none. Values of
/// stages that were not reached are null.
std::string FitResultJson(const FitResult& result, const std::string& folder);
} // namespace palpate::cli
