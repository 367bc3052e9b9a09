#pragma once

#include "PalpateIOModule.h"

#include <mutex>

namespace palpate
{
/// Redirects the process's standard output and standard error to /dev/null during its lifetime. The
/// format libraries below ITK and DCMTK print about every damaged file; their exceptions become our
/// own messages, so nothing is lost. It holds a lock, because the two descriptors (and the state of
/// some of these libraries) belong to the whole process: files are read one at a time.
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
