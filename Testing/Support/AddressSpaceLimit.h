#pragma once

#include <fstream>
#include <sys/resource.h>
#include <unistd.h>

namespace palpate::test
{
/// During its lifetime this process can allocate only `bytes` more of address space; larger
/// requests fail. Proves that a claim of gigabytes is refused before memory is allocated.
class AddressSpaceLimit
{
public:
  explicit AddressSpaceLimit(rlim_t bytes)
  {
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    getrlimit(RLIMIT_AS, &this->Old);
    const rlimit limit{pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + bytes,
                       this->Old.rlim_max};
    setrlimit(RLIMIT_AS, &limit);
  }
  AddressSpaceLimit(const AddressSpaceLimit&) = delete;
  AddressSpaceLimit& operator=(const AddressSpaceLimit&) = delete;
  ~AddressSpaceLimit() { setrlimit(RLIMIT_AS, &this->Old); }

private:
  rlimit Old{};
};
} // namespace palpate::test
