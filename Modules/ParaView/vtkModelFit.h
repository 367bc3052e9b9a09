#ifndef vtkModelFit_h
#define vtkModelFit_h

#include "PalpateParaViewModule.h"
#include "vtkPolyDataAlgorithm.h"

/// Fits a spherical-harmonic model to one structure of a label map, as `palpate fit` does with the
/// same settings (palpate::FitStructure).
///
/// Input: an image of labels (unsigned char, unsigned short or int); origin, spacing (mm) and
/// direction are honoured. Output: the model's triangles in mm with analytic normals and the point
/// array "DistanceToSurface" (mm from the structure's surface, positive outside it); of a radial
/// model also "Residual" and "RadiusDeviation" (mm), of a surface model "NormalDeviation" (mm).
/// Field arrays: "Dice", "MeanDistance" and "MaximumDistance" (mm, from the mask's boundary),
/// "Volume" (ml), "Degree". A structure that cannot be fitted raises an error that says why, and
/// produces no output.
class PALPATEPARAVIEW_EXPORT vtkModelFit : public vtkPolyDataAlgorithm
{
public:
  static vtkModelFit* New();
  vtkTypeMacro(vtkModelFit, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Models
  {
    AUTOMATIC, ///< radial where the structure is star-shaped, else a surface
    RADIAL,
    SURFACE
  };

  ///@{ Value of the structure's voxels; default 1.
  vtkSetMacro(Label, int);
  vtkGetMacro(Label, int);
  ///@}
  ///@{ Kind of the model; default AUTOMATIC.
  vtkSetClampMacro(Model, int, AUTOMATIC, SURFACE);
  vtkGetMacro(Model, int);
  ///@}
  ///@{ Degree of the model; default 12.
  vtkSetClampMacro(Degree, int, 0, 60);
  vtkGetMacro(Degree, int);
  ///@}
  ///@{ Smoothing of the structure's surface, voxels; default 1.
  vtkSetClampMacro(Smoothing, double, 0.0, 10.0);
  vtkGetMacro(Smoothing, double);
  ///@}
  ///@{ Whether structures of parts, with handles or holes, are fitted too; default off.
  vtkSetMacro(Repairs, bool);
  vtkGetMacro(Repairs, bool);
  vtkBooleanMacro(Repairs, bool);
  ///@}

protected:
  vtkModelFit() = default;
  ~vtkModelFit() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

private:
  vtkModelFit(const vtkModelFit&) = delete;
  void operator=(const vtkModelFit&) = delete;

  int Label = 1;
  int Model = AUTOMATIC;
  int Degree = 12;
  double Smoothing = 1.0;
  bool Repairs = false;
};

#endif
