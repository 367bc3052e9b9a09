#pragma once

#include "Clock.h"
#include "FitStages.h"
#include "PalpateTradeModule.h"
#include "Progress.h"
#include "TouchContact.h"
#include "TradeSetting.h"
#include "TradeSource.h"

#include <functional>
#include <map>
#include <optional>
#include <utility>

namespace palpate
{
/// A structure represented by one setting, and how long that took.
struct TradeModel
{
  TouchContact Contact;
  double Seconds = 0.0; ///< with all it was made from, as if nothing else had been made before
};

/// Represents one structure by many settings. What several of them are made from (its surface,
/// samples of that, fields) is made once, when it is first needed. All throw InputError and
/// FilterError, with a sentence, where a structure cannot be represented so, and Cancelled.
class PALPATETRADE_EXPORT TradeModels
{
public:
  /// Keeps the address of the clock.
  TradeModels(TradeSource source, const Clock& clock);

  const TradeSource& Source() const { return this->Structure; }

  TradeModel Make(const TradeSetting& setting, const ProgressFunction& progress);
  /// The star-shaped model of a degree: fitted, or cut off from a higher one.
  SphericalHarmonicModel ModelOf(int degree, const ProgressFunction& progress);
  /// All that the source's own surface has, where it has one without being fitted.
  int FacetCount(const ProgressFunction& progress);
  /// The highest degree that the source says anything of.
  int HighestDegree(const ProgressFunction& progress);

private:
  template <typename Part>
  struct Made
  {
    Part Content;
    double Seconds = 0.0;
  };
  template <typename Part>
  static const Part& Counted(const Made<Part>& made, double& seconds);
  double SecondsSince(std::int64_t start) const;

  const Made<vtkSmartPointer<vtkPolyData>>& Surface(const ProgressFunction& progress);
  const Made<FitSurface>& MaskSurface(const ProgressFunction& progress);
  const Made<FitSamples>& Samples(const ProgressFunction& progress);
  const Made<std::shared_ptr<const ScalarField>>& Field(const TradeSetting& setting,
                                                        const ProgressFunction& progress);
  /// The surface with about so many facets, or all for 0.
  const Made<vtkSmartPointer<vtkPolyData>>& Facets(int facets, const ProgressFunction& progress);
  SphericalHarmonicModel FittedModel(int degree, double& seconds, const ProgressFunction& progress);
  TradeModel MakeHarmonics(const TradeSetting& setting, const ProgressFunction& progress);
  TradeModel MakeFacets(const TradeSetting& setting, const ProgressFunction& progress);
  TradeModel MakeField(const TradeSetting& setting, const ProgressFunction& progress);
  [[noreturn]] void RefuseRepresentation(const std::string& what) const;

  TradeSource Structure;
  const Clock& Time;
  std::optional<Made<vtkSmartPointer<vtkPolyData>>> OwnSurface;
  std::optional<Made<FitSurface>> OwnMaskSurface;
  std::optional<Made<FitSamples>> OwnSamples;
  std::map<int, Made<vtkSmartPointer<vtkPolyData>>> FewerFacets; // by their number
  std::map<FieldInterpolation, Made<std::shared_ptr<const ScalarField>>> Fields;
};
} // namespace palpate
