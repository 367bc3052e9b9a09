#include "ImageOptions.h"

#include <CLI/CLI.hpp>

namespace palpate::cli
{
void ImageOptions::Declare(CLI::App& app, const std::string& seriesOf)
{
  app.add_option("--series", this->Series,
                 "DICOM series of a " + seriesOf +
                     ": its number in the list that the error message prints, or its UID; of a "
                     "file of several volumes, the number of one")
      ->type_name("N|UID");
  app.add_flag("--refuse-left-handed", this->RefuseLeftHanded,
               "Refuse files with left-handed directions, which FSL and dcm2niix write; by default "
               "one index axis is reversed, and voxels keep their positions in the patient");
}

LeftHandedAxes ImageOptions::LeftHanded() const
{
  return this->RefuseLeftHanded ? LeftHandedAxes::Refuse : LeftHandedAxes::Reverse;
}
} // namespace palpate::cli
