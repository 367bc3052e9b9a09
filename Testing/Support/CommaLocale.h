#pragma once

#include <clocale>
#include <cstdlib>
#include <locale>
#include <stdexcept>
#include <string>

namespace palpate::test
{
/// A locale that writes 3.5 as 3,5 and 1000 as 1.000.
inline const char* CommaLocaleName()
{
  return "de_DE.UTF-8";
}

/// Sets the process's locale during its lifetime: C's, or C++'s streams too. Throws if the locale
/// is not installed (package locales-all).
class CommaLocale
{
public:
  enum class Scope
  {
    OnlyC, ///< by setlocale, which QApplication calls
    Streams
  };

  explicit CommaLocale(Scope scope = Scope::OnlyC) : Before(std::setlocale(LC_ALL, nullptr))
  {
    if (std::setlocale(LC_ALL, CommaLocaleName()) == nullptr ||
        *std::localeconv()->decimal_point != ',')
    {
      throw std::runtime_error(std::string(CommaLocaleName()) + " is not installed");
    }
    if (scope == Scope::Streams)
    {
      std::locale::global(std::locale(CommaLocaleName()));
    }
  }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;
  ~CommaLocale()
  {
    std::locale::global(this->StreamsBefore);
    std::setlocale(LC_ALL, this->Before.c_str());
  }

private:
  std::string Before;
  std::locale StreamsBefore;
};

/// Sets the environment of the process, its children and a QApplication that it creates to a user's
/// with that locale, during its lifetime.
class CommaEnvironment
{
public:
  CommaEnvironment() : WasSet(std::getenv("LC_ALL") != nullptr)
  {
    this->Before = this->WasSet ? std::getenv("LC_ALL") : "";
    const CommaLocale isInstalled;
    setenv("LC_ALL", CommaLocaleName(), 1);
  }
  CommaEnvironment(const CommaEnvironment&) = delete;
  CommaEnvironment& operator=(const CommaEnvironment&) = delete;
  ~CommaEnvironment()
  {
    if (this->WasSet)
    {
      setenv("LC_ALL", this->Before.c_str(), 1);
    }
    else
    {
      unsetenv("LC_ALL");
    }
  }

private:
  bool WasSet;
  std::string Before;
};
} // namespace palpate::test
