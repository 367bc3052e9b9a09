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
/// The organ that is drawn by touch, as a study has it: its prior and the known organ that it
/// relates to, which are read by jobs, its surface, and its contact, by which the tool feels it.
/// Owner thread only.
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

  /// Follows the state's drawing; once its prior and the known organ have been read, if it has
  /// any.
  void Follow(const StudyState& state);
  const DrawnOrgan& Organ() const { return this->Drawn; }
  bool IsReadingPrior() const { return this->Reading.has_value(); }
  /// Why smoothness alone is used although the drawing has a prior; may be empty.
  const std::string& PriorProblem() const { return this->Problem; }
  bool HasPrior() const { return this->PriorCases().has_value(); }
  /// None: smoothness alone.
  std::optional<std::size_t> PriorCases() const;
  /// Of the prior to another organ; null: none.
  const OrganRelation* Relation() const;
  /// The structure that is that organ, see KnownStructure; null: none.
  const SceneStructure* Known() const { return this->KnownFrom ? &*this->KnownFrom : nullptr; }
  bool IsReadingKnown() const { return this->ReadingKnown.has_value(); }
  /// Why that organ is left out; may be empty.
  const std::string& KnownProblem() const { return this->KnownFailure; }

  /// Adds the organ to what is felt, unless it is refused or the drawing leaves it out; softened
  /// where it is uncertain, if the drawing says so.
  void AddTo(std::vector<SceneContact>& contacts) const;
  void AddTo(SceneSettings& scene) const;

private:
  void Stop(std::optional<StudyJobs::Id>& job);
  void ReadPrior();
  void FollowKnown();
  void ReadKnown();
  void Complete();
  void Soften();
  void MakeContact();
  void TakeContact(std::shared_ptr<const TouchContact> contact);

  StudyJobs& Jobs;
  StudyState State;
  std::filesystem::path PriorFile; ///< that Prior is from, or is being read
  OrganPrior Prior;
  std::optional<StudyJobs::Id> Reading;
  std::string Problem;
  std::optional<SceneStructure> KnownFrom; ///< that KnownSurface is from, or is being read
  std::shared_ptr<const LogSurface> KnownSurface;
  std::optional<StudyJobs::Id> ReadingKnown;
  std::string KnownFailure;
  DrawnOrgan Drawn;
  std::uint64_t ContactRevision = 0; ///< of the organ that the contact is of, or is made of
  std::optional<StudyJobs::Id> MakingContact;
  std::optional<SceneContact> Contact;
  std::shared_ptr<const ImageEffects>
      Softness; ///< of the organ as it is; null: it could not be made
};

/// The state with the drawn organ as a structure of this name, whose model has been written to a
/// file, and with no touches any more.
PALPATESTUDY_EXPORT StudyState WithKeptOrgan(const StudyState& state, const std::string& name,
                                             const std::filesystem::path& model);
} // namespace palpate
