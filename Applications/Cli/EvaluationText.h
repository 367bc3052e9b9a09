#pragma once

#include "ModelEvaluation.h"

#include <string>

namespace palpate::cli
{
/// Readable tables with units.
std::string EvaluationAsText(const ModelEvaluation& evaluation);
/// For scripts: one JSON object; numbers round-trip to the same bits.
std::string EvaluationAsJson(const ModelEvaluation& evaluation);
} // namespace palpate::cli
