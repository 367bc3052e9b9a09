#include "StudyDrillFiles.h"

#include "InputError.h"
#include "StudyFile.h"

#include <utility>

namespace palpate
{
std::filesystem::path SaveDrilled(const std::filesystem::path& session,
                                  const StudyDrillSnapshot& snapshot)
{
  if (snapshot.Records.empty())
  {
    return {};
  }
  constexpr const char* Ending = ".palpate.drill";
  const std::string ending = StudyEnding;
  std::string name = session.filename().string();
  if (RoleByName(session) == StudyFileRole::Session)
  {
    name.resize(name.size() - ending.size());
  }
  const std::filesystem::path file = StudyPath(session).parent_path() / (name + Ending);
  WriteDrillRecords(file, snapshot.Records);
  return file;
}

void StudyDrillFiles::Read(const std::filesystem::path& file, Taking take, Failing fail)
{
  this->Cancel();
  StudyJob job;
  job.IsUrgent = true;
  job.Work = [this, file, take = std::move(take), fail](const ProgressFunction&)
  {
    return StudyJob::Delivery(
        [this, take, fail, records = ReadDrillRecords(file)]
        {
          this->Reading.reset();
          try
          {
            take(records);
          }
          catch (const InputError& error)
          {
            this->Fail(error.what(), fail);
          }
        });
  };
  job.Fail = [this, fail](const std::string& message)
  {
    this->Reading.reset();
    this->Fail(message, fail);
  };
  this->Reading = this->Jobs.Start(std::move(job));
}

void StudyDrillFiles::Cancel()
{
  this->Unread.clear();
  if (this->Reading)
  {
    this->Jobs.Cancel(*this->Reading);
    this->Reading.reset();
  }
}

void StudyDrillFiles::Fail(const std::string& message, const Failing& fail)
{
  if (fail)
  {
    fail(message);
  }
  else
  {
    this->Unread = "The study is open without what was drilled: " + message;
  }
}
} // namespace palpate
