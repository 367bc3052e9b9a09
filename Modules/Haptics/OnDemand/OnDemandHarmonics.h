#pragma once

#include "HarmonicContactModel.h"
#include "TrackerSlot.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace palpate
{
/// A structure of spherical harmonics whose model and stand-ins are made when the tool comes near,
/// with a tracker for everybody who is attached, and dropped again. Its coefficients stay, and a
/// coarse body that holds all of them.
///
/// Attach: publishing threads. Bring, Drop: one thread that is not the servo's. Others: any.
class OnDemandHarmonics
{
public:
  struct Settings
  {
    HarmonicContactMode Mode = HarmonicContactMode::Nearest;
    EvaluationPrecision Precision = EvaluationPrecision::Double;
    std::vector<int> StandIns; ///< lower degrees, falling; those that cannot be felt are left out
    ToolShape Tool = ToolShape::Sphere(1.0);
  };
  /// The highest degree of those whose tables are the smallest there are; what has no more gains
  /// nothing by being on demand.
  static constexpr int CoarseDegree = 4;

  /// Makes everything once, to know what it takes, and keeps the coarse body. Refuses what
  /// HarmonicContactModel and its trackers refuse.
  static Status Make(const std::shared_ptr<const SphericalHarmonicModel>& model,
                     const Settings& settings, std::shared_ptr<OnDemandHarmonics>& made);

  /// Of the model and, from 1 on, of its stand-ins.
  std::size_t RungCount() const noexcept { return this->Rungs.size(); }
  int DegreeOf(std::size_t rung) const { return this->Rungs[rung].Model->Degree(); }
  const Eigen::AlignedBox3d& BoundsOf(std::size_t rung) const { return this->Rungs[rung].Bounds; }
  /// Of all of them, mm.
  const Eigen::AlignedBox3d& BoundsWorld() const noexcept { return this->Bounds; }
  const std::shared_ptr<const ContactModel>& Coarse() const noexcept { return this->CoarseBody; }
  /// By which the coarse body is raised, mm.
  double RaisedBy() const noexcept { return this->Raised; }
  /// How long it took to make all that is not kept, s.
  double MakingSeconds() const noexcept { return this->Seconds; }
  /// How far a place is outside of the coarse body along its own radius (mm); negative inside.
  double HeightOver(const Vector3& placeWorld) const noexcept;

  /// For a tracker at one rung, with what it follows in it where that is at hand. Refuses what
  /// HarmonicContactModel refuses.
  Status Attach(std::size_t rung, const ToolShape& tool, const SurfaceFriction& friction,
                std::shared_ptr<TrackerSlot>& slot);

  /// Makes what is missing for all who are attached, and asks nothing back.
  Status Bring();
  /// Drops what nobody holds and asks the rest back. Whether nothing is left.
  bool Drop();
  bool IsAtHand() const;

  std::size_t KeptBytes() const noexcept { return this->Kept; }
  /// Of what Bring makes, with the trackers.
  std::size_t BytesAtHand() const;
  /// Of all there is now.
  std::size_t Bytes() const;

  /// Ticks that touched the coarse body, since the tool came before the model.
  std::uint64_t CoarseTicks() const noexcept
  {
    return this->Coarsely.load(std::memory_order_relaxed);
  }
  /// By trackers.
  void CountCoarseTick() noexcept { this->Coarsely.fetch_add(1, std::memory_order_relaxed); }

private:
  struct Rung
  {
    std::shared_ptr<const SphericalHarmonicModel> Model;
    Eigen::AlignedBox3d Bounds;
    std::size_t Bytes = 0;        // of the contact model
    std::size_t TrackerBytes = 0; // of each tracker
    std::shared_ptr<const ContactModel> AtHand;
  };
  struct Link
  {
    std::size_t Rung;
    ToolShape Tool;
    SurfaceFriction Friction;
    std::weak_ptr<TrackerSlot> Slot;
  };

  explicit OnDemandHarmonics(const Settings& settings) : Wanted(settings) {}
  Status MakeCoarse(const SphericalHarmonicModel& model);
  Status AddRung(const std::shared_ptr<const SphericalHarmonicModel>& model);
  Status Fill(const Link& link);
  void ForgetLinks();

  Settings Wanted;
  Eigen::AlignedBox3d Bounds;
  std::shared_ptr<const SphericalHarmonicModel> CoarseModel;
  std::shared_ptr<const ContactModel> CoarseBody;
  double Raised = 0.0;
  double Seconds = 0.0;
  std::size_t Kept = 0;
  std::atomic<std::uint64_t> Coarsely{0};
  mutable std::mutex Shared; // by the bringing and the publishing thread: what follows
  std::vector<Rung> Rungs;   // only what is at hand changes
  std::vector<Link> Links;
};
} // namespace palpate
