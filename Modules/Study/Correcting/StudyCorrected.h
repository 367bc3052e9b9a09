#pragma once

#include "PalpateStudyModule.h"
#include "SceneContacts.h"
#include "StudyCorrection.h"
#include "StudyJobs.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// The structure that is being corrected, as a study has it: its surface, which a pull moves at
/// once; and measured by a job within a second or so, how it differs from the start, and the
/// surface of the result, which the tool feels. Owner thread only.
class PALPATESTUDY_EXPORT StudyCorrected
{
public:
  static constexpr const char* ChangeArray =
      "SignedDistance"; ///< of the surface, mm from the start

  /// Keeps the address.
  explicit StudyCorrected(StudyJobs& jobs) : Jobs(jobs) {}
  StudyCorrected(const StudyCorrected&) = delete;
  StudyCorrected& operator=(const StudyCorrected&) = delete;
  ~StudyCorrected();

  /// Whether a structure can be corrected: a label, or a model.
  static bool IsCorrectable(const SceneStructure& structure);
  /// Follows the correction of a scene's structure. `open` is the file of a segmentation that
  /// others read, and `labels` what they read, null until then; a job reads other files.
  void Follow(const SceneSettings& scene, const StudyCorrection& correction,
              const std::filesystem::path& open, std::shared_ptr<const Segmentation> labels);

  /// Whether there is a surface that has all steps.
  bool IsReady() const { return this->Shape && this->Shape->Steps() == this->Given.Steps; }
  bool IsWorking() const { return this->Working.has_value() || this->Measuring.has_value(); }
  /// Why a step could not be done, or there is no surface; may be empty.
  const std::string& Problem() const { return this->Message; }
  int StructureId() const { return this->Given.StructureId; }
  bool IsMask() const { return this->Shape && this->Shape->IsMask(); }
  /// The mask as far as steps are done, null until then and for a model.
  const CorrectedMask* Voxels() const { return this->Shape ? this->Shape->Voxels() : nullptr; }
  /// Null until it is ready the first time.
  const SurfaceCorrection* Pulls() { return this->Shape ? &this->Shape->Pulls() : nullptr; }
  /// With all steps. Throws InputError as CorrectedShape::Do does, and if there is no surface.
  CorrectedShape Result() const;
  /// Null until it is measured.
  const CorrectionChange* Change() const { return this->Measured.get(); }

  /// The surface as it is now, or would be with the pull of Preview, with ChangeArray; of what is
  /// measured, the result's, which ends at neighbours. Null without one; another one after each
  /// change.
  vtkPolyData* Surface() const { return this->Drawn; }
  /// Whether it differs from that at the start.
  bool IsMoved() const { return this->IsPreviewed || !this->Given.Steps.empty(); }
  /// Increases whenever the surface, the change or the problem differs.
  std::uint64_t Revision() const { return this->Changes; }
  /// Shows the surface as it would be, or as it is. Fails as SurfaceCorrection::Preview.
  Status Preview(const SurfacePull& pull);
  void EndPreview();

  /// Replaces the contact of the structure, if it is felt, by that of the result.
  void AddTo(std::vector<SceneContact>& contacts) const;
  /// While the hand leads a pull, the structure is not felt: it must not hold the hand back.
  void LetGo(bool isHeld) { this->IsHeld = isHeld; }

private:
  void Forget();
  void Stop(std::optional<StudyJobs::Id>& job);
  bool IsQuick() const;
  void Work();
  void DoNow();
  void DoLater();
  void Finish(const std::string& problem);
  void Measure();
  void Draw(const Eigen::Matrix3Xd& displacements);
  void DrawNow();

  StudyJobs& Jobs;
  StudyCorrection Given;
  SceneStructure Structure; ///< that is corrected
  LeftHandedAxes LeftHanded = LeftHandedAxes::Reverse;
  std::shared_ptr<const Segmentation> Labels; ///< null: from the structure's file
  std::optional<CorrectedShape> Shape;
  std::optional<StudyJobs::Id> Working;
  std::optional<StudyJobs::Id> Measuring;
  std::shared_ptr<const CorrectionChange> Measured;
  std::shared_ptr<const TouchContact> Contact; ///< of what was measured last
  vtkSmartPointer<vtkPolyData> Drawn;
  std::string Message;
  bool IsPreviewed = false;
  bool IsHeld = false;
  std::uint64_t Changes = 0;
};
} // namespace palpate
