#include "OnDemandField.h"

#include "CoarseField.h"

#include <algorithm>

namespace palpate
{
namespace
{
void Hand(TrackerLink& link, const std::shared_ptr<const FieldSolid>& solid)
{
  link.Versions.Publish(std::make_unique<SolidVersion>(SolidVersion{solid}));
}
} // namespace

OnDemandField::OnDemandField(const std::shared_ptr<const FieldSurvey>& survey,
                             std::unique_ptr<BrickSource> source, int material,
                             const Settings& settings)
    : Survey(survey), Source(std::move(source)), Wanted(settings), Material(material)
{
}

Status OnDemandField::Make(const ScalarField& whole, int material,
                           const std::shared_ptr<const FieldSurvey>& survey,
                           std::unique_ptr<BrickSource> source, const Settings& settings,
                           std::shared_ptr<OnDemandField>& made)
{
  std::shared_ptr<const ScalarField> coarse;
  std::shared_ptr<const FieldSolid> coarseSolid;
  Status status = MakeCoarseField(whole, material, coarse);
  status = status.IsOk() ? FieldSolid::Make(coarse, 0, coarseSolid) : status;
  if (!status.IsOk())
  {
    return status;
  }
  made.reset(new OnDemandField(survey, std::move(source), material, settings));
  made->CoarseSolid = std::move(coarseSolid);
  made->CoarseBytes = coarse->Memory().Bytes;
  made->Bounds = FieldSolid::BoundsOf(whole, material);
  return Status::Success();
}

Status OnDemandField::GivePool(std::size_t bytes)
{
  Status status = FieldVersions::Make(this->Survey, std::move(this->Source), bytes, this->Versions);
  if (!status.IsOk())
  {
    return status;
  }
  ResidenceSettings plan;
  plan.AskedReach = this->Wanted.AskedReach;
  plan.PromisedSpeed = this->Wanted.PromisedSpeed;
  // The version that is felt and the next one are in use at once, unless all fits.
  const bool fitsAll = this->Versions->Room() >= this->Survey->RecordCount();
  plan.Room = fitsAll ? this->Versions->Room() : this->Versions->Room() / 2;
  this->Plan = std::make_unique<ResidencePlan>(this->Survey->Grid(), this->Survey, plan);
  return this->Renew({}) ? status : Status::Failure(this->Known.Problem);
}

bool OnDemandField::Renew(const BrickBox& box)
{
  this->Reclaim();
  std::shared_ptr<const ScalarField> version;
  std::shared_ptr<const FieldSolid> solid;
  Status status = this->Versions->MakeVersion(box, version);
  status =
      status.IsOk() ? FieldSolid::MakePart(version, this->Material, this->Bounds, solid) : status;
  const std::lock_guard<std::mutex> lock(this->Shared);
  this->Known.Problem = status.Message();
  this->Known.BricksRead = this->Versions->ReadCount();
  this->Known.BricksResident = this->Versions->ResidentCount();
  if (status.IsOk())
  {
    this->Current = std::move(solid);
    ++this->Known.Versions;
  }
  return status.IsOk();
}

// Of the tracker whose proxy is farthest.
ToolPlace OnDemandField::WithProxy(ToolPlace place)
{
  const std::lock_guard<std::mutex> lock(this->Shared);
  for (const std::weak_ptr<TrackerLink>& one : this->Links)
  {
    const std::shared_ptr<TrackerLink> link = one.lock();
    const Vector3 pull = link != nullptr ? Vector3(link->ProxyPull.Latest()) : Vector3::Zero();
    if (pull.squaredNorm() > (place.ProxyWorld - place.ProbeWorld).squaredNorm())
    {
      place.ProxyWorld = place.ProbeWorld + pull;
    }
  }
  return place;
}

// So that bricks which only they held make room.
void OnDemandField::Reclaim()
{
  const std::lock_guard<std::mutex> lock(this->Shared);
  for (const std::weak_ptr<TrackerLink>& one : this->Links)
  {
    if (const std::shared_ptr<TrackerLink> link = one.lock())
    {
      link->Versions.Reclaim();
    }
  }
}

void OnDemandField::Publish()
{
  const std::lock_guard<std::mutex> lock(this->Shared);
  this->Known.KeptSpeed = this->Plan->KeptSpeed();
  this->Known.Delay = this->Plan->Delay();
  const auto isGone = [](const std::weak_ptr<TrackerLink>& link) { return link.expired(); };
  this->Links.erase(std::remove_if(this->Links.begin(), this->Links.end(), isGone),
                    this->Links.end());
  for (const std::weak_ptr<TrackerLink>& one : this->Links)
  {
    if (const std::shared_ptr<TrackerLink> link = one.lock())
    {
      Hand(*link, this->Current);
    }
  }
}

std::shared_ptr<TrackerLink> OnDemandField::Attach()
{
  auto link = std::make_shared<TrackerLink>();
  const std::lock_guard<std::mutex> lock(this->Shared);
  this->Links.push_back(link);
  Hand(*link, this->Current);
  return link;
}

std::shared_ptr<const FieldSolid> OnDemandField::Newest() const
{
  const std::lock_guard<std::mutex> lock(this->Shared);
  return this->Current;
}

std::size_t OnDemandField::Bytes() const noexcept
{
  return this->Versions != nullptr
             ? sizeof(*this) + this->Survey->Bytes() + this->CoarseBytes + this->Versions->Bytes()
             : this->KeptBytes();
}

std::size_t OnDemandField::KeptBytes() const noexcept
{
  const std::size_t table = this->Survey->RecordCount() * sizeof(std::uint32_t);
  return sizeof(*this) + this->Survey->Bytes() + this->CoarseBytes + sizeof(FieldVersions) + table;
}

OnDemandCounts OnDemandField::Counts() const
{
  const std::lock_guard<std::mutex> lock(this->Shared);
  OnDemandCounts counts = this->Known;
  counts.CoarseTicks = this->CoarseTicks.load(std::memory_order_relaxed);
  return counts;
}
} // namespace palpate
