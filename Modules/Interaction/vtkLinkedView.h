/**
 * @class vtkLinkedView
 * @brief a view in a renderer whose contents are shared with other views
 *
 * Base of vtkSliceView and vtkSpaceView. Set a renderer of any render window, and the contents: a
 * volume with labels (vtkImageDisplay), surfaces (vtkSurfaceDisplay), landmarks, a haptic tool,
 * the point through which slices pass (vtkCrosshair). All of them may be shared with other views.
 * The view updates itself whenever the renderer draws, and updates only what changed.
 */
#ifndef vtkLinkedView_h
#define vtkLinkedView_h

#include "PalpateInteractionModule.h" // For export macro
#include "vtkObject.h"

#include <memory> // For what is shared

class vtkCrosshair;
class vtkImageDisplay;
class vtkLandmarks;
class vtkProbeRepresentation;
class vtkRenderer;
class vtkSurfaceDisplay;

class PALPATEINTERACTION_EXPORT vtkLinkedView : public vtkObject
{
public:
  vtkAbstractTypeMacro(vtkLinkedView, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The view's renderer. The view removes its props from the previous one. */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /** Contents; null for none. */
  virtual void SetImageDisplay(vtkImageDisplay* display);
  vtkImageDisplay* GetImageDisplay();
  void SetCrosshair(vtkCrosshair* crosshair);
  vtkCrosshair* GetCrosshair();
  void SetLandmarks(vtkLandmarks* landmarks);
  vtkLandmarks* GetLandmarks();
  void SetProbe(vtkProbeRepresentation* probe);
  vtkProbeRepresentation* GetProbe();
  virtual void AddSurface(vtkSurfaceDisplay* surface) = 0;
  virtual void RemoveSurface(vtkSurfaceDisplay* surface) = 0;
  ///@}

  ///@{
  /** Whether slices follow the volume's axes (the default) or the body's. */
  vtkSetMacro(AlongImage, bool);
  vtkGetMacro(AlongImage, bool);
  vtkBooleanMacro(AlongImage, bool);
  ///@}
  ///@{
  /** Text, letters and bars over the view. On by default. */
  vtkSetMacro(AnnotationVisibility, bool);
  vtkGetMacro(AnnotationVisibility, bool);
  vtkBooleanMacro(AnnotationVisibility, bool);
  ///@}

  /** Updates everything; called whenever the renderer draws. */
  void Update();

protected:
  vtkLinkedView();
  /** Subclasses call SetRenderer(nullptr) in their destructors: their contents are gone when this
   * runs. */
  ~vtkLinkedView() override;

  /** Adds the view's props to its renderer, and removes them. */
  virtual void AddTo(vtkRenderer* renderer) = 0;
  virtual void RemoveFrom(vtkRenderer* renderer) = 0;
  /** Updates the view for the renderer, which is not null. */
  virtual void UpdateFor(vtkRenderer* renderer) = 0;

private:
  vtkLinkedView(const vtkLinkedView&) = delete;
  void operator=(const vtkLinkedView&) = delete;

  bool AlongImage = true;
  bool AnnotationVisibility = true;

  struct Shared;
  std::unique_ptr<Shared> Given;
};

#endif
