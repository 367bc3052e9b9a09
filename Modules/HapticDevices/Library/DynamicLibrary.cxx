#include "DynamicLibrary.h"

#include <cstdlib>
#include <dlfcn.h>

namespace palpate
{
DynamicLibrary::DynamicLibrary(const char* variable, std::initializer_list<const char*> names)
{
  const char* const given = std::getenv(variable);
  if (given != nullptr && *given != '\0')
  {
    this->Handle = dlopen(given, RTLD_NOW | RTLD_LOCAL);
    return;
  }
  for (const char* name : names)
  {
    this->Handle = this->Handle != nullptr ? this->Handle : dlopen(name, RTLD_NOW | RTLD_LOCAL);
  }
}

void* DynamicLibrary::Address(const char* name) const
{
  return this->Handle != nullptr ? dlsym(this->Handle, name) : nullptr;
}
} // namespace palpate
