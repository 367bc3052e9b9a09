#pragma once

#include "PalpateStudyModule.h"
#include "StudyDrill.h"
#include "StudyJobs.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// Writes what was drilled next to a session file: case.palpate.drill for case.palpate.json.
/// Returns the file; writes none, and returns an empty path, if nothing was drilled. Throws
/// InputError.
PALPATESTUDY_EXPORT std::filesystem::path SaveDrilled(const std::filesystem::path& session,
                                                      const StudyDrillSnapshot& snapshot);

/// Reads files of what was drilled in the background, one at a time. Owner thread only.
class PALPATESTUDY_EXPORT StudyDrillFiles
{
public:
  using Taking = std::function<void(const std::vector<DrillRecord>& records)>;
  using Failing = std::function<void(const std::string& message)>;

  /// Keeps the address.
  explicit StudyDrillFiles(StudyJobs& jobs) : Jobs(jobs) {}

  /// Reads a file, then calls `take`, which may throw InputError. A message goes to `fail`, or is
  /// kept as Problem if there is none.
  void Read(const std::filesystem::path& file, Taking take, Failing fail = {});
  bool IsReading() const { return this->Reading.has_value(); }
  /// Why the last file could not be read; may be empty.
  const std::string& Problem() const { return this->Unread; }
  /// Forgets the file that is being read, and the problem.
  void Cancel();

private:
  void Fail(const std::string& message, const Failing& fail);

  StudyJobs& Jobs;
  std::optional<StudyJobs::Id> Reading;
  std::string Unread;
};
} // namespace palpate
