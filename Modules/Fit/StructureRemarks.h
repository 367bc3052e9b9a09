#pragma once

#include "FitResult.h"

namespace palpate
{
/// ml, of all components of the structure's label.
double AllParts(const FitResult& result);

/// Adds notes on the structure for the reader of the result: that it touches the border,
void RemarkOnStructure(FitResult& result);
/// that other components were left out,
void RemarkOnComponents(FitResult& result);
/// and what a radial model leaves out or fills; a surface model's repair says that by itself.
void RemarkOnRest(FitResult& result);
} // namespace palpate
