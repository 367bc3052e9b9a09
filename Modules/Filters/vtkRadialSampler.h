#ifndef vtkRadialSampler_h
#define vtkRadialSampler_h

#include "PalpateFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

/// Measures the distance of a closed surface from a centre along given directions, and decides
/// whether the surface is star-shaped as seen from there.
///
/// Port 0: the closed, outward-facing triangle surface (world mm). Port 1: the directions, points
/// of unit length, with an optional array "SolidAngle" (see vtkIcosahedronDirections). Output: the
/// directions' cells with points moved onto the surface, and the point arrays "Direction",
/// "Radius" (mm), "Crossings" (intersections of the ray with the surface), "Valid" (1 if there is
/// one), "SolidAngle" (sr) and "AreaWeight" (mm^2: the solid angle times the squared radius and the
/// cosine between ray and surface normal; a squared radial error with this weight is the squared
/// distance along the normal, integrated over the surface); the centre (world mm) is the field data
/// array "Center". The radius of a ray without intersections is 0. Raises an error and produces no
/// output if the surface is empty.
class PALPATEFILTERS_EXPORT vtkRadialSampler : public vtkPolyDataAlgorithm
{
public:
  static vtkRadialSampler* New();
  vtkTypeMacro(vtkRadialSampler, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum CenterModes
  {
    CENTROID,    ///< of the enclosed volume
    GIVEN,       ///< SetCenter
    MOST_VISIBLE ///< the point from which most of the surface is seen
  };

  ///@{ Origin of the directions; default CENTROID.
  vtkSetClampMacro(CenterMode, int, CENTROID, MOST_VISIBLE);
  vtkGetMacro(CenterMode, int);
  ///@}

  ///@{ World mm; an input for GIVEN, otherwise a result of the update.
  vtkSetVector3Macro(Center, double);
  vtkGetVector3Macro(Center, double);
  ///@}

  ///@{ The crossing that gives the radius if there are several: the outermost (default) keeps the
  /// silhouette, the innermost the part that the centre sees.
  vtkSetMacro(UseOutermost, bool);
  vtkGetMacro(UseOutermost, bool);
  vtkBooleanMacro(UseOutermost, bool);
  ///@}

  ///@{ Result of the last update. Hidden: share of the surface's area that the centre does not see;
  /// multiple and missed: shares of the sphere of directions with more than one crossing, and with
  /// none.
  vtkGetMacro(StarShaped, bool);
  vtkGetMacro(HiddenPercent, double);
  vtkGetMacro(MultiplePercent, double);
  vtkGetMacro(MissedPercent, double);
  ///@}

  void SetDirectionsConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }

protected:
  vtkRadialSampler() { this->SetNumberOfInputPorts(2); }
  ~vtkRadialSampler() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

private:
  vtkRadialSampler(const vtkRadialSampler&) = delete;
  void operator=(const vtkRadialSampler&) = delete;

  int CenterMode = CENTROID;
  double Center[3] = {0.0, 0.0, 0.0};
  bool UseOutermost = true;
  bool StarShaped = false;
  double HiddenPercent = 0.0;
  double MultiplePercent = 0.0;
  double MissedPercent = 0.0;
};

#endif
