#ifndef vtkRadialModelFit_h
#define vtkRadialModelFit_h

#include "DirectionCoverage.h"
#include "PalpateFiltersModule.h"
#include "vtkTableAlgorithm.h"

#include <vector>

/// Fits a spherical-harmonic model to radial samples by least squares.
///
/// Input: samples as vtkRadialSampler writes them (arrays "Direction", "Radius" in mm, "Valid", and
/// "AreaWeight" or "SolidAngle" as weights, field data "Center"). Output: the model as a table (see
/// palpate::ToTable), with the field data array "CovarianceFactor": a square matrix F, row by row,
/// where F F^T is the covariance of the coefficients (mm^2). Arithmetic, penalty and refusals are
/// those of palpate::FitRadialModel; a refusal raises an error and produces no output.
class PALPATEFILTERS_EXPORT vtkRadialModelFit : public vtkTableAlgorithm
{
public:
  static vtkRadialModelFit* New();
  vtkTypeMacro(vtkRadialModelFit, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Penalties
  {
    NO_PENALTY,
    GIVEN_PENALTY,
    CROSS_VALIDATION
  };

  enum Weightings
  {
    AREA,
    SOLID_ANGLE,
    UNIFORM
  };

  ///@{ Degree of the model; default 12.
  vtkSetClampMacro(Degree, int, 0, 1000);
  vtkGetMacro(Degree, int);
  ///@}

  ///@{ Weight of a sample: the surface's area (array "AreaWeight", default), which minimises the
  /// distance along the normal; the solid angle (array "SolidAngle"), which minimises the radial
  /// distance; or uniform.
  vtkSetClampMacro(Weighting, int, AREA, UNIFORM);
  vtkGetMacro(Weighting, int);
  ///@}

  ///@{ If positive: finds the smallest degree, up to MaximumDegree, whose root mean square residual
  /// (mm) is at most this, and sets Degree to it. If there is none, the update raises an error.
  /// Default 0: the degree is given.
  vtkSetClampMacro(Tolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Tolerance, double);
  vtkSetClampMacro(MaximumDegree, int, 0, 1000);
  vtkGetMacro(MaximumDegree, int);
  /// A search does not take a lower degree than this, even beyond SupportedDegree; default 0.
  vtkSetClampMacro(LeastDegree, int, 0, 1000);
  vtkGetMacro(LeastDegree, int);
  /// The highest degree that the samples can determine. A search that reaches it ends there, even
  /// if the tolerance is not met. Default 1000: no bound.
  vtkSetClampMacro(SupportedDegree, int, 0, 1000);
  vtkGetMacro(SupportedDegree, int);
  ///@}

  ///@{ Roughness penalty: none (default), of strength Roughness, or chosen by generalised
  /// cross-validation.
  vtkSetClampMacro(Penalty, int, NO_PENALTY, CROSS_VALIDATION);
  vtkGetMacro(Penalty, int);
  vtkSetMacro(Roughness, double);
  vtkGetMacro(Roughness, double);
  ///@}

  ///@{ Robust weights: samples with large residuals count less (palpate::HuberWeights); default
  /// off.
  /// The search for a degree goes by the residuals of plain fits.
  vtkSetMacro(Robust, bool);
  vtkGetMacro(Robust, bool);
  vtkBooleanMacro(Robust, bool);
  ///@}

  ///@{ Largest condition number accepted without a penalty; default 1e4.
  vtkSetMacro(MaximumCondition, double);
  vtkGetMacro(MaximumCondition, double);
  ///@}

  ///@{ Results of the last update; lengths in mm.
  vtkGetMacro(FittedDegree, int);
  vtkGetMacro(Condition, double);
  vtkGetMacro(UsedRoughness, double);
  vtkGetMacro(Rms, double);
  vtkGetMacro(NoiseDeviation, double);
  vtkGetMacro(DegreesOfFreedom, double);
  /// Samples whose weight a robust fit lowered; 0 without Robust.
  vtkGetMacro(DownWeighted, int);
  /// How well the directions of the valid samples determine the model, with its weights and
  /// penalty.
  const palpate::DirectionCoverage& GetCoverage() const { return this->Coverage; }
  /// RMS residual of the unpenalised, not robust fit of every degree up to GetNumberOfDegrees()
  /// - 1.
  int GetNumberOfDegrees() const { return static_cast<int>(this->RmsByDegree.size()); }
  double GetRmsOfDegree(int degree) const
  {
    return this->RmsByDegree.at(static_cast<std::size_t>(degree));
  }
  ///@}

protected:
  vtkRadialModelFit() = default;
  ~vtkRadialModelFit() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

private:
  vtkRadialModelFit(const vtkRadialModelFit&) = delete;
  void operator=(const vtkRadialModelFit&) = delete;

  int Degree = 12;
  int Weighting = AREA;
  double Tolerance = 0.0;
  int MaximumDegree = 40;
  int LeastDegree = 0;
  int SupportedDegree = 1000;
  int Penalty = NO_PENALTY;
  double Roughness = 0.0;
  double MaximumCondition = 1e4;
  bool Robust = false;

  int FittedDegree = 0;
  double Condition = 0.0;
  double UsedRoughness = 0.0;
  double Rms = 0.0;
  double NoiseDeviation = 0.0;
  double DegreesOfFreedom = 0.0;
  int DownWeighted = 0;
  palpate::DirectionCoverage Coverage;
  std::vector<double> RmsByDegree;
};

#endif
