#include "OnDemandHarmonics.h"

#include "CoarseHarmonics.h"

#include <algorithm>
#include <chrono>

namespace palpate
{
Status OnDemandHarmonics::Make(const std::shared_ptr<const SphericalHarmonicModel>& model,
                               const Settings& settings, std::shared_ptr<OnDemandHarmonics>& made)
{
  std::shared_ptr<OnDemandHarmonics> next(new OnDemandHarmonics(settings));
  const auto start = std::chrono::steady_clock::now();
  Status status = next->AddRung(model);
  for (const int degree : settings.StandIns)
  {
    if (status.IsOk() && degree > 0 && degree < model->Degree())
    {
      // One that reaches its centre is no stand-in.
      const Status cut =
          next->AddRung(std::make_shared<const SphericalHarmonicModel>(model->WithDegree(degree)));
      static_cast<void>(cut.IsOk());
    }
  }
  next->Seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  status = status.IsOk() ? next->MakeCoarse(*model) : status;
  if (status.IsOk())
  {
    made = std::move(next);
  }
  return status;
}

Status OnDemandHarmonics::MakeCoarse(const SphericalHarmonicModel& model)
{
  const CoarseHarmonics coarse = MakeCoarseHarmonics(model, CoarseDegree);
  this->Raised = coarse.RaisedBy;
  this->CoarseModel = std::make_shared<const SphericalHarmonicModel>(coarse.Model);
  Status status =
      HarmonicContactModel::Make(this->CoarseModel, this->Wanted.Mode, this->CoarseBody);
  std::unique_ptr<ContactTracker> tracker;
  status = status.IsOk() ? this->CoarseBody->MakeTracker(this->Wanted.Tool, {}, tracker) : status;
  if (status.IsOk())
  {
    this->Kept = sizeof(*this) + this->CoarseBody->Bytes() + tracker->Bytes();
    for (const Rung& rung : this->Rungs)
    {
      this->Kept += rung.Model->Coefficients().size() * sizeof(double) + rung.Model->TableBytes();
    }
  }
  return status;
}

// Made to know what it takes, and forgotten.
Status OnDemandHarmonics::AddRung(const std::shared_ptr<const SphericalHarmonicModel>& model)
{
  Rung rung;
  rung.Model = model;
  std::shared_ptr<const ContactModel> contact;
  std::unique_ptr<ContactTracker> tracker;
  Status status =
      HarmonicContactModel::Make(model, this->Wanted.Mode, contact, this->Wanted.Precision);
  status = status.IsOk() ? contact->MakeTracker(this->Wanted.Tool, {}, tracker) : status;
  if (status.IsOk())
  {
    rung.Bounds = contact->BoundsWorld();
    rung.Bytes = contact->Bytes();
    rung.TrackerBytes = tracker->Bytes();
    this->Bounds.extend(rung.Bounds);
    this->Rungs.push_back(std::move(rung));
  }
  return status;
}

double OnDemandHarmonics::HeightOver(const Vector3& placeWorld) const noexcept
{
  const Vector3 offset = placeWorld - this->CoarseModel->CenterWorld();
  const double length = offset.stableNorm();
  const Vector3 direction = length > 0.0 ? Vector3(offset.stableNormalized()) : Vector3::UnitZ();
  return length - this->CoarseModel->Radius(direction);
}

Status OnDemandHarmonics::Fill(const Link& link)
{
  const std::shared_ptr<TrackerSlot> slot = link.Slot.lock();
  std::unique_ptr<ContactTracker> tracker;
  if (slot == nullptr || !slot->IsEmpty())
  {
    return Status::Success();
  }
  Status status = this->Rungs[link.Rung].AtHand->MakeTracker(link.Tool, link.Friction, tracker);
  if (status.IsOk())
  {
    slot->Put(std::move(tracker));
  }
  return status;
}

Status OnDemandHarmonics::Attach(std::size_t rung, const ToolShape& tool,
                                 const SurfaceFriction& friction,
                                 std::shared_ptr<TrackerSlot>& slot)
{
  Status status = HarmonicContactModel::Check(this->Wanted.Mode, tool, friction);
  if (!status.IsOk())
  {
    return status;
  }
  auto next = std::make_shared<TrackerSlot>();
  const std::lock_guard<std::mutex> lock(this->Shared);
  this->ForgetLinks();
  this->Links.push_back({rung, tool, friction, next});
  if (this->Rungs[rung].AtHand != nullptr)
  {
    status = this->Fill(this->Links.back());
  }
  if (status.IsOk())
  {
    slot = std::move(next);
  }
  return status;
}

void OnDemandHarmonics::ForgetLinks()
{
  const auto isGone = [](const Link& link) { return link.Slot.expired(); };
  this->Links.erase(std::remove_if(this->Links.begin(), this->Links.end(), isGone),
                    this->Links.end());
}

Status OnDemandHarmonics::Bring()
{
  const std::lock_guard<std::mutex> lock(this->Shared);
  Status status = Status::Success();
  for (Rung& rung : this->Rungs)
  {
    if (status.IsOk() && rung.AtHand == nullptr)
    {
      status = HarmonicContactModel::Make(rung.Model, this->Wanted.Mode, rung.AtHand,
                                          this->Wanted.Precision);
    }
  }
  this->ForgetLinks();
  for (const Link& link : this->Links)
  {
    status = status.IsOk() ? this->Fill(link) : status;
    if (const std::shared_ptr<TrackerSlot> slot = link.Slot.lock())
    {
      slot->AskBack(false);
    }
  }
  return status;
}

bool OnDemandHarmonics::Drop()
{
  const std::lock_guard<std::mutex> lock(this->Shared);
  bool isGone = true;
  for (const Link& link : this->Links)
  {
    if (const std::shared_ptr<TrackerSlot> slot = link.Slot.lock())
    {
      slot->AskBack(true);
      isGone = slot->TryClear() && isGone;
    }
  }
  for (Rung& rung : this->Rungs)
  {
    rung.AtHand = isGone ? nullptr : rung.AtHand;
  }
  return isGone;
}

bool OnDemandHarmonics::IsAtHand() const
{
  const std::lock_guard<std::mutex> lock(this->Shared);
  return this->Rungs.front().AtHand != nullptr;
}

std::size_t OnDemandHarmonics::BytesAtHand() const
{
  const std::lock_guard<std::mutex> lock(this->Shared);
  std::size_t bytes = 0;
  for (std::size_t rung = 0; rung < this->Rungs.size(); ++rung)
  {
    const auto links = std::count_if(this->Links.begin(), this->Links.end(),
                                     [rung](const Link& link)
                                     { return link.Rung == rung && !link.Slot.expired(); });
    const auto trackers = static_cast<std::size_t>(std::max<std::ptrdiff_t>(links, 1));
    bytes += this->Rungs[rung].Bytes + trackers * this->Rungs[rung].TrackerBytes;
  }
  return bytes;
}

std::size_t OnDemandHarmonics::Bytes() const
{
  return this->Kept + (this->IsAtHand() ? this->BytesAtHand() : 0);
}
} // namespace palpate
