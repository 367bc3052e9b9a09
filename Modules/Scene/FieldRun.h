#pragma once

#include "FieldBuilder.h"
#include "Progress.h"

#include <memory>

namespace palpate
{
/// Builds a field, with progress of this stage. Returns why it could not be built; throws
/// Cancelled.
Status RunBuilder(const FieldBuilder& builder, const char* stage, const ProgressFunction& progress,
                  std::shared_ptr<const ScalarField>& field);
} // namespace palpate
