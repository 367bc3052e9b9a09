#ifndef vtkSurfaceQuality_h
#define vtkSurfaceQuality_h

#include "PalpateFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

class vtkImageData;

/// Measures the agreement of one closed surface with another, and with a mask.
///
/// Port 0: the surface under test. Port 1: the reference surface. Port 2, optional: a label map for
/// the Dice coefficient. All in world mm; the label map's direction matrix is honoured. Output: the
/// surface under test with the point array "Distance" (mm, unsigned, to the reference).
///
/// The distances are symmetric: over the area of either surface to the nearest point of the other,
/// each direction with half of the weight (so that a rough surface does not weigh more for its
/// larger area). Mean, root mean square and percentile are of both directions together, within 1 %;
/// the maximum is the Hausdorff distance, over edges and faces too (palpate::SampleDistances). Dice
/// is computed on the label map's own grid: a voxel belongs to the surface if its centre lies
/// inside.
class PALPATEFILTERS_EXPORT vtkSurfaceQuality : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceQuality* New();
  vtkTypeMacro(vtkSurfaceQuality, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{ The other inputs.
  void SetReferenceConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetReferenceData(vtkPolyData* surface);
  void SetMaskConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(2, output); }
  void SetMaskData(vtkImageData* mask);
  ///@}

  ///@{ Value of the structure's voxels in the label map. Default 1.
  vtkSetMacro(Label, int);
  vtkGetMacro(Label, int);
  ///@}

  ///@{ Results of the last update: distances in mm, volumes in mm^3, areas in mm^2. Differences are
  /// the surface under test minus the reference. Dice is 0..1, and -1 without a mask.
  vtkGetMacro(MeanDistance, double);
  vtkGetMacro(RmsDistance, double);
  vtkGetMacro(Percentile95Distance, double);
  vtkGetMacro(MaximumDistance, double);
  vtkGetMacro(Volume, double);
  vtkGetMacro(VolumeDifference, double);
  vtkGetMacro(Area, double);
  vtkGetMacro(AreaDifference, double);
  vtkGetMacro(Dice, double);
  ///@}

protected:
  vtkSurfaceQuality() { this->SetNumberOfInputPorts(3); }
  ~vtkSurfaceQuality() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

private:
  vtkSurfaceQuality(const vtkSurfaceQuality&) = delete;
  void operator=(const vtkSurfaceQuality&) = delete;

  int Label = 1;
  double MeanDistance = 0.0;
  double RmsDistance = 0.0;
  double Percentile95Distance = 0.0;
  double MaximumDistance = 0.0;
  double Volume = 0.0;
  double VolumeDifference = 0.0;
  double Area = 0.0;
  double AreaDifference = 0.0;
  double Dice = -1.0;
};

#endif
