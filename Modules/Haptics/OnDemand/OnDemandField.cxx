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

// The one that is felt and the next are in use at once, unless all fits.
ResidenceSettings PlanOf(const FieldVersions& versions, const OnDemandField::Settings& settings)
{
  ResidenceSettings plan;
  plan.AskedReach = settings.AskedReach;
  plan.PromisedSpeed = settings.PromisedSpeed;
  const bool fitsAll = versions.Room() >= versions.Survey().RecordCount();
  plan.Room = fitsAll ? versions.Room() : versions.Room() / 2;
  return plan;
}
} // namespace

OnDemandField::OnDemandField(std::unique_ptr<FieldVersions> versions, int material,
                             const ResidenceSettings& settings)
    : Versions(std::move(versions)),
      Plan(this->Versions->Survey().Grid(), this->Versions->SharedSurvey(), settings),
      Material(material)
{
}

Status OnDemandField::Make(const ScalarField& whole, int material,
                           const std::shared_ptr<const FieldSurvey>& survey,
                           std::unique_ptr<BrickSource> source, const Settings& settings,
                           std::shared_ptr<OnDemandField>& made)
{
  std::shared_ptr<const ScalarField> coarse;
  std::shared_ptr<const FieldSolid> coarseSolid;
  std::unique_ptr<FieldVersions> versions;
  Status status = MakeCoarseField(whole, material, coarse);
  status = status.IsOk() ? FieldSolid::Make(coarse, 0, coarseSolid) : status;
  status = status.IsOk()
               ? FieldVersions::Make(survey, std::move(source), settings.PoolBytes, versions)
               : status;
  if (!status.IsOk())
  {
    return status;
  }
  const ResidenceSettings plan = PlanOf(*versions, settings);
  std::shared_ptr<OnDemandField> field(new OnDemandField(std::move(versions), material, plan));
  field->CoarseSolid = std::move(coarseSolid);
  field->CoarseBytes = coarse->Memory().Bytes;
  field->Bounds = FieldSolid::BoundsOf(whole, material);
  if (!field->Renew({}))
  {
    return Status::Failure(field->Known.Problem);
  }
  made = std::move(field);
  return Status::Success();
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
  this->Known.KeptSpeed = this->Plan.KeptSpeed();
  this->Known.Delay = this->Plan.Delay();
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
  return sizeof(*this) + this->Versions->Bytes() + this->Versions->Survey().Bytes() +
         this->CoarseBytes;
}

OnDemandCounts OnDemandField::Counts() const
{
  const std::lock_guard<std::mutex> lock(this->Shared);
  OnDemandCounts counts = this->Known;
  counts.CoarseTicks = this->CoarseTicks.load(std::memory_order_relaxed);
  return counts;
}
} // namespace palpate
