#pragma once

#include "DrillContext.h"
#include "PalpateSceneModule.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// What was removed from a structure, independent of a drilling session.
struct DrillRecord
{
  std::string Name;               ///< for messages
  std::string Source;             ///< see SourceDigest
  std::vector<std::byte> Removed; ///< as RemovalBytes
};

/// Identifies the voxels and the material that a site was made from. Takes no time.
PALPATESCENE_EXPORT std::string SourceDigest(const DrillContext& context, std::size_t site);

/// The record of a site from which `removed` was removed.
PALPATESCENE_EXPORT DrillRecord RecordOf(const DrillContext& context, std::size_t site,
                                         const RemovedDistances& removed);
/// The removed region of a record for a site of the same source; null if the record is damaged.
PALPATESCENE_EXPORT std::shared_ptr<const RemovedDistances>
RemovedOf(const DrillRecord& record, const DrillContext& context, std::size_t site);

/// Writes records under AtomicFile's rules, with a digest of each. Throws InputError.
PALPATESCENE_EXPORT void WriteDrillRecords(const std::filesystem::path& path,
                                           const std::vector<DrillRecord>& records);
/// Throws InputError if the file is malformed or damaged.
PALPATESCENE_EXPORT std::vector<DrillRecord> ReadDrillRecords(const std::filesystem::path& path);

/// Throws InputError that says that the file is no intact drilled state.
[[noreturn]] PALPATESCENE_EXPORT void RefuseDamagedDrilling(const std::filesystem::path& path);
} // namespace palpate
