#pragma once

#include "PalpateSessionModule.h"
#include "Progress.h"
#include "TouchScene.h"
#include "TouchSettings.h"

#include "ScalarField.h"
#include "SphericalHarmonicModel.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

namespace palpate
{
/// How a structure looks that is touched: by one of these, which its contact model is made of.
struct TouchAppearance
{
  std::shared_ptr<const SphericalHarmonicModel> Model;
  vtkSmartPointer<vtkPolyData> Surface;
  std::shared_ptr<const ScalarField> Field; ///< its first material
};

/// A structure ready to be touched, and what it took.
struct TouchableStructure
{
  TouchStructure Touch;
  TouchAppearance Looks;
  std::string Represented; ///< in words, such as "harmonics of degree 12, nearest point"
  double Seconds = 0.0;    ///< to make
  std::vector<std::string> Notes;
};

/// Reads the files and makes the models, each only as the settings ask. Throws InputError,
/// FilterError and Cancelled.
PALPATESESSION_EXPORT std::vector<TouchableStructure>
MakeTouchStructures(const TouchSettings& settings, const ProgressFunction& progress);

/// The tool of the settings. Throws InputError for one that is none.
PALPATESESSION_EXPORT ToolShape MakeTool(const TouchToolSettings& settings);
} // namespace palpate
