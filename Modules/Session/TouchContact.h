#pragma once

#include "ContactModel.h"
#include "HarmonicContactModel.h"
#include "OnDemandField.h"
#include "OnDemandHarmonics.h"
#include "PalpateSessionModule.h"
#include "ScalarField.h"
#include "SphericalHarmonicModel.h"
#include "TouchScene.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <filesystem>
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

/// A structure's surface as something to touch.
struct TouchContact
{
  std::shared_ptr<const ContactModel> Model;
  TouchAppearance Looks;
  std::string Represented; ///< in words, such as "harmonics of degree 12, nearest point"
  HarmonicContactMode Mode = HarmonicContactMode::Nearest;     ///< of harmonics
  EvaluationPrecision Precision = EvaluationPrecision::Double; ///< the same
  /// What the model feels, where only what is round the tool is in memory.
  std::shared_ptr<OnDemandField> OnDemand = nullptr;
  bool IsDrillable = false; ///< of a field: it keeps its inside
  /// The same where the model and its stand-ins are there only near the tool; then what is beneath.
  std::shared_ptr<OnDemandHarmonics> Harmonics = nullptr;
  std::shared_ptr<const ContactModel> Beneath = nullptr;
  std::vector<TouchStandIn> Coarser; ///< without those that are the tool's; see AddStandIns
};

/// Harmonics in words.
PALPATESESSION_EXPORT std::string HarmonicText(const SphericalHarmonicModel& model,
                                               HarmonicContactMode mode,
                                               EvaluationPrecision precision);

/// The three kinds. `file` is for messages. Throw InputError for what cannot be touched.
PALPATESESSION_EXPORT TouchContact MakeHarmonicContact(const SphericalHarmonicModel& model,
                                                       HarmonicContactMode mode,
                                                       EvaluationPrecision precision,
                                                       const std::filesystem::path& file);
PALPATESESSION_EXPORT TouchContact MakeFacetContact(vtkPolyData* surface,
                                                    const std::filesystem::path& file);
PALPATESESSION_EXPORT TouchContact MakeFieldContact(const std::shared_ptr<const ScalarField>& field,
                                                    int material,
                                                    const std::filesystem::path& file);
} // namespace palpate
