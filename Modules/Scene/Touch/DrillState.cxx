#include "DrillState.h"

#include "InputError.h"
#include "Refusal.h"

#include <memory>
#include <string>

namespace palpate
{
void WriteDrillState(const std::filesystem::path& path, const DrillContext& context)
{
  std::vector<DrillRecord> records;
  for (const auto& removed : context.Editor().Removed())
  {
    records.push_back(RecordOf(context, records.size(), *removed));
  }
  WriteDrillRecords(path, records);
}

void ReadDrillState(const std::filesystem::path& path, const DrillContext& context)
{
  RestoreDrillState(ReadDrillRecords(path), path, context);
}

void RestoreDrillState(const std::vector<DrillRecord>& records, const std::filesystem::path& path,
                       const DrillContext& context)
{
  if (records.size() != context.Sites().size())
  {
    Refuse(path,
           "holds " + std::to_string(records.size()) + " drilled structures, and the scene " +
               std::to_string(context.Sites().size()),
           "open the scene that was drilled");
  }
  std::vector<std::shared_ptr<const RemovedDistances>> removed;
  for (std::size_t site = 0; site < records.size(); ++site)
  {
    if (records[site].Source != SourceDigest(context, site))
    {
      Refuse(path, "was drilled in other voxels than those of " + context.Sites()[site].Name,
             "open the scene that was drilled");
    }
    removed.push_back(RemovedOf(records[site], context, site));
    if (removed.back() == nullptr)
    {
      RefuseDamagedDrilling(path);
    }
  }
  RequireInput(context.Editor().Restore(removed), path.string());
}
} // namespace palpate
