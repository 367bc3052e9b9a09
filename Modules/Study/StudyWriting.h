#pragma once

#include "PalpateStudyModule.h"
#include "StudyJobs.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace palpate
{
/// Writes files in the background, so that the window's thread never waits for them. Owner thread
/// only.
class PALPATESTUDY_EXPORT StudyWriting
{
public:
  /// A file that is not yet written.
  struct File
  {
    std::filesystem::path Path;
    StudyJobProgress Progress;
  };
  using Writing = std::function<void(const ProgressFunction& progress)>;

  /// Keeps the address.
  explicit StudyWriting(StudyJobs& jobs) : Jobs(jobs) {}

  /// Runs `write` on a worker, which owns all that it needs; `fail` gets its message if it throws.
  void Start(const std::filesystem::path& file, Writing write,
             std::function<void(const std::string& message)> fail);
  /// In the order of their start.
  std::vector<File> Waiting() const;
  /// Gives up all files. AtomicFile's rules leave former files as they are.
  void Cancel();

private:
  StudyJobs& Jobs;
  std::map<StudyJobs::Id, std::filesystem::path> Running;
};
} // namespace palpate
