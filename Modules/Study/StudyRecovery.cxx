#include "StudyRecovery.h"

#include "Refusal.h"
#include "Study.h"
#include "StudyFile.h"
#include "WholeFile.h"

#include <system_error>
#include <utility>

namespace palpate
{
namespace
{
constexpr const char* FormerName = "former-file";
constexpr std::uintmax_t LongestPath = 1 << 16;

void MakePrivate(const std::filesystem::path& folder)
{
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  if (!failure)
  {
    std::filesystem::permissions(folder, std::filesystem::perms::owner_all, failure);
  }
  if (failure)
  {
    Refuse(folder, "cannot be made a folder of the user alone: " + failure.message(),
           "make room there, or allow it");
  }
}

// The session last: with it, there is something to recover.
void WriteRecovery(const std::filesystem::path& folder, const StudyState& state,
                   const std::filesystem::path& former, const std::vector<DrillRecord>& drilled)
{
  MakePrivate(folder);
  if (former.empty())
  {
    std::error_code failure;
    std::filesystem::remove(folder / FormerName, failure);
  }
  else
  {
    WriteWholeFile(folder / FormerName, former.string());
  }
  const std::filesystem::path session = RecoverySession(folder);
  WriteStudy(session, state, SaveDrilled(session, {drilled, {}}));
}
} // namespace

std::filesystem::path RecoverySession(const std::filesystem::path& folder)
{
  return folder / (std::string("study") + StudyEnding);
}

RecoveredStudy ReadRecovery(const std::filesystem::path& folder)
{
  RecoveredStudy kept;
  kept.State = ReadStudy(RecoverySession(folder), &kept.Drilled);
  std::error_code failure;
  if (std::filesystem::exists(folder / FormerName, failure))
  {
    kept.FormerFile = ReadWholeFile(folder / FormerName, LongestPath);
  }
  return kept;
}

void RemoveRecovery(const std::filesystem::path& folder)
{
  const std::filesystem::path session = RecoverySession(folder);
  std::filesystem::path drilled = session;
  drilled.replace_extension().replace_extension(".palpate.drill");
  std::error_code failure;
  for (const std::filesystem::path& file : {session, drilled, folder / FormerName})
  {
    std::filesystem::remove(file, failure);
  }
}

StudyRecovery::StudyRecovery(Study& study, std::filesystem::path folder)
    : Open(study), Place(std::move(folder))
{
}

bool StudyRecovery::IsDue() const
{
  return this->Open.IsChanged() && !this->Open.IsReadingDrilled() &&
         !(this->IsCurrent && this->State == this->Open.State() &&
           this->Drilled.IsLike(this->Open.Touch().Drill().Copy()));
}

void StudyRecovery::Keep()
{
  if (this->IsRunning || !this->IsDue())
  {
    return;
  }
  this->State = this->Open.State();
  this->Drilled = this->Open.Touch().Drill().Copy();
  this->IsCurrent = true;
  this->IsRunning = true;
  StudyJob job;
  job.Work = [this, folder = this->Place, state = this->State, former = this->Open.ProposedFile(),
              records = this->Drilled.Records](const ProgressFunction&)
  {
    WriteRecovery(folder, state, former, records());
    return StudyJob::Delivery(
        [this]
        {
          this->IsRunning = false;
          this->IsKept = true;
          this->Message.clear();
          if (std::exchange(this->IsUnwanted, false))
          {
            this->Remove();
          }
        });
  };
  job.Fail = [this](const std::string& message)
  {
    this->IsRunning = false;
    this->IsUnwanted = false;
    this->IsCurrent = false;
    this->Message = message;
  };
  this->Jobs.Start(std::move(job));
}

void StudyRecovery::Finish()
{
  while (this->IsRunning && this->Jobs.WaitForResult())
  {
    this->Deliver();
  }
}

void StudyRecovery::Forget()
{
  this->Message.clear();
  this->IsUnwanted = this->IsRunning;
  if (!this->IsRunning)
  {
    this->Remove();
  }
}

void StudyRecovery::Remove()
{
  this->IsCurrent = false;
  this->IsKept = false;
  RemoveRecovery(this->Place);
}

void StudyRecovery::Adopt(const std::filesystem::path& folder)
{
  this->Place = folder;
  this->IsKept = true;
  this->IsCurrent = false; // once something has changed, or soon: what was drilled is still read
}
} // namespace palpate
