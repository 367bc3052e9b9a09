#include "HeldOrgan.h"

#include "MeshConversion.h"
#include "Refusal.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
constexpr int MatchedPoints = 800; // of equal areas
} // namespace

Status HeldOrgan::Take(const IndexedMesh& moving, const IndexedMesh& fixed)
{
  this->Leave();
  HeldFit fit;
  if (Status status = HeldFit::Make(moving, fixed, HeldFitSettings::ForHand(fixed), fit);
      !status.IsOk())
  {
    return status;
  }
  this->Fit = std::make_shared<const HeldFit>(std::move(fit));
  this->Fixed = std::make_shared<const IndexedMesh>(fixed);
  this->Dense =
      std::make_shared<const std::vector<Vector3>>(PointsOfEqualArea(moving, MatchedPoints));
  this->Count = std::min(this->Dense->size(), moving.Triangles.size());
  this->Now = Phase::Lying;
  return Status::Success();
}

Status HeldOrgan::Take(vtkPolyData* moving, vtkPolyData* fixed)
{
  return this->Take(ToIndexedMesh(moving), ToIndexedMesh(fixed));
}

void HeldOrgan::Leave()
{
  this->Stop();
  this->Now = Phase::Absent;
  this->Placed = Eigen::Affine3d::Identity();
}

// Whatever goes on ends, where it is.
void HeldOrgan::Stop()
{
  if (this->Job)
  {
    this->Jobs.Cancel(*this->Job);
    this->Job.reset();
  }
  this->Hand.reset();
  this->Carrying.reset();
  this->Ramp.reset();
  this->RampBegan.reset();
  this->Matched.reset();
  this->Failure.clear();
  this->Now = this->Now == Phase::Absent ? Phase::Absent : Phase::Lying;
}

void HeldOrgan::PutBack()
{
  this->Stop();
  this->Placed = Eigen::Affine3d::Identity();
}

void HeldOrgan::Point()
{
  if (this->Now != Phase::Absent)
  {
    this->Stop();
    this->Hand.emplace(*this->Fit, PointSpring, this->Placed);
    this->Now = Phase::Pointed;
  }
}

void HeldOrgan::Carry(const Vector3& toolWorld)
{
  if (this->Now != Phase::Absent)
  {
    this->Stop();
    this->Carrying = std::make_shared<const HeldField>(this->Fit, this->Placed, toolWorld);
    this->Now = Phase::Carried;
  }
}

void HeldOrgan::Move(const Vector3& motion)
{
  if (this->Hand)
  {
    this->Hand->Move(motion);
  }
}

void HeldOrgan::Turn(const Vector3& rotation)
{
  if (this->Hand)
  {
    this->Hand->Turn(rotation);
    this->Placed = this->Rule.IsFelt ? this->Hand->Pose() : this->Hand->Asked();
  }
  else if (this->Carrying != nullptr)
  {
    HeldPose turned(*this->Fit, PointSpring, this->Placed);
    turned.Turn(rotation);
    const Vector3 tool = this->Carrying->ToolOf(this->Placed);
    this->Placed = turned.Pose();
    this->Carrying = std::make_shared<const HeldField>(this->Fit, this->Placed, tool);
  }
}

void HeldOrgan::FollowTool(const Vector3& toolWorld)
{
  if (this->Carrying != nullptr)
  {
    this->Placed = this->Carrying->PoseAt(toolWorld);
  }
}

void HeldOrgan::Release()
{
  if (!this->IsHeld())
  {
    return;
  }
  this->Stop();
  if (!this->Rule.IsMatched)
  {
    return;
  }
  SurfaceRegistrationSettings settings;
  settings.Kind = this->Rule.ChangesSize ? RegistrationKind::Similarity : RegistrationKind::Rigid;
  StudyJob job;
  job.IsUrgent = true;
  job.Work = [this, settings, points = this->Dense, fixed = this->Fixed,
              start = this->Placed](const ProgressFunction& progress)
  {
    SurfaceRegistration made;
    RequireInput(RegisterToSurface(
                     *points, *fixed, start, settings,
                     [&progress](double part) { return !progress || progress(part, "match"); },
                     made),
                 "the organ");
    return StudyJob::Delivery([this, made] { this->TakeMatch(made); });
  };
  job.Fail = [this](const std::string& message)
  {
    this->Job.reset();
    this->Failure = message;
    this->Now = Phase::Lying;
  };
  this->Job = this->Jobs.Start(std::move(job));
  this->Now = Phase::Matching;
}

void HeldOrgan::TakeMatch(const SurfaceRegistration& made)
{
  this->Job.reset();
  this->Matched = made;
  this->Ramp.emplace(this->Placed, made.Map, this->Fit->Pivot(), RampTime);
  this->Now = Phase::Moving;
}

bool HeldOrgan::Advance(double time)
{
  constexpr int MostSteps = 20;  // a view's frame has time for as many
  constexpr double Still = 1e-3; // mm
  if (this->Hand)
  {
    double way = 0.0;
    for (int step = 0; step < MostSteps && this->Rule.IsFelt; ++step)
    {
      way = this->Hand->Step();
      if (way < Still)
      {
        break;
      }
    }
    const Eigen::Affine3d& next = this->Rule.IsFelt ? this->Hand->Pose() : this->Hand->Asked();
    const bool isMoved = !this->Placed.isApprox(next, 1e-9);
    this->Placed = next;
    return isMoved;
  }
  if (!this->Ramp)
  {
    return false;
  }
  this->RampBegan = this->RampBegan.value_or(time);
  const double passed = time - *this->RampBegan;
  this->Placed = this->Ramp->At(passed);
  if (this->Ramp->IsOverAt(passed))
  {
    this->Placed = this->Matched->Map;
    this->Ramp.reset();
    this->Now = Phase::Lying;
  }
  return true;
}
} // namespace palpate
