#ifndef vtkElasticSurface_h
#define vtkElasticSurface_h

#include "PalpateFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For what is kept between executions

class vtkImageData;
class vtkTable;

/// Makes a radial model yield, and draws it with the dent of a ball.
///
/// Port 0: the model as a table (see palpate::ToTable). Port 1, optional: an image of Young's
/// modulus (kPa), which counts where it has positive values. Output: triangles in world mm, point
/// arrays "Force" (N, on a ball that is pressed a quarter of its radius into the point, NaN where
/// linear elasticity does not describe it) and "NoticedStiffness" (just noticeable differences of
/// that force from its median); field array "BallForce" (N, world) of the ball that makes the dent.
/// The elasticity is made anew, in seconds, only if the model, the image or the tissue has changed.
class PALPATEFILTERS_EXPORT vtkElasticSurface : public vtkPolyDataAlgorithm
{
public:
  static vtkElasticSurface* New();
  vtkTypeMacro(vtkElasticSurface, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{ Young's modulus of the tissue, kPa; default 20.
  vtkSetClampMacro(TissueModulus, double, 0.001, 1e6);
  vtkGetMacro(TissueModulus, double);
  ///@}
  ///@{ Poisson's ratio; default 0.49.
  vtkSetClampMacro(PoissonRatio, double, 0.0, 0.4999);
  vtkGetMacro(PoissonRatio, double);
  ///@}
  ///@{ Stiffness of what the organ lies on, kPa per mm; default 1.
  vtkSetClampMacro(SupportStiffness, double, 0.001, 1e5);
  vtkGetMacro(SupportStiffness, double);
  ///@}
  ///@{ Direction of the side that lies on nothing, and half the angle of its cone in degrees;
  /// default: none, an angle of 0.
  vtkSetVector3Macro(FreeDirection, double);
  vtkGetVector3Macro(FreeDirection, double);
  vtkSetClampMacro(FreeAngle, double, 0.0, 170.0);
  vtkGetMacro(FreeAngle, double);
  ///@}
  ///@{ Finite elements along a quarter of a great circle, made even; default 16.
  vtkSetClampMacro(ElementsAcross, int, 4, 24);
  vtkGetMacro(ElementsAcross, int);
  ///@}

  ///@{ Radius of the ball, mm; default 8.
  vtkSetClampMacro(BallRadius, double, 0.1, 100.0);
  vtkGetMacro(BallRadius, double);
  ///@}
  ///@{ Where the ball is pressed in, as a direction from the model's centre, and how deep, mm;
  /// default depth 0, no dent.
  vtkSetVector3Macro(BallDirection, double);
  vtkGetVector3Macro(BallDirection, double);
  vtkSetClampMacro(BallDepth, double, 0.0, 100.0);
  vtkGetMacro(BallDepth, double);
  ///@}
  ///@{ Number of parts into which each edge of the icosahedron is divided; default 20.
  vtkSetClampMacro(Frequency, int, 1, 200);
  vtkGetMacro(Frequency, int);
  ///@}

  void SetModulusConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetModulusData(vtkImageData* image);

protected:
  vtkElasticSurface();
  ~vtkElasticSurface() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

private:
  vtkElasticSurface(const vtkElasticSurface&) = delete;
  void operator=(const vtkElasticSurface&) = delete;

  struct Softened;
  bool Soften(vtkTable* table, vtkImageData* moduli);
  void Draw(vtkPolyData* output) const;

  double TissueModulus = 20.0;
  double PoissonRatio = 0.49;
  double SupportStiffness = 1.0;
  double FreeDirection[3] = {0.0, 1.0, 0.0};
  double FreeAngle = 0.0;
  int ElementsAcross = 16;
  double BallRadius = 8.0;
  double BallDirection[3] = {0.0, 1.0, 0.0};
  double BallDepth = 0.0;
  int Frequency = 20;
  std::unique_ptr<Softened> Made;
};

#endif
