#pragma once

#include <string>

namespace palpate::cli
{
struct DeclaredCommand;

/// The description of a command as a command-line module of 3D Slicer (the XML of its execution
/// model), from which Slicer makes a panel. Names of options are written with underscores, since
/// the format knows no hyphens; `palpate --slicer` reads them. Numbers without a default are text
/// there: an empty field then leaves the option out.
std::string SlicerModule(const DeclaredCommand& command, const std::string& version);
} // namespace palpate::cli
