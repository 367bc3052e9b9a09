#pragma once

#include "PalpateStudyModule.h"
#include "StudyDrill.h"
#include "StudyJobs.h"
#include "StudyState.h"

#include <filesystem>
#include <string>

namespace palpate
{
class Study;

/// A study that was not saved, as it was kept in a folder.
struct RecoveredStudy
{
  StudyState State;
  std::filesystem::path FormerFile; ///< of the study; empty if it had none
  std::filesystem::path Drilled;    ///< the file with what was drilled; may be empty
};

/// The session file in a folder of a recovery, which is there if anything was kept.
PALPATESTUDY_EXPORT std::filesystem::path RecoverySession(const std::filesystem::path& folder);
/// Throws InputError if nothing was kept there, or it is damaged.
PALPATESTUDY_EXPORT RecoveredStudy ReadRecovery(const std::filesystem::path& folder);

/// Keeps what was not saved of a study in a folder that only the user can open: a session file,
/// what was drilled, and the path of the study's file. A worker of its own writes them, which no
/// long step of the pipeline delays. Owner thread of the study only.
class PALPATESTUDY_EXPORT StudyRecovery
{
public:
  /// Keeps the address. The folder is made when it is first needed.
  StudyRecovery(Study& study, std::filesystem::path folder);

  const std::filesystem::path& Folder() const { return this->Place; }
  /// Whether the study was changed, and differs from what is kept or being written. Call it and
  /// Keep only while the drill does not turn: a copy ends its stroke.
  bool IsDue() const;
  /// Starts to write if IsDue and nothing is being written.
  void Keep();
  /// Takes over what was written.
  void Deliver() { this->Jobs.Deliver(); }
  /// Waits until it is written.
  void Finish();
  bool IsWriting() const { return this->IsRunning; }
  /// Whether there is something to recover.
  bool HasKept() const { return this->IsKept; }
  /// Why the last writing failed; may be empty.
  const std::string& Problem() const { return this->Message; }
  /// Removes what was kept, once the study is saved or given up.
  void Forget();
  /// The study was recovered from this folder, which keeps it from now on.
  void Adopt(const std::filesystem::path& folder);

private:
  void Remove();

  Study& Open;
  std::filesystem::path Place;
  StudyState State; ///< kept last, or being written
  StudyDrillCopy Drilled;
  bool IsCurrent = false; ///< State and Drilled are what is in the folder, or will be
  bool IsRunning = false;
  bool IsUnwanted = false; ///< what is being written
  bool IsKept = false;
  std::string Message;
  StudyJobs Jobs;
};

/// Removes what was kept in a folder.
PALPATESTUDY_EXPORT void RemoveRecovery(const std::filesystem::path& folder);
} // namespace palpate
