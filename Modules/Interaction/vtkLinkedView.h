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
#include "vtkCrosshair.h"             // For what is shared
#include "vtkImageDisplay.h"
#include "vtkLandmarks.h"
#include "vtkObject.h"
#include "vtkProbeRepresentation.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

class vtkSurfaceDisplay;
namespace palpate
{
enum class LengthUnit;
}

class PALPATEINTERACTION_EXPORT vtkLinkedView : public vtkObject
{
public:
  vtkAbstractTypeMacro(vtkLinkedView, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The view's renderer. The view removes its props from the previous one. */
  void SetRenderer(vtkRenderer* renderer);
  vtkGetSmartPointerMacro(Renderer, vtkRenderer);
  ///@}

  ///@{
  /** Contents; null for none. */
  vtkSetSmartPointerMacro(ImageDisplay, vtkImageDisplay);
  vtkGetSmartPointerMacro(ImageDisplay, vtkImageDisplay);
  vtkSetSmartPointerMacro(Crosshair, vtkCrosshair);
  vtkGetSmartPointerMacro(Crosshair, vtkCrosshair);
  vtkSetSmartPointerMacro(Landmarks, vtkLandmarks);
  vtkGetSmartPointerMacro(Landmarks, vtkLandmarks);
  vtkSetSmartPointerMacro(Probe, vtkProbeRepresentation);
  vtkGetSmartPointerMacro(Probe, vtkProbeRepresentation);
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
  ///@{
  /** Shows lengths and positions in cm. Off by default: in mm. */
  vtkSetMacro(Centimeters, bool);
  vtkGetMacro(Centimeters, bool);
  vtkBooleanMacro(Centimeters, bool);
  ///@}

  /** Updates everything; called whenever the renderer draws. */
  void Update();

protected:
  vtkLinkedView() = default;
  /** Subclasses call SetRenderer(nullptr) in their destructors: their contents are gone when this
   * runs. */
  ~vtkLinkedView() override = default;

  palpate::LengthUnit UnitOfLength() const;

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
  bool Centimeters = false;
  vtkSmartPointer<vtkRenderer> Renderer;
  unsigned long Observer = 0;
  vtkSmartPointer<vtkImageDisplay> ImageDisplay;
  vtkSmartPointer<vtkCrosshair> Crosshair;
  vtkSmartPointer<vtkLandmarks> Landmarks;
  vtkSmartPointer<vtkProbeRepresentation> Probe;
};

#endif
