#pragma once

#include "ImageContent.h"
#include "LabelStatistics.h"
#include "PalpateReportModule.h"

#include <string>
#include <vector>

namespace palpate
{
/// What `palpate info` prints about one file.
struct PALPATEREPORT_EXPORT InfoReport
{
  std::string Input;
  ImageContent Content;
  std::vector<LabelStatistics> Labels; ///< of each segment of Content.Labels

  /// Readable lines, ended by an empty line.
  std::string Text() const;
  /// One JSON object on one line.
  std::string Json() const;
  /// The object of a file that could not be read: `status` is bad-input or failed.
  static std::string FailureJson(const std::string& input, const std::string& status,
                                 const std::string& message);
};
} // namespace palpate
