#pragma once

#include "ComplianceMaps.h"
#include "FitSettings.h"

#include "DirectionCoverage.h"
#include "MappedSurface.h"
#include "OrganModel.h"
#include "Segmentation.h"
#include "Volume.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// Distances (mm) between two surfaces, in both directions, over their areas.
struct SurfaceDistances
{
  double Mean = 0.0;
  double Rms = 0.0;
  double Percentile95 = 0.0;
  double Maximum = 0.0;
};

/// What only a surface model has.
struct SurfaceModelDetails
{
  std::shared_ptr<const MappedSurface> Mapped; ///< what was fitted, and how it was made
  double Determination = 0.0;                  ///< of the placement, see SphericalPlacement
  int Folded = 0;                              ///< vertices at which the surface turns over
  std::int64_t Crossings = 0;                  ///< pairs of triangles of the drawn model that cross
  double IrregularPercent = 0.0; ///< voxels with a winding number other than 0 and 1, of the mask's
  TopologyReport SurfaceRepair;  ///< of the repair of a surface file (MakeClosedMesh)
  double AddedAreaPercent = 0.0; ///< of its area, by the repair (AddedSurface)
};

/// Result of one structure. Lengths are mm, volumes ml, points and surfaces patient LPS.
struct FitResult
{
  enum class Outcome
  {
    Fitted,
    Refused,  ///< the structure cannot be modelled this way; Message gives the reason
    BadInput, ///< Message describes the problem of the input
    Failed    ///< any other failure
  };

  // Input.
  std::filesystem::path Input;
  std::string CaseName; ///< file name without its endings, for output files
  Segment Structure;
  FitSettings Settings;
  /// Input is the file of a closed surface, and Surface what was made of it. There is no mask: what
  /// is measured against one below is left at its default, unless it says otherwise.
  bool IsOfSurface = false;

  Outcome State = Outcome::Failed;
  /// One sentence; of a fitted structure, what the model changes (StructureChanges), or empty.
  std::string Message;
  /// Suggestions (see WithHint); empty if there are none.
  std::string OptionHint; ///< as options of `palpate fit`
  std::string WindowHint; ///< as controls of the window
  std::vector<std::string> Notes;

  // The mask.
  bool IsOriented = true;             ///< false: the file does not state its axes in the patient
  vtkSmartPointer<vtkImageData> Mask; ///< the label layer, on its own grid
  double MaskMilliliters = 0.0;       ///< of the fitted component
  bool TouchesBorder = false;
  double CutArea = 0.0; ///< mm^2 of Surface where the border of the image cuts it (CutAreaOf)
  std::vector<double> ComponentMilliliters; ///< descending
  int CavityCount = 0;
  double CavityMilliliters = 0.0;
  double LargestCavityMilliliters = 0.0;

  // The surface.
  vtkSmartPointer<vtkPolyData> Surface;
  double SurfaceMilliliters = 0.0;
  SurfaceDistances SurfaceToMask;

  // Visibility from the centre.
  bool IsSampled = false; ///< whether it was measured
  bool StarShaped = false;
  double HiddenPercent = 0.0;   ///< of the surface's area
  double MultiplePercent = 0.0; ///< of the directions (solid angle): more than one crossing
  double MissedPercent = 0.0;   ///< of the directions: no crossing

  // The model.
  OrganModel Model;
  double Condition = 0.0;
  double Rms = 0.0;
  double NoiseDeviation = 0.0;
  double Roughness = 0.0;
  double DegreesOfFreedom = 0.0;
  DirectionCoverage Coverage;      ///< how well the directions determine the model
  int DownWeighted = 0;            ///< samples whose weight was lowered by a robust fit
  std::vector<double> RmsByDegree; ///< entry l: RMS residual of degree l; empty with a penalty and
                                   ///< of a robust fit
  /// The model's surface with point arrays "DistanceToSurface" (signed, mm, positive outside the
  /// original) and analytic normals; of a radial model also "Residual" and "RadiusDeviation" (mm),
  /// of a surface model "NormalDeviation" (mm).
  vtkSmartPointer<vtkPolyData> ModelSurface;

  // Its quality.
  SurfaceDistances ModelToSurface;
  SurfaceDistances ModelToMask; ///< against the mask's half-level boundary
  double Dice = 0.0;            ///< on the mask's own grid; of a surface file on the following one
  double DiceSpacing = 0.0;     ///< mm, of cubes around the surface of a surface file
  double ModelMilliliters = 0.0;
  double SurfaceAreaSquareMillimeters = 0.0;
  double ModelAreaSquareMillimeters = 0.0;

  SurfaceModelDetails Details;                      ///< of a surface model
  std::shared_ptr<const ComplianceMaps> Elasticity; ///< of a model that yields; else null
  std::string Tissue; ///< of one, as text: "20 kPa, inclusions of 60 kPa"; empty if unknown

  /// The model if it is radial, otherwise null.
  const RadialModel* Radial() const { return std::get_if<RadialModel>(&this->Model); }

  /// Of the model from what was given: the mask's boundary or the surface of a surface file.
  const SurfaceDistances& ModelToInput() const
  {
    return this->IsOfSurface ? this->ModelToSurface : this->ModelToMask;
  }
  /// Volume of what was given: the mask's component or the surface of a surface file.
  double InputMilliliters() const
  {
    return this->IsOfSurface ? this->SurfaceMilliliters : this->MaskMilliliters;
  }

  /// Seconds of each stage, in the order in which they ran; "total" last.
  std::vector<std::pair<std::string, double>> Seconds;
};
} // namespace palpate
