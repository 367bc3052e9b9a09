#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace palpate::test
{
/// The CT of a head in Debian's package invesalius-examples.
inline const std::filesystem::path HeadCtProject =
    "/usr/share/doc/invesalius-examples/examples/Cranium.inv3";

/// Converts it as described in Data/README.md. Returns false on failure.
inline bool ConvertHeadCt(const std::filesystem::path& target)
{
  const std::string command = "/usr/bin/python3 '" PALPATE_SOURCE_DIR
                              "/Data/convert_invesalius.py' '" +
                              HeadCtProject.string() + "' '" + target.string() + "'";
  return std::system(command.c_str()) == 0;
}
} // namespace palpate::test
