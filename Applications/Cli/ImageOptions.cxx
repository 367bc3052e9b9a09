#include "ImageOptions.h"

#include <CLI/CLI.hpp>

namespace palpate::cli
{
void ImageOptions::Declare(CLI::App& app, const std::string& seriesOf)
{
  app.add_option("--series", this->Series,
                 "DICOM series of a " + seriesOf +
                     ": its number in the list that the error gives, or its UID")
      ->type_name("N|UID");
  this->DeclareAxes(app);
}

void ImageOptions::DeclareAxes(CLI::App& app)
{
  app.add_flag("--reverse-left-handed", this->ReverseLeftHanded,
               "Read files with left-handed directions (usual from FSL and dcm2niix) by reversing "
               "one index axis; voxels keep their places in the patient");
}

LeftHandedAxes ImageOptions::LeftHanded() const
{
  return this->ReverseLeftHanded ? LeftHandedAxes::Reverse : LeftHandedAxes::Refuse;
}
} // namespace palpate::cli
