#pragma once

#include "HeldField.h"
#include "HeldPose.h"
#include "PalpateStudyModule.h"
#include "StudyJobs.h"
#include "SurfaceRegistration.h"

#include "vtkPolyData.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace palpate
{
/// How a held organ behaves.
struct HoldRules
{
  bool IsFelt = true;       ///< it resists a pointing hand where it fits, as it does a device's
  bool IsMatched = true;    ///< let go, it is brought onto the other one; else it stays
  bool ChangesSize = false; ///< by the match
};

/// An organ that a hand holds, brings near another one and lets go, upon which an optimiser brings
/// it onto the other one, from where it was held (RegisterToSurface); it goes there smoothly. By
/// other rules it stays where it is let go. Its pose is a map of the world (mm) from where it was
/// taken. Owner thread only.
class PALPATESTUDY_EXPORT HeldOrgan
{
public:
  enum class Phase
  {
    Absent,   ///< nothing was taken
    Lying,    ///< where it was taken, let go or moved last
    Pointed,  ///< held by a pointing hand, which it follows by a spring
    Carried,  ///< held by a device's tool
    Matching, ///< the optimiser works
    Moving    ///< to where the optimiser has it
  };
  static constexpr double RampTime = 0.6;    ///< s, of Moving
  static constexpr double PointSpring = 0.2; ///< N/mm, of a pointing hand

  /// Keeps the address.
  explicit HeldOrgan(StudyJobs& jobs) : Jobs(jobs) {}
  HeldOrgan(const HeldOrgan&) = delete;
  HeldOrgan& operator=(const HeldOrgan&) = delete;
  ~HeldOrgan() { this->Leave(); }

  /// Takes an organ, and the one that it is brought onto, as they are (world, mm). Fails as
  /// HeldFit::Make does; then nothing is taken.
  Status Take(const IndexedMesh& moving, const IndexedMesh& fixed);
  Status Take(vtkPolyData* moving, vtkPolyData* fixed);
  void Leave();
  /// From the next motion on.
  void SetRules(const HoldRules& rules) { this->Rule = rules; }
  const HoldRules& Rules() const { return this->Rule; }
  /// Back to where it was taken.
  void PutBack();

  ///@{ No effect unless something was taken. A grasp ends Matching and Moving where they are.
  void Point();
  void Carry(const Vector3& toolWorld); ///< see Field
  ///@}
  void Move(const Vector3& motion);          ///< mm, of the pointing hand
  void Turn(const Vector3& rotation);        ///< rad, about the organ's middle, while it is held
  void FollowTool(const Vector3& toolWorld); ///< while it is carried
  /// Lets go: the optimiser starts, by a job, unless the rules leave the organ where it is.
  void Release();
  /// Follows the hand or the ramp; `time` (s) is any that runs. Returns whether the pose changed.
  bool Advance(double time);

  Phase Is() const { return this->Now; }
  bool IsHeld() const { return this->Now == Phase::Pointed || this->Now == Phase::Carried; }
  const Eigen::Affine3d& Pose() const { return this->Placed; }
  /// mm: the organ's middle, where it is now.
  Vector3 Middle() const { return this->Placed * this->Fit->Pivot(); }
  /// What the surfaces do to the hand now.
  HeldForce Felt() const { return this->Fit->At(this->Placed); }
  /// What a device feels; null unless it carries the organ. Another one after each Turn.
  const std::shared_ptr<const HeldField>& Field() const { return this->Carrying; }
  /// How the optimiser left it; none if it was held since.
  const std::optional<SurfaceRegistration>& Match() const { return this->Matched; }
  /// Different points of the organ that a match is made of.
  std::size_t PointCount() const { return this->Count; }
  /// Why there is no match; may be empty.
  const std::string& Problem() const { return this->Failure; }

private:
  void Stop();
  void TakeMatch(const SurfaceRegistration& made);

  StudyJobs& Jobs;
  HoldRules Rule;
  Phase Now = Phase::Absent;
  std::shared_ptr<const HeldFit> Fit;
  std::shared_ptr<const IndexedMesh> Fixed;
  std::shared_ptr<const std::vector<Vector3>> Dense; ///< points that the optimiser uses
  std::size_t Count = 0;
  Eigen::Affine3d Placed = Eigen::Affine3d::Identity();
  std::optional<HeldPose> Hand;
  std::shared_ptr<const HeldField> Carrying;
  std::optional<StudyJobs::Id> Job;
  std::optional<PoseRamp> Ramp;
  std::optional<double> RampBegan;
  std::optional<SurfaceRegistration> Matched;
  std::string Failure;
};
} // namespace palpate
