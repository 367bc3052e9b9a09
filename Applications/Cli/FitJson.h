#pragma once

#include "FitResult.h"

#include <string>

namespace palpate::cli
{
/// One result as a JSON object on one line. `folder` is where its files are; empty for none. What
/// was not reached is null.
std::string FitResultJson(const FitResult& result, const std::string& folder);
} // namespace palpate::cli
