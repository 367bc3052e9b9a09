#pragma once

#include "ModelDocument.h"
#include "OrganSoftening.h"
#include "PalpateFitModule.h"
#include "Progress.h"
#include "Volume.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// What a model is made of and lies on. Young's moduli in kPa.
struct SofteningSettings
{
  struct Inclusion
  {
    std::filesystem::path File; ///< a segmentation
    std::string Label;          ///< number or name; empty: all of its structures
    double Kilopascal = 0.0;
  };

  double TissueKilopascal = 20.0;
  double PoissonRatio = 0.49;
  std::vector<Inclusion> Inclusions;  ///< later ones count where they overlap
  std::filesystem::path Elastography; ///< image of moduli in kPa; empty: none
  VolumeChoice Choice;                ///< how the files are read

  double BedPerMillimeter = 1.0;  ///< of what the organ lies on, kPa/mm
  std::vector<Vector3> FreeSides; ///< directions, patient LPS, in which it lies on nothing
  double FreeDegrees = 60.0;      ///< around each, half the cone's angle

  OrganSoftening Numbers;
};

/// A model that yields.
struct SoftenedModel
{
  ModelDocument Document;
  OrganSoftening::Account Account;
  std::vector<std::string> Notes;
};

/// Makes a star-shaped model yield. `name` is that of its file, for messages. Takes seconds. Throws
/// InputError for other models, files that cannot be read, and settings outside their limits, and
/// Cancelled.
PALPATEFIT_EXPORT SoftenedModel SoftenModel(const ModelDocument& model, const std::string& name,
                                            const SofteningSettings& settings,
                                            const ProgressFunction& progress);
} // namespace palpate
