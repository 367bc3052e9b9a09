#pragma once

#include "OrganModel.h"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
class ComplianceMaps;

/// Origin of a model. Empty entries are unknown and are not written.
struct ModelProvenance
{
  std::string Program; ///< name and version of the program that made it
  std::string Input;   ///< file name (without folder) of the input
  std::string Label;   ///< the structure's number or name
  std::string Date;    ///< only if the caller gives one, so that output is reproducible
  std::vector<std::pair<std::string, std::string>> Settings;
};

struct ModelDocument
{
  OrganModel Surface;
  ModelProvenance Provenance;
  std::shared_ptr<const ComplianceMaps> Elasticity = nullptr; ///< null: rigid
};
} // namespace palpate
