#pragma once

#include "FileType.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace CLI
{
class Option;
}

namespace palpate::cli
{
/// A declared option or positional argument, as completion, the manual page and 3D Slicer's
/// descriptions need it.
struct DeclaredOption
{
  enum class Kind
  {
    Flag,
    Integer,
    Real,
    Choice, ///< one of Values
    File,
    Text
  };

  explicit DeclaredOption(const CLI::Option& option);

  std::vector<std::string> Names; ///< with dashes; empty for a positional
  std::string Place;              ///< the name of a positional
  std::string Help;
  std::string Word; ///< what stands for the value in help, a unit or a kind: MM, N|NAME, FILE
  Kind Type = Kind::Text;
  std::vector<std::string> Values; ///< of its IsMember check
  std::optional<std::array<double, 2>> Range;
  std::optional<FileType::Declared> File;
  std::string Default; ///< empty if there is none
  bool IsRequired;
  bool IsList;           ///< takes several values
  bool IsCommaSeparated; ///< takes them in one word

  bool TakesValue() const { return this->Type != Kind::Flag; }
  bool IsPositional() const { return this->Names.empty(); }
  bool HasName(const std::string& name) const;
};
} // namespace palpate::cli
