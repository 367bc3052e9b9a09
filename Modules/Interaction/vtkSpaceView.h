/**
 * @class vtkSpaceView
 * @brief a 3D view in a renderer, linked to slice views
 *
 * Shows surfaces, plain or coloured by an array with a colour bar; the slices of the volume through
 * the shared vtkCrosshair; a haptic tool with its force and contact. For contents and links see
 * vtkLinkedView. Add other props, such as a vtkSubVoxelVolume, to the renderer itself.
 *
 * Three white lights follow the camera; no surface burns out. Texts and outlines are light or dark,
 * by the renderer's background. Several translucent surfaces are blended in the order of their
 * depths.
 *
 * The camera is the renderer's: any interactor style may move it. At first, and after LookFrom, it
 * shows everything.
 */
#ifndef vtkSpaceView_h
#define vtkSpaceView_h

#include "PalpateInteractionModule.h" // For export macro
#include "vtkLinkedView.h"

#include <memory> // For what is drawn

class PALPATEINTERACTION_EXPORT vtkSpaceView : public vtkLinkedView
{
public:
  static vtkSpaceView* New();
  vtkTypeMacro(vtkSpaceView, vtkLinkedView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Sides
  {
    ANTERIOR,
    POSTERIOR,
    LEFT,
    RIGHT,
    SUPERIOR,
    INFERIOR
  };

  void AddSurface(vtkSurfaceDisplay* surface) override;
  void RemoveSurface(vtkSurfaceDisplay* surface) override;

  /** Whether a slice is shown; orientations as in vtkSliceView. All are shown by default. */
  void SetSliceVisibility(int orientation, bool visibility);

  ///@{
  /** Smooth edges of surfaces (FXAA; text is smooth anyway). Off by default. */
  vtkSetMacro(Antialiasing, bool);
  vtkGetMacro(Antialiasing, bool);
  vtkBooleanMacro(Antialiasing, bool);
  ///@}
  ///@{
  /** Darkens clefts and places where surfaces meet, within a tenth of the scene's size
   * (screen-space ambient occlusion). Off by default. Volumes have none, so nothing has where there
   * is one. */
  vtkSetMacro(AmbientOcclusion, bool);
  vtkGetMacro(AmbientOcclusion, bool);
  vtkBooleanMacro(AmbientOcclusion, bool);
  ///@}

  ///@{
  /** Whether a next frame comes soon: it is drawn without smooth edges and ambient occlusion. Off
   * by default. */
  vtkSetMacro(Moving, bool);
  vtkGetMacro(Moving, bool);
  vtkBooleanMacro(Moving, bool);
  ///@}

  ///@{
  /** A soft shadow of the tool on surfaces near it, as of a sphere of the tool's radius under an
   * even sky. On by default. Sub-voxel volumes have none. */
  vtkSetMacro(ToolShadow, bool);
  vtkGetMacro(ToolShadow, bool);
  vtkBooleanMacro(ToolShadow, bool);
  ///@}

  /** Shows everything from a side of the patient; see palpate::FrameOf for the up direction. */
  void LookFrom(int side);
  /** Shows everything from the camera's current direction. */
  void ResetCamera();
  /** Whether the camera is among what it shows, where it sees little of it. */
  bool IsCameraInside();

  /**
   * The nearest point (world, mm) of a surface, a slice or a sub-voxel volume at a position of the
   * window in pixels. Returns false if there is none. It is a point of the surface, not of the
   * depth buffer.
   */
  bool Pick(double x, double y, double world[3]);
  /** The same, which returns what the point belongs to: a vtkSurfaceDisplay, a vtkVolume, or the
   * vtkImageDisplay of a slice; null if there is none. */
  vtkObject* PickObject(double x, double y, double world[3]);

protected:
  vtkSpaceView();
  ~vtkSpaceView() override;

  void AddTo(vtkRenderer* renderer) override;
  void RemoveFrom(vtkRenderer* renderer) override;
  void UpdateFor(vtkRenderer* renderer) override;

private:
  vtkSpaceView(const vtkSpaceView&) = delete;
  void operator=(const vtkSpaceView&) = delete;

  void UpdateContents();
  void UpdateAnnotation(vtkRenderer* renderer);
  void UpdateQuality(vtkRenderer* renderer);

  bool Antialiasing = false;
  bool AmbientOcclusion = false;
  bool Moving = false;
  bool ToolShadow = true;
  struct State;
  std::unique_ptr<State> Inner;
};

#endif
