#pragma once

#include "CohortGroup.h"
#include "PalpateGroupModule.h"
#include "Progress.h"

#include <filesystem>

namespace palpate
{
/// The files of another shape tool.
enum class ExportKind
{
  SpharmPdm, ///< WriteSpharmPdmCase
  ShapeWorks ///< ShapeWorksFolder
};

/// Writes each case of a group for another tool into `output`, which is made. The models in their
/// patients' frames are read again, relative to `folder`, one at a time. Throws InputError and
/// Cancelled.
PALPATEGROUP_EXPORT void ExportCohort(const CohortGroup& group, const std::filesystem::path& folder,
                                      ExportKind kind, const std::filesystem::path& output,
                                      const ProgressFunction& progress);
} // namespace palpate
