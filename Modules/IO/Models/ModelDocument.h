#pragma once

#include "ParametricSphericalSurface.h"
#include "SphericalHarmonicModel.h"

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace palpate
{
/// Origin of a model. Empty entries are unknown and are not written.
struct ModelProvenance
{
  std::string Program; ///< name and version of the program that made it
  std::string Input;   ///< file name (without folder) of the input
  std::string Label;   ///< the structure's number or name
  std::string Date;    ///< only if the caller gives one, so that output is reproducible
  std::vector<std::pair<std::string, std::string>> Settings;
};

/// A surface of spherical harmonics, star-shaped or parametric (patient LPS, mm).
using SurfaceModel = std::variant<SphericalHarmonicModel, ParametricSphericalSurface>;

struct ModelDocument
{
  SurfaceModel Surface;
  ModelProvenance Provenance;
};
} // namespace palpate
