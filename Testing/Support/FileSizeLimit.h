#pragma once

#include <csignal>
#include <sys/resource.h>

namespace palpate::test
{
/// During its lifetime no file of this process can grow beyond `bytes`: simulates a full disk.
class FileSizeLimit
{
public:
  explicit FileSizeLimit(rlim_t bytes) : OldHandler(std::signal(SIGXFSZ, SIG_IGN))
  {
    getrlimit(RLIMIT_FSIZE, &this->Old);
    const rlimit limit{bytes, this->Old.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit()
  {
    setrlimit(RLIMIT_FSIZE, &this->Old);
    std::signal(SIGXFSZ, this->OldHandler);
  }

private:
  void (*OldHandler)(int);
  rlimit Old{};
};
} // namespace palpate::test
