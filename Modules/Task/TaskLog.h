#pragma once

#include "PalpateTaskModule.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace palpate
{
/// A text file that lines are appended to, each on the disk before Append returns, so that a crash
/// loses no line and leaves at most the last one incomplete. One process at a time writes it.
class PALPATETASK_EXPORT TaskLog
{
public:
  /// Opens or creates the file; an incomplete last line is cut off. Throws InputError if that fails
  /// or another process writes it.
  explicit TaskLog(const std::filesystem::path& path);
  TaskLog(const TaskLog&) = delete;
  TaskLog& operator=(const TaskLog&) = delete;
  ~TaskLog();

  /// Those that were there when it was opened.
  const std::vector<std::string>& Lines() const { return this->Earlier; }
  /// `line` without a line break. Throws InputError if it cannot be written: it is then cut off by
  /// the next opening.
  void Append(const std::string& line);

  /// The complete lines of a log that others may write. Throws InputError for a file that cannot be
  /// read or has more than 64 MiB.
  static std::vector<std::string> ReadLines(const std::filesystem::path& path);

private:
  void CutTo(std::size_t bytes) const;
  [[noreturn]] void Fail(const std::string& what) const;

  std::filesystem::path Path;
  int File = -1;
  std::vector<std::string> Earlier;
};
} // namespace palpate
