#pragma once

#include "DrillContext.h"
#include "DrillWatch.h"
#include "PalpateStudyModule.h"
#include "SceneContacts.h"
#include "StudyForbidden.h"
#include "StudyState.h"

#include <filesystem>
#include <map>
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

/// Drilling in a study: kept between touches, and reset when the drilled structures change.
/// Drilling is off while a forbidden structure's protection is not ready (see Hold). Owner thread
/// only.
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

  /// The newest one, also after a touch; empty once the drilled structures have changed.
  const StudyDrillReading& Last() const { return this->Known; }

  bool IsEmpty() const { return this->Context == nullptr; }
  /// See WriteDrillState and ReadDrillState; throw InputError. Open only while touch is off.
  void Save(const std::filesystem::path& path) const;
  void Open(const std::filesystem::path& path);
  /// Writes a drilled structure as a volume or a surface, by the ending. Throws InputError.
  void Export(int id, const std::filesystem::path& path, const ProgressFunction& progress) const;

private:
  bool AreDrilled(const std::vector<SceneContact>& drilled) const;
  bool AreForbidden(const std::vector<StudyForbidden>& forbidden) const;
  void Renew(const StudyState& state, const std::vector<SceneContact>& drilled,
             const std::vector<StudyForbidden>& forbidden);
  void KeepWhatIsGone(const DrillContext& before, const std::vector<SceneContact>& drilledBefore);
  void ReadCuts();
  int SiteOf(int id) const;

  std::shared_ptr<DrillContext> Context;
  std::unique_ptr<DrillWatch> Watch;
  std::vector<SceneContact> Drilled;
  std::vector<StudyForbidden> Forbidden; // with their protections
  std::string HoldText;
  std::vector<int> SiteOfContact; // -1: not drilled
  TouchToolSettings Tool;
  TouchDrillSettings Motion;
  std::uint64_t Changes = 0;
  std::uint64_t SeenNumber = ~std::uint64_t{0}; // of the order in the last reading
  double CutTime = -1.0;                        // s, of the last reading of cuts
  StudyDrillReading Known;
};
} // namespace palpate
