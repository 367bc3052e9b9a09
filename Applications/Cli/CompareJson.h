#pragma once

#include "PairComparison.h"

#include <string>

namespace palpate::cli
{
/// A pair as a JSON object on one line. `folder` holds its files; empty if none. Values that do not
/// exist, such as the volume of an open surface, are null.
std::string ComparisonJson(const PairComparison& pair, const std::string& folder);
} // namespace palpate::cli
