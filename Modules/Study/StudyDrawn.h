#pragma once

#include "DrawnOrgan.h"
#include "PalpateStudyModule.h"
#include "SceneContacts.h"
#include "StudyJobs.h"
#include "StudyState.h"

#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// The organ that is drawn by touch, as a study has it: its prior, which is read by a job, its
/// surface, and its contact, by which the tool feels it. Owner thread only.
class PALPATESTUDY_EXPORT StudyDrawn
{
public:
  /// Of the structure that the tool feels; no other structure has it.
  static constexpr int StructureId = std::numeric_limits<int>::max();

  /// Keeps the address.
  explicit StudyDrawn(StudyJobs& jobs) : Jobs(jobs) {}
  StudyDrawn(const StudyDrawn&) = delete;
  StudyDrawn& operator=(const StudyDrawn&) = delete;
  ~StudyDrawn();

  /// Follows the drawing; once its prior has been read, if it has one.
  void Follow(const StudyDrawing& drawing);
  const DrawnOrgan& Organ() const { return this->Drawn; }
  bool IsReadingPrior() const { return this->Reading.has_value(); }
  /// Why smoothness alone is used although the drawing has a prior; may be empty.
  const std::string& PriorProblem() const { return this->Problem; }
  /// Null: smoothness alone.
  const ShapePrior* Prior() const { return this->Known.get(); }

  /// Adds the organ to what is felt, unless it is refused or the drawing leaves it out.
  void AddTo(std::vector<SceneContact>& contacts) const;
  void AddTo(SceneSettings& scene) const;

private:
  void ReadPrior();
  void Complete();

  StudyJobs& Jobs;
  StudyDrawing Drawing;
  std::filesystem::path PriorFile;         ///< that Known is from, or is being read
  std::shared_ptr<const ShapePrior> Known; ///< null: none
  std::optional<StudyJobs::Id> Reading;
  std::string Problem;
  DrawnOrgan Drawn;
  std::uint64_t ContactRevision = 0; ///< of the organ that the contact is of
  std::optional<SceneContact> Contact;
};

/// The state with the drawn organ as a structure of this name, whose model has been written to a
/// file, and with no touches any more.
PALPATESTUDY_EXPORT StudyState WithKeptOrgan(const StudyState& state, const std::string& name,
                                             const std::filesystem::path& model);
} // namespace palpate
