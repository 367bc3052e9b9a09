#pragma once

#include "DrillContext.h"
#include "DrillRecords.h"
#include "DrillWatch.h"
#include "PalpateStudyModule.h"
#include "SceneContacts.h"
#include "StudyForbidden.h"
#include "StudyState.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// State of a drilled structure.
struct StudyDrilled
{
  int Id = 0;
  std::string Name;
  double RemovedVolume = 0.0;               ///< mm^3
  std::shared_ptr<const ScalarField> Field; ///< current version
  vtkSmartPointer<vtkPolyData> Cut;         ///< surface of the removed volume; world mm
};

/// Current state of drilling in a study.
struct StudyDrillReading
{
  std::vector<StudyDrilled> Drilled;
  std::vector<DrillApproach> Approaches; ///< to forbidden structures
  bool CanUndo = false;
  bool CanRedo = false;
  std::string Problem; ///< a message; may be empty
  std::string Hold;    ///< why drilling is off, and what to do; empty if it is on
};

/// What was removed in a study, at one moment.
struct StudyDrillSnapshot
{
  std::vector<DrillRecord> Records; ///< empty if nothing was removed
  /// Of each drilled structure; null: nothing.
  std::vector<std::shared_ptr<const RemovedDistances>> Removed;
};

/// The same, of which the records are made later, on any thread.
struct StudyDrillCopy
{
  std::vector<std::shared_ptr<const RemovedDistances>> Removed; ///< as in StudyDrillSnapshot
  std::size_t SetAside = 0;                                     ///< number of regions
  std::function<std::vector<DrillRecord>()> Records;            ///< owns all that it needs

  /// Whether nothing was removed, restored or set aside between the two.
  bool IsLike(const StudyDrillCopy& other) const
  {
    return this->Removed == other.Removed && this->SetAside == other.SetAside;
  }
};

/// Drilling in a study: kept between touches. What was removed from a structure that is no longer
/// drilled is set aside, and removed again once the same voxels are drilled. Drilling is off while
/// a forbidden structure's protection is not ready (see Hold). Owner thread only.
class PALPATESTUDY_EXPORT StudyDrill
{
public:
  StudyDrill() = default;
  StudyDrill(const StudyDrill&) = delete;
  StudyDrill& operator=(const StudyDrill&) = delete;

  /// Adopts these contacts and protections. Copies the drilled fields if they or their protection
  /// changed. What was removed from the same fields before stays removed.
  void Follow(const StudyState& state, const std::vector<SceneContact>& contacts,
              const std::vector<StudyForbidden>& forbidden);
  /// Whether the last Follow protects all of these.
  bool Protects(const std::vector<StudyForbidden>& forbidden) const;
  /// Makes a scene drillable that has one structure for each of the last Follow's contacts.
  void PutInto(TouchScene& scene) const;
  /// Why drilling is off, and what to do; empty if it is on.
  const std::string& Hold() const { return this->HoldText; }
  /// Changes when a scene has to be published again.
  std::uint64_t Revision() const { return this->Changes; }

  /// Call when another servo has started, which numbers its orders from 0.
  void FollowNextServo() { this->SeenNumber = ~std::uint64_t{0}; }
  /// Executes the orders; null if nothing is drilled.
  std::shared_ptr<DrillEditor> Editor() const;

  /// Current state for views, with the tool's distances to forbidden structures. `time` in s.
  StudyDrillReading Read(double time, const TouchState& newest);

  /// The newest one, whether touch is on or off.
  const StudyDrillReading& Last() const { return this->Known; }
  /// Updates Last once a servo has ended.
  void Finish();

  /// Forgets everything, for another study.
  void Clear();
  /// Sets aside what was removed according to a session's file.
  void Await(const std::vector<DrillRecord>& records);
  /// Whether something is set aside.
  bool IsAwaiting() const { return !this->Aside.empty(); }
  /// Why something that was set aside was not removed again; may be empty.
  const std::string& RestoreProblem() const { return this->Unfit; }
  /// To be saved, including what is set aside. Ends the current stroke.
  StudyDrillSnapshot Take() const;
  /// The same without the work of making records.
  StudyDrillCopy Copy() const;
  void MarkSaved(const StudyDrillSnapshot& snapshot);
  /// Whether anything was removed, or undone, since it was saved.
  bool IsChanged() const;

  /// See RestoreDrillState; an undo step. Only while touch is off. Throws InputError.
  void Open(const std::vector<DrillRecord>& records, const std::filesystem::path& path);
  /// Writes a drilled structure as a volume or a surface, by the ending; may be called on any
  /// thread, while drilling goes on. Throws InputError.
  std::function<void(const ProgressFunction&)> Exporting(int id,
                                                         const std::filesystem::path& path) const;

private:
  using State = std::shared_ptr<const RemovedDistances>;
  // What was removed from voxels that are not drilled now.
  struct SetAside
  {
    DrillRecord Record;
    bool IsSaved = true;
  };

  bool AreDrilled(const std::vector<SceneContact>& drilled) const;
  bool AreForbidden(const std::vector<StudyForbidden>& forbidden) const;
  void Renew(const StudyState& state, const std::vector<SceneContact>& drilled,
             const std::vector<StudyForbidden>& forbidden);
  void KeepRemoved(const DrillContext& before, const std::vector<SceneContact>& drilledBefore,
                   const std::vector<State>& savedBefore, std::vector<State>& removed);
  void RestoreAside(std::vector<State>& removed);
  void ReadFields();
  void ReadCuts();
  int SiteOf(int id) const;

  std::shared_ptr<DrillContext> Context;
  std::unique_ptr<DrillWatch> Watch;
  std::vector<SceneContact> Drilled;
  std::vector<StudyForbidden> Forbidden; // with their protections
  std::string HoldText;
  std::vector<int> SiteOfContact; // -1: not drilled
  std::vector<State> Saved;       // of each site, as in StudyDrillSnapshot
  std::vector<SetAside> Aside;
  bool IsAwaited = false; // something was set aside since the last Renew
  std::string Unfit;
  TouchToolSettings Tool;
  TouchDrillSettings Motion;
  std::uint64_t Changes = 0;
  std::uint64_t SeenNumber = ~std::uint64_t{0}; // of the order in the last reading
  double CutTime = -1.0;                        // s, of the last reading of cuts
  StudyDrillReading Known;
};
} // namespace palpate
