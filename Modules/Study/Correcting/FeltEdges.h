#pragma once

#include "PalpateStudyModule.h"
#include "SceneContacts.h"
#include "StudyJobs.h"
#include "Volume.h"

#include <memory>
#include <optional>
#include <vector>

namespace palpate
{
/// Edges of a volume that a hand feels around a structure, such as while it paints there: a small
/// force towards them (MakeEdgeForce), made by a job. Owner thread only.
class PALPATESTUDY_EXPORT FeltEdges
{
public:
  static constexpr double Margin = 20.0;   ///< mm around the structure, as it may grow
  static constexpr double Smoothing = 1.0; ///< of the volume, mm

  /// Keeps the address.
  explicit FeltEdges(StudyJobs& jobs) : Jobs(jobs) {}
  FeltEdges(const FeltEdges&) = delete;
  FeltEdges& operator=(const FeltEdges&) = delete;
  ~FeltEdges() { this->Stop(); }

  /// Of which volume, around which of the contacts; a null volume, or none of this id: none.
  void Follow(std::shared_ptr<const Volume> volume, int structureId,
              const std::vector<SceneContact>& contacts);
  /// Whether they are being made.
  bool IsWorking() const { return this->Working.has_value(); }
  /// Why there are none; may be empty.
  const std::string& Problem() const { return this->Message; }

  /// Adds the force to the structure, unless it has one along an image of its own.
  void AddTo(std::vector<SceneContact>& contacts) const;
  void AddTo(SceneSettings& scene) const;

private:
  void Stop();
  void Make(const Eigen::AlignedBox3d& bounds);

  StudyJobs& Jobs;
  std::shared_ptr<const Volume> Image; ///< null: none
  int Id = 0;
  Eigen::AlignedBox3d Reach; ///< where edges are felt, or are being made; mm
  std::optional<StudyJobs::Id> Working;
  std::shared_ptr<const ForceEffect> Force;
  std::string Message;
};
} // namespace palpate
