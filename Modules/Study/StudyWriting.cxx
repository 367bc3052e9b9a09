#include "StudyWriting.h"

#include <memory>
#include <utility>

namespace palpate
{
void StudyWriting::Start(const std::filesystem::path& file, Writing write,
                         std::function<void(const std::string& message)> fail)
{
  const auto id = std::make_shared<StudyJobs::Id>();
  StudyJob job;
  job.IsUrgent = true;
  job.Work = [this, id, write = std::move(write)](const ProgressFunction& progress)
  {
    write(progress);
    return StudyJob::Delivery([this, id] { this->Running.erase(*id); });
  };
  job.Fail = [this, id, fail = std::move(fail)](const std::string& message)
  {
    this->Running.erase(*id);
    fail(message);
  };
  *id = this->Jobs.Start(std::move(job));
  this->Running[*id] = file;
}

std::vector<StudyWriting::File> StudyWriting::Waiting() const
{
  std::vector<File> files;
  for (const auto& [id, path] : this->Running)
  {
    files.push_back({path, this->Jobs.ProgressOf(id).value_or(StudyJobProgress())});
  }
  return files;
}

void StudyWriting::Cancel()
{
  for (const auto& [id, path] : this->Running)
  {
    this->Jobs.Cancel(id);
  }
  this->Running.clear();
}
} // namespace palpate
