#ifndef vtkSphericalHarmonicPhantom_h
#define vtkSphericalHarmonicPhantom_h

#include "PalpateShapeModule.h"
#include "PhantomSampler.h"
#include "SphericalHarmonicModel.h"
#include "vtkImageAlgorithm.h"

/// Source of an MR-like volume (port 0, float) and the mask (port 1, unsigned char, 1 inside) of a
/// body whose spherical-harmonic coefficients are known, on any grid, including oblique ones. The
/// outputs carry the grid's direction matrix; frame patient LPS, lengths mm. PhantomSampler
/// documents the intensities; the body is the given model, or a prostate-like one of the given
/// degree and seed at the centre of the grid (MakeProstateLikeModel). The result does not depend on
/// the number of threads. Raises an error and produces no output if the settings are invalid.
class PALPATESHAPE_EXPORT vtkSphericalHarmonicPhantom : public vtkImageAlgorithm
{
public:
  static vtkSphericalHarmonicPhantom* New();
  vtkTypeMacro(vtkSphericalHarmonicPhantom, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The grid: voxel counts, spacing (mm), centre of the first voxel (mm, LPS), and the direction
  /// matrix, row by row, with orthonormal columns.
  vtkSetVector3Macro(Dimensions, int);
  vtkGetVector3Macro(Dimensions, int);
  vtkSetVector3Macro(Spacing, double);
  vtkGetVector3Macro(Spacing, double);
  vtkSetVector3Macro(OriginWorld, double);
  vtkGetVector3Macro(OriginWorld, double);
  vtkSetVectorMacro(DirectionMatrix, double, 9);
  vtkGetVectorMacro(DirectionMatrix, double, 9);
  ///@}

  /// Moves the grid so that its centre is at this point (mm, LPS), with the current dimensions,
  /// spacing and direction.
  void CenterGridOn(double x, double y, double z);

  ///@{
  /// Degree and seed of the prostate-like body that is used if no model is given.
  vtkSetClampMacro(Degree, int, 0, 200);
  vtkGetMacro(Degree, int);
  vtkSetMacro(ShapeSeed, unsigned int);
  vtkGetMacro(ShapeSeed, unsigned int);
  ///@}

  /// The body to draw, with its own centre (mm, LPS).
  void SetModel(const palpate::SphericalHarmonicModel& model);
  /// Returns to the prostate-like body.
  void ClearModel();
  /// The body: the ground truth for a fit.
  palpate::SphericalHarmonicModel GetModel() const;

  ///@{
  /// Intensities, partial volume, bias field and noise.
  void SetAppearance(const palpate::PhantomAppearance& appearance);
  const palpate::PhantomAppearance& GetAppearance() const { return this->Appearance; }
  ///@}

  ///@{
  /// The settings of the appearance that are available in Python: standard deviation of the Rician
  /// noise, amplitude of the bias field, and their seed.
  void SetNoiseDeviation(double deviation);
  void SetBiasAmplitude(double amplitude);
  void SetAppearanceSeed(unsigned int seed);
  ///@}

protected:
  vtkSphericalHarmonicPhantom();
  ~vtkSphericalHarmonicPhantom() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputs,
                         vtkInformationVector* outputs) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

private:
  vtkSphericalHarmonicPhantom(const vtkSphericalHarmonicPhantom&) = delete;
  void operator=(const vtkSphericalHarmonicPhantom&) = delete;

  palpate::PhantomGrid GetGrid() const;
  bool SettingsAreUsable();

  int Dimensions[3] = {160, 160, 24};
  double Spacing[3] = {0.5, 0.5, 3.0};
  double OriginWorld[3] = {-39.75, -39.75, -34.5};
  double DirectionMatrix[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  int Degree = 12;
  unsigned int ShapeSeed = 1;
  bool HasModel = false;
  palpate::SphericalHarmonicModel Model;
  palpate::PhantomAppearance Appearance;
};

#endif
