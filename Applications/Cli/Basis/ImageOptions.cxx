#include "ImageOptions.h"

#include "DecimalText.h"
#include "FiniteNumber.h"
#include "InputError.h"

#include <CLI/CLI.hpp>
#include <limits>
#include <optional>

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

void ImageOptions::DeclareValues(CLI::App& app)
{
  app.add_option("--threshold", this->Threshold,
                 "Take the voxels of an image from this value on as the structure, for probability "
                 "maps; others and NaN are background")
      ->type_name("VALUE")
      ->expected(1)
      ->check(FiniteNumber::Any());
  app.add_option("--background", this->Background,
                 "Values of an image that are background, besides 0: numbers, such as -1, or nan "
                 "for voxels that are not finite; separated by commas")
      ->type_name("VALUE")
      ->delimiter(',')
      ->allow_extra_args(false);
}

void ImageOptions::DeclareResampling(CLI::App& app)
{
  app.add_flag("--resample", this->Resample,
               "Resample an image whose axes are sheared, which is refused otherwise, onto "
               "perpendicular ones: labels by the nearest voxel, other values linearly");
}

VolumeChoice ImageOptions::Choice() const
{
  VolumeChoice choice;
  choice.Series = this->Series;
  choice.LeftHanded = this->LeftHanded();
  choice.Sheared = this->Resample ? ShearedAxes::Resample : ShearedAxes::Refuse;
  if (!this->Threshold.empty())
  {
    choice.Values.Threshold = this->Threshold.front();
  }
  for (const std::string& word : this->Background)
  {
    const std::optional<double> number = ParseNumber(word);
    const bool isNaN = word == "nan" || word == "NaN" || word == "NAN";
    if (!number && !isNaN)
    {
      throw InputError("--background " + word + " is not a value; give a number or nan");
    }
    choice.Values.Background.push_back(isNaN ? std::numeric_limits<double>::quiet_NaN() : *number);
  }
  return choice;
}

VolumeChoice ImageOptions::ChoiceOfVolume() const
{
  VolumeChoice choice = this->Choice();
  choice.Values = {};
  return choice;
}

std::string ImageOptions::ValueText() const
{
  std::string text;
  for (const double threshold : this->Threshold)
  {
    text += "threshold " + ExactText(threshold);
  }
  for (const std::string& word : this->Background)
  {
    text += " background " + word;
  }
  return text;
}

LeftHandedAxes ImageOptions::LeftHanded() const
{
  return this->RefuseLeftHanded ? LeftHandedAxes::Refuse : LeftHandedAxes::Reverse;
}
} // namespace palpate::cli
