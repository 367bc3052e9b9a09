#pragma once

#include <initializer_list>
#include <string>

namespace palpate
{
/// A library of the user's that is opened at run time, so that nobody else has to have it. It is
/// never closed: such libraries have threads of their own. C functions only.
class DynamicLibrary
{
public:
  /// The first of these names that the system finds; $`variable`, if it is set, goes before them.
  /// Only that and the system say where: a name from a file would be a program that it runs.
  DynamicLibrary(const char* variable, std::initializer_list<const char*> names);

  bool IsOpen() const noexcept { return this->Handle != nullptr; }
  /// Sets a function's address; IsWhole is false from then on if there is none.
  template <typename Function>
  void Find(const char* name, Function& function)
  {
    this->FindIfThere(name, function);
    this->HasAll = this->HasAll && function != nullptr;
  }
  /// The same of a function that only newer libraries have: null without it.
  template <typename Function>
  void FindIfThere(const char* name, Function& function)
  {
    function = reinterpret_cast<Function>(this->Address(name));
  }
  bool IsWhole() const noexcept { return this->IsOpen() && this->HasAll; }

private:
  void* Address(const char* name) const;

  void* Handle = nullptr;
  bool HasAll = true;
};
} // namespace palpate
