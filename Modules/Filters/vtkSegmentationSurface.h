#ifndef vtkSegmentationSurface_h
#define vtkSegmentationSurface_h

#include "PalpateFiltersModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <vector>

/// Extracts one label of a label map as a closed, oriented, two-manifold triangle surface.
///
/// Input: vtkImageData with one-component integer scalars; origin, spacing (mm) and direction
/// matrix are honoured. Output: triangles, points in world mm (double), outward orientation. A mask
/// that touches the image's border is closed there, about half a voxel outside the last voxel
/// centres, and GetTouchesBorder returns true. Cavities are filled. Raises an error and produces no
/// output if no voxel has the label, or the component does not exist.
///
/// SHAPE_INTERPOLATION treats the mask's steps between thick slices as a sampling artefact (see
/// palpate::MakeShapeField), and encloses the mask's volume to a part in a thousand. PLAIN is the
/// half level of the mask itself, for comparison. Arithmetic: palpate::MakeMaskSurface.
class PALPATEFILTERS_EXPORT vtkSegmentationSurface : public vtkPolyDataAlgorithm
{
public:
  static vtkSegmentationSurface* New();
  vtkTypeMacro(vtkSegmentationSurface, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    SHAPE_INTERPOLATION,
    PLAIN
  };

  ///@{ Value of the structure's voxels. Default 1.
  vtkSetMacro(Label, int);
  vtkGetMacro(Label, int);
  ///@}

  ///@{ SHAPE_INTERPOLATION (default) or PLAIN.
  vtkSetClampMacro(Method, int, SHAPE_INTERPOLATION, PLAIN);
  vtkGetMacro(Method, int);
  void SetMethodToShapeInterpolation() { this->SetMethod(SHAPE_INTERPOLATION); }
  void SetMethodToPlain() { this->SetMethod(PLAIN); }
  ///@}

  ///@{ Smoothing of the shape, in voxels (of thick slices: in their pixels): the field is blurred
  /// by
  /// a Gaussian of half this standard deviation. 0 for none; default 1. PLAIN is never smoothed.
  /// NaN counts as 0.
  void SetSmoothing(double smoothing);
  vtkGetMacro(Smoothing, double);
  ///@}

  ///@{ Coarsens the surface to about this many cells of the field's grid, each with two triangles;
  /// 0 (default) for the resolution of the voxels, which is never exceeded. Thin shapes keep up to
  /// six times as many. PLAIN is never coarsened.
  vtkSetClampMacro(CellsOnSurface, int, 0, 100000000);
  vtkGetMacro(CellsOnSurface, int);
  ///@}

  ///@{ Rank of the connected component (voxels that share faces) by size, from 1 for the largest. 0
  /// keeps all. Default 1.
  vtkSetClampMacro(Component, int, 0, VTK_INT_MAX);
  vtkGetMacro(Component, int);
  ///@}

  ///@{ Results of the last update. Volumes in mm^3. MaskVolume counts the voxels of the chosen
  /// component, SurfaceVolume is the volume that the output encloses (with cavities).
  vtkGetMacro(TouchesBorder, bool);
  vtkGetMacro(MaskVolume, double);
  vtkGetMacro(SurfaceVolume, double);
  vtkGetMacro(CavityCount, int);
  vtkGetMacro(CavityVolume, double);
  vtkGetMacro(LargestCavityVolume, double);
  int GetNumberOfComponents() const { return static_cast<int>(this->ComponentVolumes.size()); }
  double GetComponentVolume(int rank) const
  {
    return this->ComponentVolumes.at(static_cast<std::size_t>(rank));
  }
  ///@}

protected:
  vtkSegmentationSurface() = default;
  ~vtkSegmentationSurface() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputs,
                  vtkInformationVector* outputs) override;

private:
  vtkSegmentationSurface(const vtkSegmentationSurface&) = delete;
  void operator=(const vtkSegmentationSurface&) = delete;

  int Label = 1;
  int Method = SHAPE_INTERPOLATION;
  double Smoothing = 1.0;
  int CellsOnSurface = 0;
  int Component = 1;

  bool TouchesBorder = false;
  double MaskVolume = 0.0;
  double SurfaceVolume = 0.0;
  int CavityCount = 0;
  double CavityVolume = 0.0;
  double LargestCavityVolume = 0.0;
  std::vector<double> ComponentVolumes;
};

#endif
