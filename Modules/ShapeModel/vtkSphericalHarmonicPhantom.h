#ifndef vtkSphericalHarmonicPhantom_h
#define vtkSphericalHarmonicPhantom_h

#include "PalpateShapeModelModule.h"
#include "PhantomSampler.h"
#include "SphericalHarmonicModel.h"
#include "vtkImageAlgorithm.h"

/// Source of an MR-like volume (port 0, float) and the mask (port 1, unsigned char, 1 inside) of a
/// body whose spherical-harmonic coefficients are known, on any grid, also an oblique one. The
/// outputs carry the grid's direction matrix; frame patient LPS, lengths mm. What is drawn is told
/// in PhantomSampler; the body is the given model, or a prostate-like one of the given degree and
/// seed around the centre of the grid (MakeProstateLikeModel). The result does not depend on the
/// number of threads. Error event, and no output, where a setting makes no image.
class PALPATESHAPEMODEL_EXPORT vtkSphericalHarmonicPhantom : public vtkImageAlgorithm
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

  /// Moves the grid so that its middle is at this point (mm, LPS), with the present dimensions,
  /// spacing and direction.
  void CenterGridOn(double x, double y, double z);

  ///@{
  /// Degree and seed of the prostate-like body that is made where no model was given.
  vtkSetClampMacro(Degree, int, 0, 200);
  vtkGetMacro(Degree, int);
  vtkSetMacro(ShapeSeed, unsigned int);
  vtkGetMacro(ShapeSeed, unsigned int);
  ///@}

  /// The body to draw, with its own centre (mm, LPS).
  void SetModel(const palpate::SphericalHarmonicModel& model);
  /// Back to the prostate-like body.
  void ClearModel();
  /// The body that is drawn: the truth that a fit should find.
  palpate::SphericalHarmonicModel GetModel() const;

  ///@{
  /// Intensities, partial volume, bias field and noise.
  void SetAppearance(const palpate::PhantomAppearance& appearance);
  const palpate::PhantomAppearance& GetAppearance() const { return this->Appearance; }
  ///@}

  ///@{
  /// The part of the appearance that is reachable from Python: standard deviation of the Rician
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
