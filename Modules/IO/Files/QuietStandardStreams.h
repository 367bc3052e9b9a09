#pragma once

#include "PalpateIOModule.h"

#include <mutex>

namespace palpate
{
/// Sends standard output and standard error of the process to nowhere while it lives. The format
/// libraries below ITK and DCMTK print about every damaged file; their exceptions become our own
/// sentence, so nothing is lost. It holds a lock, because those two descriptors (and the state that
/// some of these libraries keep) belong to the whole process: readings of files take turns.
class PALPATEIO_EXPORT QuietStandardStreams
{
public:
  QuietStandardStreams();
  QuietStandardStreams(const QuietStandardStreams&) = delete;
  QuietStandardStreams& operator=(const QuietStandardStreams&) = delete;
  ~QuietStandardStreams();

private:
  std::unique_lock<std::recursive_mutex> Lock;
  int SavedOutput;
  int SavedErrors;
};
} // namespace palpate
