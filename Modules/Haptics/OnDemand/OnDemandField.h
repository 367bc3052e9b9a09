#pragma once

#include "FieldSolid.h"
#include "FieldVersions.h"
#include "LatestValue.h"
#include "PlainVector3.h"
#include "ResidencePlan.h"
#include "SnapshotSlot.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace palpate
{
/// A solid as it goes to a tracker, and comes back.
struct SolidVersion
{
  std::shared_ptr<const FieldSolid> Solid;
};

/// Between one tracker and who looks after it.
struct TrackerLink
{
  SnapshotSlot<SolidVersion> Versions; ///< to the tracker
  LatestValue<PlainVector3> ProxyPull; ///< from it: from the probe to the proxy, mm
};

/// What became of an on-demand field so far.
struct OnDemandCounts
{
  std::uint64_t Versions = 0;
  std::uint64_t BricksRead = 0;
  std::size_t BricksResident = 0;
  std::uint64_t CoarseTicks = 0; ///< that felt the coarse field, since the tool was too fast
  double KeptSpeed = 0.0;        ///< mm/s at which the tool does not outrun the bricks
  double Delay = 0.0;            ///< s that a version took at worst lately
  std::string Problem;           ///< why the last version could not be made; empty if it was
};

/// One material of a field of which only the bricks round the tool are in memory; a coarse field
/// beneath is there everywhere. Trackers (see OnDemandContactModel) get each version through a slot
/// of their own.
///
/// Attach: publishing threads. Look: one thread that is not the servo's. Counts: any.
class OnDemandField
{
public:
  struct Settings
  {
    double AskedReach = 0.0;      ///< mm; how far from a tool's origin the field is asked
    double PromisedSpeed = 100.0; ///< mm/s, at least, that the tool may have
  };

  /// Takes of `whole` what is kept of all bricks; `source` has its records. Has no room for them
  /// before GivePool, without which nothing can be felt. Refuses what MakeCoarseField and
  /// FieldSolid refuse.
  static Status Make(const ScalarField& whole, int material,
                     const std::shared_ptr<const FieldSurvey>& survey,
                     std::unique_ptr<BrickSource> source, const Settings& settings,
                     std::shared_ptr<OnDemandField>& made);
  /// Once, before any Attach and Look. Refuses what FieldVersions refuses.
  Status GivePool(std::size_t bytes);

  /// Whether another version is wanted with the tool's probe there. If so makes it and hands it to
  /// all trackers; `now()` gives seconds, by the clock of `place`.
  template <typename Now>
  void Look(const ToolPlace& place, const Now& now)
  {
    if (const std::optional<BrickBox> box = this->Plan->Look(this->WithProxy(place)))
    {
      this->Renew(*box) ? this->Plan->Made(now() - place.Time) : this->Plan->Failed();
      this->Publish();
    }
  }

  /// For a tracker, with the newest version in it.
  std::shared_ptr<TrackerLink> Attach();

  const std::shared_ptr<const FieldSolid>& Coarse() const noexcept { return this->CoarseSolid; }
  std::shared_ptr<const FieldSolid> Newest() const;
  const Eigen::AlignedBox3d& BoundsWorld() const noexcept { return this->Bounds; }
  /// Pool, survey and coarse field.
  std::size_t Bytes() const noexcept;
  /// What is there whatever the pool: survey and coarse field.
  std::size_t KeptBytes() const noexcept;
  /// A pool for all bricks takes so much.
  std::size_t LargestPool() const noexcept
  {
    return this->Survey->RecordCount() * FieldVersions::BytesOfRecord(*this->Survey);
  }
  OnDemandCounts Counts() const;
  /// By trackers.
  void CountCoarseTick() noexcept { this->CoarseTicks.fetch_add(1, std::memory_order_relaxed); }

private:
  OnDemandField(const std::shared_ptr<const FieldSurvey>& survey,
                std::unique_ptr<BrickSource> source, int material, const Settings& settings);
  ToolPlace WithProxy(ToolPlace place);
  void Reclaim();
  bool Renew(const BrickBox& box);
  void Publish();

  std::shared_ptr<const FieldSurvey> Survey;
  std::unique_ptr<BrickSource> Source;     // until there is a pool
  std::unique_ptr<FieldVersions> Versions; // the looking thread's
  std::unique_ptr<ResidencePlan> Plan;     // the looking thread's
  Settings Wanted;
  int Material;
  Eigen::AlignedBox3d Bounds;
  std::shared_ptr<const FieldSolid> CoarseSolid;
  std::size_t CoarseBytes = 0;
  std::atomic<std::uint64_t> CoarseTicks{0};
  mutable std::mutex Shared; // by the looking and the publishing thread: what follows
  std::vector<std::weak_ptr<TrackerLink>> Links;
  std::shared_ptr<const FieldSolid> Current;
  OnDemandCounts Known;
};
} // namespace palpate
