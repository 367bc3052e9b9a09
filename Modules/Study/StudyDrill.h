#pragma once

#include "DrillBench.h"
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
/// How a structure stands that is drilled.
struct StudyDrilled
{
  int Id = 0;
  std::string Name;
  double RemovedVolume = 0.0;               ///< mm^3
  std::shared_ptr<const ScalarField> Field; ///< as it is now
  vtkSmartPointer<vtkPolyData> Cut;         ///< the surface of what is gone; world mm
};

/// What is drilled in a study now.
struct StudyDrillReading
{
  std::vector<StudyDrilled> Drilled;
  std::vector<DrillApproach> Approaches; ///< to what is forbidden
  bool CanUndo = false;
  bool CanRedo = false;
  std::string Problem; ///< in one sentence; empty without
  std::string Hold;    ///< why the pedal cuts nothing now, and the way out; empty where it cuts
};

/// What is drilled in a study: it stays while touches come and go, and begins again where the
/// drilled structures become others. Nothing can be cut while a forbidden structure's protection is
/// not ready (see Hold). For the thread that owns it.
class PALPATESTUDY_EXPORT StudyDrill
{
public:
  StudyDrill() = default;
  StudyDrill(const StudyDrill&) = delete;
  StudyDrill& operator=(const StudyDrill&) = delete;

  /// What follows is for these. Takes the time of copying the drilled fields where they are others
  /// or are protected otherwise. What was drilled before in the same fields stays.
  void Follow(const StudyState& state, const std::vector<SceneContact>& contacts,
              const std::vector<StudyForbidden>& forbidden);
  /// Whether the last Follow keeps the drill out of all of these.
  bool Protects(const std::vector<StudyForbidden>& forbidden) const;
  /// Lets a scene with a structure for each of the last Follow's contacts be drilled.
  void PutInto(TouchScene& scene) const;
  /// Why the scenes of now let nothing be cut, and the way out; empty where they do.
  const std::string& Hold() const { return this->HoldText; }
  /// Another one where a scene has to be published again.
  std::uint64_t Revision() const { return this->Changes; }

  /// Another servo has begun, which numbers its orders from 0.
  void FollowNextServo() { this->SeenNumber = ~std::uint64_t{0}; }
  /// What executes the orders; null where nothing is drilled.
  std::shared_ptr<DrillEditor> Editor() const;

  /// For views: what became of it, and how near the tool is. `time` in s.
  StudyDrillReading Read(double time, const TouchState& newest);

  bool IsEmpty() const { return this->Bench == nullptr; }
  /// See WriteDrillState and ReadDrillState; throw InputError. To be opened while nothing is
  /// touched.
  void Save(const std::filesystem::path& path) const;
  void Open(const std::filesystem::path& path);
  /// Writes what is left of a structure as a volume or as a surface, by the ending. Throws
  /// InputError.
  void Export(int id, const std::filesystem::path& path, const ProgressFunction& progress) const;

private:
  bool AreDrilled(const std::vector<SceneContact>& drilled) const;
  bool AreForbidden(const std::vector<StudyForbidden>& forbidden) const;
  void Renew(const StudyState& state, const std::vector<SceneContact>& drilled,
             const std::vector<StudyForbidden>& forbidden);
  void KeepWhatIsGone(const DrillBench& before, const std::vector<SceneContact>& drilledBefore);
  void ReadCuts();
  int SiteOf(int id) const;

  std::shared_ptr<DrillBench> Bench;
  std::unique_ptr<DrillWatch> Watch;
  std::vector<SceneContact> Drilled;
  std::vector<StudyForbidden> Forbidden; // with their protections
  std::string HoldText;
  std::vector<int> SiteOfContact; // -1: it is not drilled
  TouchToolSettings Tool;
  TouchDrillSettings Motion;
  std::uint64_t Changes = 0;
  std::uint64_t SeenNumber = ~std::uint64_t{0}; // of what the reading has
  double CutTime = -1.0;                        // s, of the last look at cuts
  StudyDrillReading Known;
};
} // namespace palpate
